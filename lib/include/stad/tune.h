/* SPDX-License-Identifier: MIT
 * stad/tune.h - finds the integer point of least cost, by nonlinear conjugate gradient; knows nothing of images.
 *
 * Ask and tell: the tuner never calls anything. The application asks for a point, scores it however it likes, and tells the
 * cost; every turn is one evaluation, so a control loop can breathe in between.
 *
 *     stad_tune_config_stereo(&config, STAD_TUNE_FOR_BAD);
 *     stad_tune_init(&tune, &config, &start);
 *     while (stad_tune_ask(&tune, &x) == 1)
 *         stad_tune_tell(&tune, cost_of(&x));
 *     stad_tune_best(&tune, &x, &cost);
 *
 * The state is the log of points and costs: a struct of at most 4 KiB without a pointer in it. Copy it, keep it in flash, go on
 * after a reset, once stad_tune_check() has found it whole. Only integers are used, so the same costs give the same points, bit for
 * bit, on every compiler and core. No point is ever asked for twice: what the method visits again is answered from the log.
 * Memory: the caller owns the struct; there is nothing to free. Re-entrant. How the methods work: docs/TUNING.md. */
#ifndef STAD_TUNE_H
#define STAD_TUNE_H

#include <stdint.h>

#include "stad/cost.h"
#include "stad/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Largest budget: distinct evaluations that the log holds. */
#define STAD_TUNE_LOG 240

/* The coordinates of a point. In another problem than stereo they are just six integers (see stad_tune_scale). */
enum stad_tune_dim {
    STAD_TUNE_P1 = 0,
    STAD_TUNE_P2 = 1,
    STAD_TUNE_BLOCK_SIZE = 2,
    STAD_TUNE_UNIQUENESS_RATIO = 3,
    STAD_TUNE_PRE_FILTER_CAP = 4,
    STAD_TUNE_DISP12_MAX_DIFF = 5
};
#define STAD_TUNE_DIMS 6 /* coordinates */

/* Farthest that a LINEAR coordinate reaches from zero, in units: differences of coordinates fit 32 bits in steps of 1 / 65536. */
#define STAD_TUNE_UNITS 8192

/* A point. */
typedef struct stad_point {
    int16_t v[STAD_TUNE_DIMS]; /* by enum stad_tune_dim */
} stad_point;

/* The search. */
enum stad_tune_method {
    STAD_TUNE_NCG = 0,       /* swept lattice conjugate gradient: the one to use */
    STAD_TUNE_NCG_PAPER = 1, /* nonlinear conjugate gradient as the literature writes it: for comparison */
    STAD_TUNE_SD = 2,        /* steepest descent, otherwise as NCG_PAPER */
    STAD_TUNE_HYBRID = 3,    /* a coarse random search, then NCG from its best */
    STAD_TUNE_DESCENT = 4    /* NCG until it has converged: the same points, then it ends. Least code: for firmware */
};

/* How a coordinate is walked. */
enum stad_tune_scale {
    STAD_TUNE_LINEAR = 0, /* continuous: one step is `unit` */
    STAD_TUNE_LOG2 = 1,   /* continuous: one step is an octave */
    STAD_TUNE_AREA = 2,   /* as LOG2, relative to the block: v / block_size^1.5 is held when the block changes */
    STAD_TUNE_ODD = 3,    /* discrete: odd numbers, polled one to either side */
    STAD_TUNE_POWER = 4   /* discrete: polled at twice and half its value; from a power of two to powers of two */
};

/* A coordinate's range and steps. Of LOG2 and AREA only lo, lo + unit, lo + 2 unit, ... are asked for, but for a p2 that `ordered`
 * puts one above p1. */
typedef struct stad_tune_axis {
    int16_t lo, hi; /* inclusive; lo >= 1 for all but LINEAR; LINEAR: within STAD_TUNE_UNITS units of zero */
    int16_t unit;   /* >= 1. LINEAR: integers per step; LOG2 and AREA: from one value to the next */
    uint8_t scale;  /* enum stad_tune_scale */
    int8_t side;    /* +1 or -1: where to look first */
} stad_tune_axis;

#define STAD_TUNE_LADDER 6 /* rungs at most */

/* What a tuner is told. Start from stad_tune_config_stereo().
 *
 * ordered: p2 is kept above p1, as stereo wants, and by the descents, where both may move, at about sqrt(2) * p1 or more.
 * cheap_mask: bit i set: a point that moves coordinate i alone costs the application next to nothing (stad/winners.h). NCG, DESCENT
 * and HYBRID then settle these coordinates at once wherever they get to. Its bits beyond the coordinates mean nothing. */
typedef struct stad_tune_config {
    uint8_t method;       /* enum stad_tune_method */
    uint8_t free_mask;    /* bit i set: coordinate i is free; the others keep the value of the start */
    uint8_t ordered;      /* not 0: p2 above p1; 0: independent */
    uint8_t ladder_count; /* 0..STAD_TUNE_LADDER */
    int16_t budget;       /* distinct evaluations, 1..STAD_TUNE_LOG */
    uint8_t patience;     /* 0: on to the budget, or until nothing new comes; else: stop when the first descent has converged */
    uint8_t cheap_mask;   /* 0: none, the default */
    uint32_t seed;        /* of the draws of HYBRID, and of the crosses that end NCG and HYBRID */
    stad_tune_axis axis[STAD_TUNE_DIMS]; /* by enum stad_tune_dim */
    stad_point ladder[STAD_TUNE_LADDER]; /* further points to start from; they are scored first and count */
} stad_tune_config;

