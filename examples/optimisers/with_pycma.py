"""The robot's gains found by the CMA-ES of pycma: pip install cma; python with_pycma.py [generations]"""

import sys

import cma
import ep_locomotion as ep

# The problem.
task = ep.Task({"goal": {"x": 3, "y": 1, "theta": 0}})
start, step = [5, 5, 5], 2
bounds = [0, 10]
evaluate = task.evaluate

generations = int(sys.argv[1]) if len(sys.argv) > 1 else 50
options = {"bounds": bounds, "seed": 1, "popsize": 20, "maxiter": generations, "verbose": -9}
search = cma.CMAEvolutionStrategy(start, step, options)
while not search.stop():
    gains = search.ask()
    search.tell(gains, evaluate(gains))
print("J", float(search.best.f), "gains", *map(float, search.best.x))
