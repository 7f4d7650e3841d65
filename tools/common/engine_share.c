/* SPDX-License-Identifier: MIT
 * common/engine_share.c - the winners of an engine's last frames. */
#include "engine_share.h"

#include <stdlib.h>
#include <string.h>

int engine_share_open(engine_share *s, const stad_geometry *g, int count, tool_fail *f)
{
    const size_t bytes = stad_winners_bytes(g);
    memset(s, 0, sizeof *s);
    if (count == 0)
        return TOOL_OK;
    s->set = calloc((size_t)count, sizeof *s->set);
    s->used = calloc((size_t)count, sizeof *s->used);
    for (; s->set && s->used && s->count < count; s->count++) {
        void *memory = malloc(bytes);
        if (!memory)
            break;
        stad_winners_init(&s->set[s->count], g, memory, bytes);
    }
    if (s->count == count)
        return TOOL_OK;
    engine_share_close(s);
    return tool_fail_set(f, TOOL_FILE, "not enough memory: the winners of %d frames need %zu bytes", count,
                         (size_t)count * bytes);
}

void engine_share_close(engine_share *s)
{
    for (int i = 0; i < s->count; i++)
        free(s->set[i].memory);
    free(s->set);
    free(s->used);
    memset(s, 0, sizeof *s);
}

const stad_winners *engine_share_find(engine_share *s, const stad_params *p)
{
    for (int i = 0; i < s->count; i++)
        if (stad_winners_serve(&s->set[i], p)) {
            s->used[i] = ++s->clock;
            s->served++;
            return &s->set[i];
        }
    return NULL;
}

stad_winners *engine_share_next(engine_share *s)
{
    int oldest = 0;
    if (s->count == 0)
        return NULL;
    for (int i = 1; i < s->count; i++)
        if (s->used[i] < s->used[oldest])
            oldest = i;
    s->used[oldest] = ++s->clock;
    return &s->set[oldest];
}
