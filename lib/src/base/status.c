/* SPDX-License-Identifier: MIT
 * base/status.c - status codes as text. */
#include "stad/status.h"

const char *stad_status_name(int status)
{
    static const char *const names[] = {"STAD_OK",      "STAD_AGAIN",     "STAD_E_PARAM",   "STAD_E_SIZE", "STAD_E_STATE",
                                        "STAD_E_LIMIT", "STAD_E_CORRUPT", "STAD_E_NO_MARK", "STAD_E_RIG"};
    const int count = (int)(sizeof names / sizeof names[0]);
    if (status >= 0)
        return names[0];
    return status > -count ? names[-status] : "STAD_E_UNKNOWN";
}
