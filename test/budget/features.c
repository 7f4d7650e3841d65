/* SPDX-License-Identifier: MIT
 * test/budget/features.c - the calls a firmware makes of each feature, a function each.
 *
 * Linked with one of them as the entry and unreferenced sections dropped, then sized; it never runs. Arguments come from a
 * volatile, so that nothing is known of them. */
#include "stad/calib.h"
#include "stad/stad.h"
#include "stad/tune.h"

static void *volatile any;
static volatile int sink;

void feature_match(void);
void feature_tune(void);
void feature_mark(void);
void feature_monitor(void);
void feature_store(void);
void feature_match_tune(void);
void feature_chain(void);

void feature_match(void)
{
    sink = stad_match_init(any, any, any, (size_t)sink);
    sink = stad_match_begin(any, any);
    sink = stad_match_push(any, any, any);
    sink = stad_match_pull(any, any);
    sink = stad_match_counts_of(any)->firm;
}

void feature_tune(void)
{
    stad_score_config_init(any, sink, sink, sink);
    sink = stad_score_begin(any, any);
    stad_score_row(any, sink, any, any, any, sink);
    sink = stad_score_end(any);
    stad_tune_config_stereo(any, sink);
    sink = stad_tune_descent_init(any, any, any);
    sink = stad_tune_ask(any, any);
    sink = stad_tune_descent_tell(any, sink);
    sink = stad_tune_best(any, any, any);
}

void feature_mark(void)
{
    sink = stad_mark_find(any, any, any, sink, any, (size_t)sink);
    sink = stad_mark_pair(any, sink, any, sink, any, sink);
}

void feature_monitor(void)
{
    sink = stad_monitor_init(any, any);
    sink = stad_monitor_frame(any, any);
    sink = stad_monitor_look_due(any);
}

void feature_store(void)
{
    sink = stad_store_load(any, any);
    sink = stad_store_save(any, any);
}

void feature_match_tune(void)
{
    feature_match();
    feature_tune();
}

void feature_chain(void)
{
    feature_match();
    feature_store();
    sink = stad_calib_init(any, any, any);
    sink = stad_calib_live(any, any, any);
    sink = stad_calib_counts(any, any);
    sink = stad_calib_want(any, any);
    sink = stad_calib_frame(any, any, any, any, (size_t)sink);
    sink = stad_calib_evaluate(any, any, any, any, any, any, (size_t)sink);
    sink = stad_calib_cost(any, sink);
    sink = stad_calib_saved(any, sink);
}
