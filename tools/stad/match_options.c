/* SPDX-License-Identifier: MIT
 * stad/match_options.c - the options that say how to match, shared by every command that matches. */
#include "match_options.h"

#include <stdio.h>
#include <string.h>

void match_options_init(match_options *o)
{
    memset(o, 0, sizeof *o);
    params_some_init(&o->some);
    o->memory = STAD_MEMORY_FAST;
}

static int take_mode(match_options *o, const char *name, tool_fail *f)
{
    o->some.mode = params_mode_of(name);
    if (o->some.mode < 0)
        return tool_fail_set(f, TOOL_USAGE, "--mode %s: must be sgbm, hh, 3way or hh4", name);
    return TOOL_OK;
}

static int take_memory(match_options *o, const char *name, tool_fail *f)
{
    if (strcmp(name, "fast") != 0 && strcmp(name, "small") != 0)
        return tool_fail_set(f, TOOL_USAGE, "--memory %s: must be fast or small", name);
    o->memory = name[0] == 'f' ? STAD_MEMORY_FAST : STAD_MEMORY_SMALL;
    return TOOL_OK;
}

static int take_channels(match_options *o, int code, tool_fail *f)
{
    *(code == OPT_COLOR ? &o->color : &o->gray) = 1;
    if (o->color && o->gray)
        return tool_fail_set(f, TOOL_USAGE, "--color and --gray: one of them, not both");
    return TOOL_OK;
}

int match_options_take(match_options *o, int code, const char *argument, int *mine, tool_fail *f)
{
    *mine = 1;
    if (code >= OPT_FIELD && code < OPT_FIELD + FIELD_COUNT)
        return params_some_set(&o->some, code - OPT_FIELD, argument, f);
    switch (code) {
    case OPT_MODE:
        return take_mode(o, argument, f);
    case OPT_MEMORY:
        return take_memory(o, argument, f);
    case OPT_PARAMS:
        o->params_path = argument;
        return TOOL_OK;
    case OPT_COLOR:
    case OPT_GRAY:
        return take_channels(o, code, f);
    default:
        *mine = 0;
        return TOOL_OK;
    }
}

int match_options_file(match_options *o, tool_fail *f)
{
    params_some file;
    if (!o->params_path)
        return TOOL_OK;
    int status = params_read_json(&file, o->params_path, f);
    if (status)
        return status;
    if (file.corrected)
        fprintf(stderr, "stad: %s: these parameters are for a corrected right view; the correction is not applied\n",
                o->params_path);
    params_some_merge(&file, &o->some);
    o->some = file;
    return TOOL_OK;
}

int match_options_mode(const match_options *o)
{
    return o->some.mode < 0 ? STAD_MODE_SGBM : o->some.mode;
}

int match_options_params(const match_options *o, int width, int channels, stad_params *p, tool_fail *f)
{
    params_from_some(p, &o->some, width, channels);
    return params_check_text(p, &o->some, match_options_mode(o), width, f);
}
