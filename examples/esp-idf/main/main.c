/* SPDX-License-Identifier: MIT
 * examples/esp-idf/main/main.c - matches one made-up frame by rows and prints the share of pixels with a disparity. */
#include <stdio.h>

#include "../../one_frame.h"

void app_main(void);
void app_main(void)
{
    stad_match_counts counts;
    const int status = match_one_frame(&counts);
    printf("%s: %d of %d pixels\n", stad_status_name(status), (int)counts.valid, (int)counts.considered);
}
