/* SPDX-License-Identifier: MIT
 * stad/scene_folder.c - is a folder free for what `stad scene` is about to write? */
#include "scene_folder.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The number in front of "_left.png" and its like; -1: a name of a single pair; -2: no name of a scene at all. *rest: the name
 * without number. */
static int frame_of(const char *name, const char **rest)
{
    static const char *const words[] = {"left.png", "right.png", "left.pgm", "right.pgm", "disp.pfm", "nonocc.png"};
    int numbered =
        isdigit((unsigned char)name[0]) && isdigit((unsigned char)name[1]) && isdigit((unsigned char)name[2]) && name[3] == '_';
    *rest = numbered ? name + 4 : name;
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        if (strcmp(*rest, words[i]) == 0)
            return numbered ? atoi(name) : -1;
    return -2;
}

/* Will a file of this name be written? */
static int is_expected(int frame, const char *rest, int frames, int pgm)
{
    int view = rest[0] == 'l' || rest[0] == 'r', is_pgm = strstr(rest, ".pgm") != NULL;
    return (frames > 0 ? frame >= 0 && frame < frames : frame == -1) && (!view || is_pgm == pgm);
}

int scene_folder_check(const char *folder, int frames, int pgm, tool_fail *f)
{
    DIR *d = opendir(folder);
    const struct dirent *e;
    const char *rest;
    int status = TOOL_OK;
    if (!d)
        return tool_fail_set(f, TOOL_FILE, "%s: cannot be written: %s", folder, strerror(errno));
    while (status == TOOL_OK && (e = readdir(d)) != NULL) {
        int frame = frame_of(e->d_name, &rest);
        if (frame >= -1 && !is_expected(frame, rest, frames, pgm))
            status = tool_fail_set(f, TOOL_FILE,
                                   "%s: holds %s of another scene, which would stay among the new files: "
                                   "give another folder, or empty this one",
                                   folder, e->d_name);
    }
    closedir(d);
    return status;
}
