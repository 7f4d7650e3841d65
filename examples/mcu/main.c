/* SPDX-License-Identifier: MIT
 * examples/mcu/main.c - the firmware: one source for every board of port/board and for the host. */
#include "board.h"
#include "stad/stad.h"

int main(void)
{
    board_print("stadimeter " STAD_VERSION " ");
    board_print(stad_status_name(STAD_E_PARAM));
    board_print("\ndone\n");
    return 0;
}
