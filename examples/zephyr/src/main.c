/* SPDX-License-Identifier: MIT
 * examples/zephyr/src/main.c - matches one made-up frame by rows and prints the share of pixels with a disparity. */
#include <zephyr/kernel.h>

#include "../../one_frame.h"

int main(void)
{
    stad_match_counts counts;
    const int status = match_one_frame(&counts);
    printk("%s: %d of %d pixels\n", stad_status_name(status), (int)counts.valid, (int)counts.considered);
    return 0;
}
