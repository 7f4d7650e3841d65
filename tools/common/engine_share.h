/* SPDX-License-Identifier: MIT
 * common/engine_share.h - the winners of an engine's last frames, for an engine that matches one pair again and again. */
#ifndef TOOL_ENGINE_SHARE_H
#define TOOL_ENGINE_SHARE_H

#include "fail.h"
#include "stad/winners.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The least recently used gives way. */
typedef struct engine_share {
    stad_winners *set;
    long *used; /* when, by `clock`; 0 = never */
    int count;
    long clock;
    long served; /* frames that needed no matching */
} engine_share;

/* Takes memory for the winners of `count` frames, 0 for none. */
int engine_share_open(engine_share *s, const stad_geometry *g, int count, tool_fail *f);
void engine_share_close(engine_share *s);

/* Winners that serve these parameters, or NULL. */
const stad_winners *engine_share_find(engine_share *s, const stad_params *p);

/* Where the next frame's winners go, or NULL. */
stad_winners *engine_share_next(engine_share *s);

#ifdef __cplusplus
}
#endif

#endif
