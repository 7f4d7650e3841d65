/* SPDX-License-Identifier: MIT
 * common/engine_share.c - the winners of an engine's last frames. */
#include "engine_share.h"

#include <stdlib.h>
#include <string.h>

int engine_share_open(engine_share *s, const stad_geometry *g, int count, tool_fail *f)
{
    const size_t bytes = stad_winners_bytes(g);
    memset(s, 0, sizeof *s);
    s->last = -1;
    if (count == 0)
        return TOOL_OK;
    s->set = calloc((size_t)count, sizeof *s->set);
    for (; s->set && s->count < count; s->count++) {
        void *memory = malloc(bytes);
        if (!memory)
            break;
        stad_winners_init(&s->set[s->count].of, g, memory, bytes);
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
        free(s->set[i].of.memory);
    free(s->set);
    memset(s, 0, sizeof *s);
}

const stad_winners *engine_share_find(engine_share *s, const stad_params *p)
{
    for (int i = 0; i < s->filled; i++)
        if (stad_winners_serve(&s->set[i].of, p)) {
            s->last = i;
            s->served++;
            return &s->set[i].of;
        }
    return NULL;
}

static int worst_of(const engine_share *s)
{
    int worst = 0;
    for (int i = 1; i < s->count; i++)
        if (s->set[i].cost > s->set[worst].cost)
            worst = i;
    return worst;
}

stad_winners *engine_share_next(engine_share *s)
{
    if (s->count == 0)
        return NULL;
    s->last = s->filled < s->count ? s->filled++ : worst_of(s);
    s->set[s->last].cost = STAD_COST_FAILED;
    return &s->set[s->last].of;
}

void engine_share_judge(engine_share *s, int32_t cost)
{
    if (s->last >= 0 && s->last < s->count && cost < s->set[s->last].cost)
        s->set[s->last].cost = cost;
}
