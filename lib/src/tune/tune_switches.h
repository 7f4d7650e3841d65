/* SPDX-License-Identifier: MIT
 * tune/tune_switches.h - what the ablation of docs/TUNING.md leaves out, one at a time: -DTUNE_BETA=0 and so on. */
#ifndef STAD_TUNE_SWITCHES_H
#define STAD_TUNE_SWITCHES_H

#ifndef TUNE_BETA
#    define TUNE_BETA 1 /* PR+; 0: the scaled steepest way alone */
#endif
#ifndef TUNE_SCALING
#    define TUNE_SCALING 1 /* curvature as preconditioner */
#endif
#ifndef TUNE_JOINT
#    define TUNE_JOINT 1 /* the joint step after a sweep */
#endif
#ifndef TUNE_FOLLOW
#    define TUNE_FOLLOW 1 /* going on along an iteration's way */
#endif
#ifndef TUNE_POLLS
#    define TUNE_POLLS 1 /* polls of the discrete axes */
#endif

#endif
