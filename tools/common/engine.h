/* SPDX-License-Identifier: MIT
 * common/engine.h - a matcher with memory of its own, for tools that have a heap. */
#ifndef TOOL_ENGINE_H
#define TOOL_ENGINE_H

#include "disparity_file.h"
#include "engine_share.h"
#include "fail.h"
#include "picture.h"
#include "stad/match.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct engine {
    stad_geometry geometry;
    stad_match match;
    void *work, *speckle;
    size_t work_bytes, speckle_bytes;
    engine_share share; /* of one pair of images */
} engine;

/* What a run can give beside the disparities; each may be NULL. */
typedef struct engine_extras {
    picture *confidence; /* allocated by the run */
    disparity *right;
} engine_extras;

/* The geometry that just holds these parameters. */
stad_geometry engine_geometry(const stad_params *p, int mode, int memory, int width, int height, int channels);

/* Takes the memory. The geometry is refused (TOOL_USAGE) with the field's name when the library refuses it. */
int engine_open(engine *e, const stad_geometry *g, tool_fail *f);
void engine_close(engine *e);

/* From now on the engine sees one pair of images only, and keeps the winners of its last `count` frames: a run whose parameters
 * differ from one of theirs in what is decided after the winners needs no matching. */
int engine_keep(engine *e, int count, tool_fail *f);

/* Matches a frame into *d, which the run allocates when d->q4 is NULL. */
int engine_run(engine *e, const stad_params *p, const picture *left, const picture *right, disparity *d,
               const engine_extras *extras, tool_fail *f);

/* Two pictures of the same size, or a message that names both files. */
int engine_read_pair(picture *left, picture *right, const char *left_path, const char *right_path, int color, tool_fail *f);

#ifdef __cplusplus
}
#endif

#endif
