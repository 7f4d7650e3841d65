/* SPDX-License-Identifier: MIT
 * common/engine_share.h - the winners of an engine's last frames, for an engine that matches one pair again and again. */
#ifndef TOOL_ENGINE_SHARE_H
#define TOOL_ENGINE_SHARE_H

#include "fail.h"
#include "stad/cost.h"
#include "stad/winners.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A frame's winners and the least cost that they were scored with. */
typedef struct engine_winners {
    stad_winners of;
    int32_t cost; /* STAD_COST_FAILED until the frame is judged */
} engine_winners;

/* A search asks for more points around the best it has met, so the worst gives way. */
typedef struct engine_share {
    engine_winners *set;
    int count, filled;
    int last;    /* the one that the last frame left or was made from, -1 = none */
    long served; /* frames that needed no matching */
} engine_share;

/* Takes memory for the winners of `count` frames, 0 for none. */
int engine_share_open(engine_share *s, const stad_geometry *g, int count, tool_fail *f);
void engine_share_close(engine_share *s);

/* Winners that serve these parameters, or NULL. */
const stad_winners *engine_share_find(engine_share *s, const stad_params *p);

/* Where the next frame's winners go, or NULL. */
stad_winners *engine_share_next(engine_share *s);

/* What the last frame's score was. */
void engine_share_judge(engine_share *s, int32_t cost);

#ifdef __cplusplus
}
#endif

#endif
