/* SPDX-License-Identifier: MIT
 * stad/stad.h - everything public. */
#ifndef STAD_STAD_H
#define STAD_STAD_H

#include "stad/calib.h"
#include "stad/config.h"
#include "stad/cost.h"
#include "stad/depth.h"
#include "stad/image.h"
#include "stad/mark.h"
#include "stad/match.h"
#include "stad/monitor.h"
#include "stad/params.h"
#include "stad/rig.h"
#include "stad/score.h"
#include "stad/status.h"
#include "stad/store.h"
#include "stad/target.h"
#include "stad/truth.h"
#include "stad/tune.h"
#include "stad/winners.h"

#endif
