"""The robot's gains found by a genetic algorithm of DEAP: pip install deap; python with_deap.py [generations]"""

import random
import sys

import ep_locomotion as ep
from deap import algorithms, base, creator, tools

# The problem.
task = ep.Task({"goal": {"x": 3, "y": 1, "theta": 0}})
low, high = 0.01, 10
creator.create("J", base.Fitness, weights=(-1,))
creator.create("Gains", list, fitness=creator.J)
evaluate = lambda gains: (task.evaluate(gains),)

random.seed(1)
toolbox = base.Toolbox()
toolbox.register("gains", lambda: creator.Gains(random.uniform(low, high) for _ in range(3)))
toolbox.register("population", tools.initRepeat, list, toolbox.gains)
toolbox.register("evaluate", evaluate)
toolbox.register("mate", tools.cxSimulatedBinaryBounded, eta=20, low=low, up=high)
toolbox.register("mutate", tools.mutPolynomialBounded, eta=20, low=low, up=high, indpb=0.3)
toolbox.register("select", tools.selTournament, tournsize=3)

best = tools.HallOfFame(1)
generations = int(sys.argv[1]) if len(sys.argv) > 1 else 50
algorithms.eaSimple(toolbox.population(20), toolbox, 0.9, 0.5, generations, halloffame=best, verbose=False)
print("J", best[0].fitness.values[0], "gains", *best[0])
