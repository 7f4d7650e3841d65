/* SPDX-License-Identifier: MIT
 * test/target/kernels.c - every kernel of the port against plain C, on the target itself.
 *
 * Random cases, extremes often; outputs lie between guards. A kernel that the port leaves to C is said to be so. Ends with 0
 * only when all agree. */
#include <string.h>

#include "board.h"
#include "kernel/kernel.h"
#include "kernels.h"
#include "say.h"

enum { CASES = 200 };

typedef void (*any)(void);
typedef struct check {
    const char *name;
    int (*run)(void);
    int is_c; /* the port leaves this one to C */
} check;
#define CHECK(kernel, run) {#kernel, run, (any)stad_##kernel == (any)stad_##kernel##_c}

static const check *checks(int *count)
{
    static check all[19];
    const check here[] = {
        CHECK(prefilter_row, case_prefilter), CHECK(range_row, case_range),           CHECK(cost_row_u8, case_cost_u8),
        CHECK(cost_row_u16, case_cost_u16),   CHECK(box_add_row_u8, case_box_add_u8), CHECK(box_add_row_u16, case_box_add_u16),
        CHECK(block_row, case_block),         CHECK(slide_row, case_slide),           CHECK(path_row, case_path),
        CHECK(path_row_sat, case_path_sat),   CHECK(path_row_u8, case_path_u8),       CHECK(gather_row, case_gather),
        CHECK(best_row, case_best),           CHECK(best_row_3way, case_best_3way),   CHECK(refine_row, case_refine),
        CHECK(select_row, case_select),       CHECK(check_row, case_check),           CHECK(median_row, case_median),
        CHECK(box_sat_row, case_box_sat)};
    *count = (int)(sizeof here / sizeof here[0]);
    memcpy(all, here, sizeof here);
    return all;
}

static int kernel_agrees(const check *c)
{
    uint32_t seed;
    for (seed = 1; seed <= CASES; seed++) {
        prepare(seed);
        if (!c->run()) {
            say(c->name);
            say(": DIFFERS from C, seed ");
            say_dec((int32_t)seed);
            say("\n");
            return 0;
        }
    }
    say(c->name);
    say(c->is_c ? ": C\n" : ": ok\n");
    return 1;
}

int main(void)
{
    int count, i, good = 0, own = 0;
    const check *all = checks(&count);
    for (i = 0; i < count; i++) {
        good += kernel_agrees(&all[i]);
        own += !all[i].is_c;
    }
    say("sum: ");
    say_dec(own);
    say(" kernels of the port, ");
    say_dec(count - own);
    say(good == count ? " left to C\ndone\n" : " left to C, NOT ALL AGREE\nfailed\n");
    return good == count ? 0 : 1;
}
