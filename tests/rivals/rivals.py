"""What published programs do on this J: pycma and SciPy, and evolutionary programming written down once more from the paper.

    pip install numpy scipy cma
    python tests/rivals/rivals.py            # prints the table
    python tests/rivals/rivals.py --write    # and writes reference.json, with which tests/page/core/rivals.test.js compares the core
    python tests/rivals/rivals.py --functions  # on functions without a robot: the numbers in tests/rivals.rs

51 runs of 4000 drives each. The costs come from the core (cost.mjs); everything else is independent of it.
"""
import json, struct, subprocess, sys
from pathlib import Path

import cma
import numpy as np
from scipy.optimize import differential_evolution, minimize

HERE = Path(__file__).parent
RUNS, DRIVES = 51, 4000
TARGETS = {"5%": 1.05 * 7.7012, "1%": 1.01 * 7.7012, "0.2%": 1.002 * 7.7012}


class Core:
    def __init__(self):
        self.node = subprocess.Popen(["node", str(HERE / "cost.mjs")], stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def __call__(self, gains):
        gains = np.ascontiguousarray(np.atleast_2d(gains), dtype="<f8")
        self.node.stdin.write(struct.pack("<I", len(gains)) + gains.tobytes())
        self.node.stdin.flush()
        return np.frombuffer(self.node.stdout.read(8 * len(gains)), dtype="<f8").copy()


core = Core()


class Spent(Exception):
    pass


class Run:
    """Counts drives, and when the best J fell."""

    def __init__(self):
        self.driven, self.best, self.falls, self.tried = 0, np.inf, [], []

    def __call__(self, gains):
        gains = np.atleast_2d(gains)
        if self.driven >= DRIVES:
            raise Spent
        costs = core(gains)
        for one, cost in zip(gains, costs):
            self.driven += 1
            if self.driven > DRIVES:
                break
            if len(self.tried) < 150:
                self.tried.append([*map(float, one)])
            if cost < self.best:
                self.best = float(cost)
                self.falls.append((self.driven, self.best))
        return costs

    def one(self, gains):
        return float(self(gains)[0])

    def runtime(self, target):
        return next((drive for drive, cost in self.falls if cost <= target), None)


def started(rng, count):
    """Uniform in the initial range."""
    return 10 * rng.random((count, 3))


def mirrored(gains, mirror):
    return np.abs(gains) if mirror else gains


# Differential evolution, SciPy: rand/1/bin, F 0.5, CR 0.9, without polishing and without its own ending.
def scipy_de(rng, run, factor=0.5, crossing=0.9, count=20, bounds=None, updating="deferred"):
    wide = [(-1e6, 1e6)] * 3 if bounds is None else bounds
    first = started(rng, count)
    differential_evolution(
        lambda x: run.one(x), wide, strategy="rand1bin", mutation=factor, recombination=crossing, init=first,
        maxiter=10**6, tol=0, atol=0, polish=False, updating=updating, rng=rng,
    )


# CMA-ES, pycma, without its active part and without its own endings.
def pycma(rng, run, count=20, mirror=False, active=False, rank_mu=1):
    options = {
        "CMA_rankmu": rank_mu, "popsize": count, "CMA_active": active, "seed": int(rng.integers(1, 2**31)), "verbose": -9, "maxiter": 10**9,
        "tolfun": 0, "tolfunhist": 0, "tolx": 0, "tolstagnation": 0, "tolflatfitness": 10**9, "tolconditioncov": 0, "tolfacupx": 1e99, "tolupsigma": 1e99,
    }
    search = cma.CMAEvolutionStrategy(started(rng, 1)[0], 1.0, options)
    while True:
        asked = search.ask()
        search.tell(asked, list(run(mirrored(np.array(asked), mirror))))


# Nelder and Mead, SciPy, begun anew from another draw where the simplex is small.
def scipy_nelder_mead(rng, run, mirror=False):
    while True:
        first = started(rng, 1)[0]
        corners = np.vstack([first, first + np.eye(3)])
        minimize(
            lambda x: run.one(mirrored(x, mirror)), first, method="Nelder-Mead",
            options={"initial_simplex": corners, "xatol": 1e-4, "fatol": np.inf, "maxiter": 10**9, "maxfev": 10**9},
        )


# Evolutionary programming from the paper's words; `crossing` trades gains, with or without their σ.
def paper_ep(rng, run, count=20, opponents=10, crossing=0.0, with_sigmas=True, adaptation=1.0):
    common, own = 1 / np.sqrt(2 * 3), 1 / np.sqrt(2 * np.sqrt(3))
    gains, sigmas = started(rng, count), np.ones((count, 3))
    costs = run(gains)
    while True:
        base, steps = gains.copy(), sigmas.copy()
        for i in range(count):
            if rng.random() < crossing:
                other = rng.choice([j for j in range(count) if j != i])
                taken = rng.random(3) < 0.5
                base[i, taken] = gains[other, taken]
                if with_sigmas:
                    steps[i, taken] = sigmas[other, taken]
        new = base + steps * rng.standard_normal((count, 3))
        factor = common * rng.standard_normal((count, 1)) + own * rng.standard_normal((count, 3))
        all_gains, all_sigmas = np.vstack([gains, new]), np.vstack([sigmas, steps * np.exp(adaptation * factor)])
        all_costs = np.concatenate([costs, run(new)])
        wins = np.zeros(2 * count, int)
        for i in range(2 * count):
            met = rng.integers(0, 2 * count - 1, opponents)
            met[met >= i] += 1
            wins[i] = np.sum(all_costs[i] <= all_costs[met])
        stay = np.lexsort((all_costs, -wins))[:count]
        gains, sigmas, costs = all_gains[stay], all_sigmas[stay], all_costs[stay]


# One gain after the other, in four ways of treating what is below 0 and of changing the step.
def one_at_a_time(rng, run, below="penalty", ladder=None):
    def mend(gains):
        return np.maximum(gains, 0) if below == "clamp" else np.abs(gains) if below == "mirror" else gains

    here = started(rng, 1)[0]
    best = run.one(here)
    if ladder:
        # Each gain in turn both ways by each of these steps, as long as that helps; the best of them is kept.
        while True:
            for j in range(3):
                for step in ladder:
                    for sign in (1, -1):
                        while True:
                            new = here.copy()
                            new[j] += sign * step
                            new = mend(new)
                            cost = run.one(new)
                            if not cost < best:
                                break
                            here, best = new, cost
    steps = np.ones(3)
    for turn in range(10**9):
        j = turn % 3
        new = here.copy()
        new[j] += steps[j]
        new = mend(new)
        cost = run.one(new)
        if cost < best:
            here, best = new, cost
            steps[j] *= 2
        else:
            steps[j] *= -0.5


RIVALS = {
    "EP, from the paper": paper_ep,
    "EP, crossover 0.5 of gains and σ": lambda r, f: paper_ep(r, f, crossing=0.5),
    "EP, crossover 0.5 of gains alone": lambda r, f: paper_ep(r, f, crossing=0.5, with_sigmas=False),
    "EP, crossover 1 of gains and σ": lambda r, f: paper_ep(r, f, crossing=1),
    "EP, crossover 1 of gains alone": lambda r, f: paper_ep(r, f, crossing=1, with_sigmas=False),
    "DE rand/1/bin, F 0.5, CR 0.9 (SciPy)": scipy_de,
    "DE, F 0.5, CR 0.9, at once (SciPy)": lambda r, f: scipy_de(r, f, updating="immediate"),
    "DE, F 0.8, CR 0.9 (SciPy)": lambda r, f: scipy_de(r, f, factor=0.8),
    "DE, F 0.7, CR 0.9 (SciPy)": lambda r, f: scipy_de(r, f, factor=0.7),
    "DE, F 0.5, CR 0.5 (SciPy)": lambda r, f: scipy_de(r, f, crossing=0.5),
    "DE, bounds 0 to 30 (SciPy)": lambda r, f: scipy_de(r, f, bounds=[(0, 30)] * 3),
    "CMA-ES, 20 (pycma)": pycma,
    "CMA-ES, 20, mirrored (pycma)": lambda r, f: pycma(r, f, mirror=True),
    "CMA-ES, 20, mirrored, active (pycma)": lambda r, f: pycma(r, f, mirror=True, active=True),
    "CMA-ES, 7 (pycma)": lambda r, f: pycma(r, f, count=7),
    "CMA-ES, 7, mirrored (pycma)": lambda r, f: pycma(r, f, count=7, mirror=True),
    "Nelder-Mead, begun anew (SciPy)": scipy_nelder_mead,
    "one at a time": one_at_a_time,
    "one at a time, mirrored": lambda r, f: one_at_a_time(r, f, below="mirror"),
    "one at a time, clamped at 0": lambda r, f: one_at_a_time(r, f, below="clamp"),
    "one at a time, steps 1, 0.3, 0.1, clamped": lambda r, f: one_at_a_time(r, f, below="clamp", ladder=(1, 0.3, 0.1)),
}


def runs_of(search):
    runs = []
    for seed in range(1, RUNS + 1):
        run = Run()
        try:
            search(np.random.default_rng(seed), run)
        except Spent:
            pass
        runs.append(run)
    return runs


# Functions without a robot: how many evaluations until the value is below 1e-8, from a draw of the same range.
FUNCTIONS = {
    "sphere": lambda k: float(np.sum((k - 3) ** 2)),
    "ellipsoid": lambda k: float(np.sum(np.array([1, 100, 1e4]) * (k - 3) ** 2)),
    "rosenbrock": lambda k: float(np.sum(100 * (k[1:] - k[:-1] ** 2) ** 2 + (1 - k[:-1]) ** 2)),
}


def function_times(search, function):
    global core
    real, times = core, []
    core = lambda gains: np.array([function(one) for one in np.atleast_2d(gains)])
    for seed in range(1, RUNS + 1):
        run = Run()
        try:
            search(np.random.default_rng(seed), run)
        except Spent:
            pass
        times.append(run.runtime(1e-8) or np.inf)
    core = real
    return times


def functions():
    # The tutorial's first edition, which the core follows, learns the shape by μ_eff − 2 + 1/μ_eff, the second adds 1/4 to that.
    effective = 2.2548
    older = (effective - 2 + 1 / effective) / (effective - 2 + 1 / effective + 0.25)
    methods = {"cma-es": lambda r, f: pycma(r, f, count=7, rank_mu=older), "de": scipy_de, "nelder-mead": scipy_nelder_mead}
    for method, search in methods.items():
        for name, function in FUNCTIONS.items():
            # Where the simplex is small before the value is, it begins anew.
            if method == "nelder-mead" and name != "sphere":
                continue
            times = np.sort(function_times(search, function))
            print(method, name, [int(t) if np.isfinite(t) else None for t in times[[12, 25, 38]]], flush=True)


def simplex_path():
    """What SciPy's simplex tries from 4, 4, 4."""
    run, first = Run(), np.full(3, 4.0)
    minimize(run.one, first, method="Nelder-Mead", options={"initial_simplex": np.vstack([first, first + np.eye(3)]), "maxfev": 100, "xatol": 0, "fatol": 0})
    return run.tried


def main():
    if "--functions" in sys.argv:
        return functions()
    named = [one for one in sys.argv[1:] if not one.startswith("--")]
    reference = {"simplex": simplex_path()}
    for name, search in RIVALS.items():
        if named and not any(one in name for one in named):
            continue
        runs = runs_of(search)
        row = []
        for target in TARGETS.values():
            times = [run.runtime(target) for run in runs]
            reached = [t for t in times if t is not None]
            ert = sum(t or DRIVES for t in times) / len(reached) if reached else float("inf")
            row.append(f"{len(reached):2d} ERT {ert:8.0f}")
        print(f"{name:42s}", " | ".join(row), f"median {np.median([run.best for run in runs]):.4f}", flush=True)
        reference[name] = [
            {"ends": run.best, "runtimes": [run.runtime(target) for target in TARGETS.values()]} for run in runs
        ]
    if "--write" in sys.argv:
        known = json.loads((HERE / "reference.json").read_text()) if named else {}
        (HERE / "reference.json").write_text(json.dumps({**known, **reference}) + "\n")


main()
