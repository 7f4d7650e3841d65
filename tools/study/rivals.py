# SPDX-License-Identifier: MIT
"""Rival optimisers on the tuner's own problem: the same variables, bounds, lattice, memo and start.

Every rival minimises f over the unit cube of six variables: log2(p1 / b^1.5), log2(p2 / b^1.5), block, uniqueness,
log2(cap), log2(disp12). A point is snapped to the lattice first; only points not met before count as evaluations, and a
rival is stopped when its budget of distinct evaluations is spent, or after 20 times as many calls."""
import math

import numpy as np

# low and high end of each variable
BOX = ((-2.0, 8.0), (-1.0, 10.0), (0.0, 5.0), (0.0, 40.0), (math.log2(15), math.log2(127)), (0.0, 3.0))
BOUNDS = ((1, 4096), (2, 8192), (1, 11), (0, 40), (15, 127), (1, 8))


class Spent(Exception):
    pass


def to_point(cube):
    """Unit cube -> lattice point, by the tuner's own rules."""
    v = [lo + min(max(float(c), 0.0), 1.0) * (hi - lo) for c, (lo, hi) in zip(cube, BOX)]
    block = 2 * int(round(v[2])) + 1
    area = 1.5 * math.log2(block)
    if v[1] - v[0] < 0.5:
        mean = (v[0] + v[1]) / 2
        v[0], v[1] = mean - 0.25, mean + 0.25
    raw = (round(2 ** (v[0] + area)), round(2 ** (v[1] + area)), block, round(v[3]), 15 + 2 * round((2 ** v[4] - 15) / 2), 2 ** round(v[5]))
    x = [min(max(r, lo), hi) for r, (lo, hi) in zip(raw, BOUNDS)]
    x[1] = max(x[1], x[0] + 1)
    return tuple(x)


def to_cube(x):
    area = 1.5 * math.log2(x[2])
    v = (math.log2(x[0]) - area, math.log2(x[1]) - area, (x[2] - 1) / 2, x[3], math.log2(x[4]), math.log2(x[5]))
    return np.array([min(max((a - lo) / (hi - lo), 0.0), 1.0) for a, (lo, hi) in zip(v, BOX)])


class Box:
    """The counted black box. f(cube) -> cost as a fraction; trace: distinct evaluations in order; rounds: the rival's own
    iterations (generations, simplex steps, sweeps of the grid), where it has any."""

    def __init__(self, cost_of, budget, start):
        self.cost_of, self.budget, self.seen, self.trace, self.calls, self.rounds = cost_of, budget, {}, [], 0, 0
        self.start = to_cube(start)
        self.point(tuple(start))  # the start counts for everyone

    def point(self, x):
        self.calls += 1
        if x not in self.seen:
            if len(self.trace) >= self.budget:
                raise Spent
            self.seen[x] = self.cost_of(x)
            self.trace.append((x, self.seen[x]))
        if self.calls > 20 * self.budget:
            raise Spent
        return self.seen[x] / 2**20

    def __call__(self, cube):
        return self.point(to_point(cube))

    def round(self, *_):
        self.rounds += 1


def random_search(f, seed):
    rng = np.random.default_rng(seed)
    while True:
        f(rng.random(6))


def grid(f, seed):
    """Shrinking coordinate grid: five points over the window of each coordinate in turn, window halved when a round gains nothing."""
    at, best, window = f.start.copy(), f(f.start), 1.0
    best = min(best, f.trace[0][1] / 2**20)
    while True:
        f.round()
        gained = False
        for i in range(6):
            for offset in (-0.5, -0.25, 0.25, 0.5):
                trial = at.copy()
                trial[i] = min(max(at[i] + offset * window, 0.0), 1.0)
                cost = f(trial)
                if cost < best:
                    best, keep, gained = cost, trial, True
            if gained:
                at = keep.copy()
        window = window / 2 if not gained or window > 0.6 else window * 0.7
        if window < 1e-3:
            window = 0.5


def nelder_mead(f, seed):
    from scipy.optimize import minimize
    rng, start = np.random.default_rng(seed), f.start
    while True:
        simplex = [start] + [np.clip(start + (0.2 if start[i] < 0.7 else -0.2) * np.eye(6)[i], 0, 1) for i in range(6)]
        minimize(f, start, method="Nelder-Mead", bounds=[(0, 1)] * 6, callback=f.round,
                 options={"initial_simplex": np.array(simplex), "xatol": 1e-2, "fatol": 1e-5})
        start = rng.random(6)


def cma_es(f, seed):
    import cma
    cma.fmin2(f, f.start, 0.2, {"seed": seed + 1, "bounds": [0, 1], "verbose": -9, "maxfevals": 10**6}, restarts=9, callback=f.round)


def tpe(f, seed):
    import optuna
    optuna.logging.set_verbosity(optuna.logging.ERROR)
    study = optuna.create_study(sampler=optuna.samplers.TPESampler(seed=seed))
    study.enqueue_trial({f"x{i}": float(f.start[i]) for i in range(6)})
    study.optimize(lambda t: f([t.suggest_float(f"x{i}", 0, 1) for i in range(6)]), n_trials=10**6)


def bobyqa(f, seed):
    import logging
    import pybobyqa
    logging.getLogger("pybobyqa").setLevel(logging.CRITICAL)
    np.random.seed(seed)
    start = np.clip(f.start, 0.0, 1.0)
    pybobyqa.solve(f, start, bounds=(np.zeros(6), np.ones(6)), rhobeg=0.15, rhoend=1e-3, maxfun=10**5, objfun_has_noise=True,
                   seek_global_minimum=True, print_progress=False, do_logging=False)


def _pymoo(f, algorithm, seed):
    from pymoo.core.problem import ElementwiseProblem
    from pymoo.optimize import minimize

    class P(ElementwiseProblem):
        def __init__(self):
            super().__init__(n_var=6, n_obj=1, xl=np.zeros(6), xu=np.ones(6))

        def _evaluate(self, x, out, *a, **k):
            out["F"] = f(x)

    minimize(P(), algorithm, ("n_gen", 10**6), seed=seed, verbose=False, callback=f.round)


def _first(f, size, seed):
    population = np.random.default_rng(seed).random((size, 6))
    population[0] = f.start
    return population


def ga(f, seed, size=24):
    from pymoo.algorithms.soo.nonconvex.ga import GA
    _pymoo(f, GA(pop_size=size, sampling=_first(f, size, seed)), seed)


def pso(f, seed, size=15):
    from pymoo.algorithms.soo.nonconvex.pso import PSO
    _pymoo(f, PSO(pop_size=size, sampling=_first(f, size, seed)), seed)


RIVALS = {"random": random_search, "grid": grid, "nelder-mead": nelder_mead, "cma-es": cma_es, "tpe": tpe, "bobyqa": bobyqa, "ga": ga, "pso": pso}


def run(name, cost_of, start, budget=150, seed=1):
    """Runs a rival. The Box, with its trace."""
    box = Box(cost_of, budget, start)
    try:
        RIVALS[name](box, seed)
    except Spent:
        pass
    return box
