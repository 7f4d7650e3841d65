/* SPDX-License-Identifier: MIT
 * common/calib_names.c - states, phases, outcomes, faults and verdicts of the loop in words. */
#include "calib_names.h"

#define NAME_OF(list, i) ((i) >= 0 && (i) < (int)(sizeof(list) / sizeof(list)[0]) ? (list)[i] : "?")

const char *calib_state_name(int state)
{
    static const char *const names[] = {"learning", "ok", "degraded"};
    return NAME_OF(names, state);
}

const char *calib_phase_name(int phase)
{
    static const char *const names[] = {"idle",  "look", "other",     "confirm", "pick",   "tune",
                                        "judge", "save", "probation", "recheck", "compare"};
    return NAME_OF(names, phase);
}

const char *calib_outcome_name(int outcome)
{
    static const char *const names[] = {"none",     "sound",   "adopted",    "corrected", "kept",     "rolled back",
                                        "no marks", "no pose", "rig failed", "fault",     "cancelled"};
    return NAME_OF(names, outcome);
}

const char *calib_fault_name(int fault)
{
    static const char *const names[] = {"none",  "late", "black", "saturated", "flat",   "frozen", "swapped", "marks",
                                        "range", "rig",  "size",  "camera",    "moving", "same",   "match"};
    return NAME_OF(names, fault);
}

const char *calib_verdict_name(int verdict)
{
    static const char *const names[] = {"good", "watch", "correct", "fail"};
    return NAME_OF(names, verdict);
}
