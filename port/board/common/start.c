/* SPDX-License-Identifier: MIT
 * board/common/start.c - reset (by core family) -> [START] -> main
 *
 * The same for every core: the linker script (sections.ld) names the regions. */
#include "start.h"

#include <stdint.h>

#include "../board.h"

static const uint32_t paint = 0x5ac3b7d1;
enum { MARGIN = 256 }; /* bytes below the frame of board_start that may be in use */

extern uint32_t data_load[], data_start[], data_end[], bss_start[], bss_end[], stack_bottom[], stack_top[];

void board_start(void)
{
    const uint32_t *from = data_load;
    uint32_t *to, *in_use = (uint32_t *)((uintptr_t)__builtin_frame_address(0) - MARGIN);
    for (to = data_start; to < data_end; to++)
        *to = *from++;
    for (to = bss_start; to < bss_end; to++)
        *to = 0;
    for (to = stack_bottom; to < in_use; to++)
        *to = paint;
    board_exit(main());
}

size_t board_stack_used(void)
{
    const uint32_t *top = stack_bottom;
    while (top < stack_top && *top == paint)
        top++;
    return (size_t)(stack_top - top) * sizeof *top;
}
