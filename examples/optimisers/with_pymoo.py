"""Time against energy by the NSGA-II of pymoo, two goals at once: pip install pymoo; python with_pymoo.py [generations]"""

import functools
import sys

import ep_locomotion as ep
from pymoo.algorithms.moo.nsga2 import NSGA2
from pymoo.optimize import minimize
from pymoo.problems.functional import FunctionalProblem

# The problem.
task = ep.Task({"goal": {"x": 3, "y": 1, "theta": 0}})
ranges = {"n_var": 3, "xl": 0.01, "xu": 10}
drive = functools.lru_cache(lambda gains: task.simulate(gains))
goals = [lambda gains: drive(tuple(gains))["finalTime"], lambda gains: drive(tuple(gains))["cost"]["energy"]]
arrived = [lambda gains: 0 if drive(tuple(gains))["arrived"] else 1]

problem = FunctionalProblem(objs=goals, constr_ieq=arrived, **ranges)
generations = int(sys.argv[1]) if len(sys.argv) > 1 else 50
found = minimize(problem, NSGA2(pop_size=20), ("n_gen", generations), seed=1)
if found.F is None:
    sys.exit("no robot has arrived yet")
for (time, energy), gains in sorted(zip(found.F.tolist(), found.X.tolist())):
    print("t_f", time, "energy", energy, "gains", *gains)