/* What has been done so far. */
typedef struct stad_tune_counts {
    int16_t evaluations; /* distinct points told */
    int16_t iterations;  /* of the method */
    int32_t calls;       /* points the method wanted, those answered from the log included */
} stad_tune_counts;

/* A tuner. Private but for being copied and compared with memcmp. */
typedef struct stad_tune {
    stad_tune_config config;         /* as given */
    stad_point start;                /* brought to the lattice */
    stad_point pending;              /* the point asked for */
    int16_t count;                   /* entries of the log */
    int16_t best;                    /* the best of them, -1 before the first */
    int16_t cursor;                  /* where the log is expected to answer next */
    int16_t lead;                    /* the best entry that the current rerun has met */
    int16_t phase;                   /* 0 not initialised, 1 asking, 2 finished */
    stad_tune_counts counts;         /* so far */
    stad_point point[STAD_TUNE_LOG]; /* the log: points */
    int32_t cost[STAD_TUNE_LOG];     /* and their costs */
} stad_tune;

/* Which start ladder stad_tune_config_stereo() brings: points that were good on scenes of each kind, fitted for the cost that is
 * tuned on (docs/TUNING.md); FOR_BAD serves D1 as well. They are for grey frames: with 3 channels multiply p1 and p2 of every
 * rung by 3. */
enum stad_tune_for { STAD_TUNE_FOR_ANY = 0, STAD_TUNE_FOR_BAD = 1, STAD_TUNE_FOR_CHOW = 2 };

/* The config for stereo parameters: method NCG, all free, budget 100, p1 1..4096, p2 2..8192, block 1..11, uniqueness 0..40,
 * cap 15..127, disp12 1..8. Narrow it before stad_tune_init() to what the matcher's geometry affords. FOR_ANY: no ladder. */
void stad_tune_config_stereo(stad_tune_config *c, int purpose);

/* Checks a config. STAD_OK or STAD_E_PARAM: bounds crossed or below 1 on a logarithmic axis, no unit, an unknown method or
 * scale, a budget out of range. Then *culprit, which may be NULL, names the field. */
int stad_tune_config_check(const stad_tune_config *c, const char **culprit);

/* Starts a search. The start is brought to the lattice and into the bounds (free coordinates only) and is the first point
 * asked for. STAD_E_PARAM as stad_tune_config_check(); then the tuner is finished and asks for nothing. */
int stad_tune_init(stad_tune *t, const stad_tune_config *c, const stad_point *start);

/* 1: *x is the point to score; 0: finished, *x is untouched. Asking again gives the same point. */
int stad_tune_ask(const stad_tune *t, stad_point *x);

/* Tells the cost of the point asked for: 0 .. INT32_MAX - 1, or STAD_COST_FAILED, which counts as worse than any cost and is
 * never the best. A cost of 0 ends the search. STAD_OK; STAD_E_PARAM: a negative cost, nothing was recorded, tell again;
 * STAD_E_STATE: nothing was asked for. */
int stad_tune_tell(stad_tune *t, int32_t cost_q20);

/* The best point and its cost, of those told, the earliest among equals. STAD_E_STATE while there is none: nothing told, or
 * all failed; then *x and *cost are untouched. Either may be NULL. */
int stad_tune_best(const stad_tune *t, stad_point *x, int32_t *cost_q20);

/* The i-th distinct evaluation, i = 0 .. evaluations - 1, in the order they were told. STAD_E_PARAM past the end. */
int stad_tune_trace(const stad_tune *t, int i, stad_point *x, int32_t *cost_q20);

/* Whether a state that comes back from elsewhere can be gone on with: STAD_OK; STAD_E_STATE: never started; STAD_E_CORRUPT: no call of
 * these that succeeds leaves it so, and nothing else may be called on it. No checksum: any cost passes, and any point within its axes. */
int stad_tune_check(const stad_tune *t);

/* Counters. */
stad_tune_counts stad_tune_counts_of(const stad_tune *t);

/* A single method, for a firmware that wants no other code linked: stad_tune_init() and stad_tune_tell() choose among all of
 * them, these do not. Use a pair throughout; config.method must name it. ask, best and trace are the same for all. */
int stad_tune_ncg_init(stad_tune *t, const stad_tune_config *c, const stad_point *start);
int stad_tune_ncg_tell(stad_tune *t, int32_t cost_q20); /* method STAD_TUNE_NCG */

int stad_tune_paper_init(stad_tune *t, const stad_tune_config *c, const stad_point *start); /* STAD_TUNE_NCG_PAPER */
int stad_tune_paper_tell(stad_tune *t, int32_t cost_q20);                                   /* STAD_TUNE_NCG_PAPER */

int stad_tune_sd_init(stad_tune *t, const stad_tune_config *c, const stad_point *start); /* STAD_TUNE_SD */
int stad_tune_sd_tell(stad_tune *t, int32_t cost_q20);                                   /* STAD_TUNE_SD */

int stad_tune_descent_init(stad_tune *t, const stad_tune_config *c, const stad_point *start); /* STAD_TUNE_DESCENT */
int stad_tune_descent_tell(stad_tune *t, int32_t cost_q20);                                   /* STAD_TUNE_DESCENT */
int stad_tune_hybrid_init(stad_tune *t, const stad_tune_config *c, const stad_point *start);  /* STAD_TUNE_HYBRID */
int stad_tune_hybrid_tell(stad_tune *t, int32_t cost_q20);                                    /* STAD_TUNE_HYBRID */

#ifdef __cplusplus
}
#endif

#endif
