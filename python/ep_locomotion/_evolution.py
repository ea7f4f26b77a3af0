"""A run of evolutionary programming, or of one of its rivals, that remembers every generation."""

from __future__ import annotations

import operator
from typing import Any, Optional

from ._bytes import decoded, encoded
from ._core import Instance
from ._task import Given
from .types import Experiment, GenerationRecord, Individual, Statistics


class Evolution:
    """Generation 0 of an experiment, or of the preset of this name; ``step`` goes on from there.

    The same experiment gives the same bits as in the page, in Node and natively: ``hash()`` says so.
    """

    def __init__(self, experiment: Given) -> None:
        self._given = encoded(experiment)
        self._begin(0)

    def _begin(self, generation):
        self._core = Instance()
        self._experiment = self._core.call("begin_evolution", self._given)
        self._generation = 0
        for _ in range(generation):
            self._advance()

    def _advance(self):
        answer = self._core.call("step")
        self._generation += 1
        return answer

    def _call(self, name, *given):
        return decoded(self._ready().call(name, *map(encoded, given)))

    def _ready(self):
        # The same experiment comes to the same generation again.
        if self._core.is_lost:
            self._begin(self._generation)
        return self._core

    def __reduce__(self):
        return (_evolved, (self.experiment, self.generation))

    def __repr__(self) -> str:
        settings = self.experiment["evolution"]
        told = [settings["method"], f"seed {settings['seed']}", f"generation {self._generation}"]
        # What a lost core had would have to be driven again.
        if not self._core.is_lost:
            told.append(f"J {self.statistics()['best']['cost']:.6g}")
        return f"<Evolution: {', '.join(told)}>"

    @property
    def experiment(self) -> Experiment:
        """The experiment with every field filled in."""
        return decoded(self._experiment)

    @property
    def generation(self) -> int:
        """The number of the newest generation."""
        return self._call("generation")

    def step(self, generations: int = 1) -> Statistics:
        """Evolves so many generations; the newest in short."""
        for _ in range(whole_number(generations)):
            self._ready()
            answer = self._advance()
        return decoded(answer)

    def statistics(self, generation: Optional[int] = None) -> Statistics:
        """One generation in short; the newest if left out."""
        return self._call("statistics", generation)

    def record(self, generation: Optional[int] = None) -> GenerationRecord:
        """One generation in full: parents, offspring, opponents, wins, who survives; the newest if left out."""
        return self._call("record", generation)

    def population(self, generation: Optional[int] = None) -> list[Individual]:
        """The population that a generation left, best ranked first; the newest if left out."""
        return self._call("population", generation)

    def hash(self) -> str:
        """16 hexadecimal digits over the numbers that decide the history."""
        return self._call("hash")

    @property
    def history(self) -> list[dict[str, Any]]:
        """Every generation as one dict, for ``pandas.DataFrame`` and the like, with the numbers of the page's own CSV."""
        return [row(self.statistics(generation)) for generation in range(self.generation + 1)]


def _evolved(experiment, generation):
    evolution = Evolution(experiment)
    for _ in range(generation):
        evolution._advance()
    return evolution


def whole_number(generations):
    """So many, also as one of numpy's integers."""
    try:
        count = 0 if isinstance(generations, bool) else operator.index(generations)
    except TypeError:
        count = 0
    if count < 1:
        raise ValueError(f"generations must be a whole number from 1, but was {generations!r}")
    return count


def row(statistics):
    """A generation with the numbers of the page's own CSV in the same order.

    J and the gains are those of the best; gains in 1/s, 1/(m² s) and rad/s, with Kanayama's rule in 1/s,
    rad/m² and rad/m, sigmas in the same units.
    """
    best = statistics["best"]
    return {
        "generation": statistics["generation"],
        "drives": int(statistics["evaluations"]),
        "best": best["cost"],
        "median": statistics["median"],
        "worst": statistics["worst"],
        **dict(zip(("kx", "ky", "ktheta"), best["gains"])),
        **dict(zip(("sigma_x", "sigma_y", "sigma_theta"), statistics["meanSigmas"])),
    }
