/* SPDX-License-Identifier: MIT
 * common/calib_names.h - what the loop says of itself, in words: the same in every tool. "?" for a number without one. */
#ifndef TOOL_CALIB_NAMES_H
#define TOOL_CALIB_NAMES_H

const char *calib_state_name(int state);     /* enum stad_monitor_state */
const char *calib_phase_name(int phase);     /* enum stad_calib_phase */
const char *calib_outcome_name(int outcome); /* enum stad_calib_outcome */
const char *calib_fault_name(int fault);     /* enum stad_calib_fault */
const char *calib_verdict_name(int verdict); /* enum stad_rig_verdict */

#endif
