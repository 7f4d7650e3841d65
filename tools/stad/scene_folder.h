/* SPDX-License-Identifier: MIT
 * stad/scene_folder.h - is a folder free for what `stad scene` is about to write? */
#ifndef STAD_SCENE_FOLDER_H
#define STAD_SCENE_FOLDER_H

#include "../common/fail.h"

/* A recording of so many frames, or one pair (frames 0), may go where there is nothing of another: every file there that is named
 * like one of a scene must be one that will be written. TOOL_FILE otherwise, and when `folder` is none. */
int scene_folder_check(const char *folder, int frames, int pgm, tool_fail *f);

#endif
