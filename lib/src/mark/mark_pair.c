/* SPDX-License-Identifier: MIT
 * find marks -> [mark/mark_pair.c] -> rig, truth - joins the two views by identity. */
#include "stad/mark.h"

/* The only mark of that identity, or NULL. */
static const stad_mark *only(const stad_mark *marks, int count, int16_t id)
{
    const stad_mark *found = NULL;
    for (int i = 0; i < count; i++) {
        if (marks[i].id != id)
            continue;
        if (found)
            return NULL;
        found = &marks[i];
    }
    return found;
}

int stad_mark_pair(const stad_mark *left, int left_count, const stad_mark *right, int right_count, stad_pair *out, int max)
{
    int count = 0;
    for (int i = 0; i < left_count && count < max; i++) {
        const stad_mark *l = only(left, left_count, left[i].id);
        const stad_mark *r = only(right, right_count, left[i].id);
        if (!l || !r)
            continue;
        out[count].id = l->id;
        for (int k = 0; k < 4; k++) {
            out[count].left[k] = l->corner[k];
            out[count].right[k] = r->corner[k];
        }
        count++;
    }
    return count;
}
