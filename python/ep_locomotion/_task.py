"""An experiment that is read once and driven often, and what drives one once."""

from __future__ import annotations

import functools
from collections.abc import Mapping
from typing import Any, Optional, Sequence, Union, overload

from ._bytes import Encoded, decoded, encoded, encoded_gains
from ._core import Instance, ask
from .types import (
    Array,
    Experiment,
    Gains,
    Landscape,
    PartialExperiment,
    Preset,
    Robustness,
    Run,
    Stability,
    StartGrid,
    Trial,
    Trials,
)

Given = Union[Preset, Experiment, PartialExperiment]
Triple = Union[Sequence[float], Array]


def experiment(given: Given = "velocity-limits", changes: Optional[PartialExperiment] = None) -> Experiment:
    """A whole experiment: the preset of this name, or the one that these fields make of ``velocity-limits``.

    ``changes`` are fields that are to be other than there. A field that is unknown, of a wrong type or out of its range is
    a ValueError that names it.
    """
    return ask("experiment", given, {} if changes is None else changes)


class Task:
    """An experiment, or the name of a preset, that is read once and driven often.

    A task has a core of its own: tasks in several threads compute side by side.
    """

    def __init__(self, experiment: Given) -> None:
        self._given = encoded(experiment)
        self._begin()

    def _begin(self) -> None:
        self._core = Instance()
        self._experiment = self._core.call("begin_task", self._given)

    def _call(self, name, *given):
        if self._core.is_lost:
            self._begin()
        return decoded(self._core.call(name, *given))

    def __reduce__(self):
        return (Task, (self.experiment,))

    def __repr__(self) -> str:
        experiment = self.experiment
        count = len(experiment["starts"])
        return f"<Task of {count} start{'' if count == 1 else 's'}, {experiment['law']}>"

    @property
    def experiment(self) -> Experiment:
        """The experiment with every field filled in."""
        return decoded(self._experiment)

    @overload
    def evaluate(self, gains: Sequence[float]) -> float: ...
    @overload
    def evaluate(self, gains: Sequence[Triple]) -> list[float]: ...
    @overload
    def evaluate(self, gains: Array) -> Any: ...
    def evaluate(self, gains: Gains) -> Any:
        """J of each gain triple (kx, ky, kθ), the mean over the start postures.

        A triple gives a number, a list of triples a list, and an array of numpy with a row for each triple an array.
        """
        given, answer = encoded_gains(gains)
        return answer(self._call("evaluate", given))

    def simulate(self, gains: Triple, start: int = 0) -> Run:
        """Drives one robot from ``starts[start]`` to the end of its run: a dict of lists with one value a sample, and J."""
        return self._call("simulate", encoded_gains(gains)[0], encoded(start))

    def landscape(self, landscape: Landscape) -> list[float]:
        """J over two gains, row by row: ``{"x": {"gain": "kx", "from": …, "to": …, "count": …}, "y": …, "gains": …}``."""
        return self._call("landscape", encoded(_with_gains(landscape)))

    def robustness(self, grid: StartGrid) -> Robustness:
        """How a robot fares from many starts: ``{"gains": …, "x": {"from": …, "to": …, "count": …}, "y": …, "headings": …}``."""
        return self._call("robustness", encoded(_with_gains(grid)))

    def fares(self, gains: Triple) -> Robustness:
        """How one robot fares from each of the experiment's starts: J, t_f and whether it arrives."""
        return self._call("fares", encoded_gains(gains)[0])

    def stability(self, gains: Triple, start: int = 0) -> Stability:
        """The Lyapunov function of one run from ``starts[start]``: what the law promises, and what becomes of that."""
        return self._call("stability", encoded_gains(gains)[0], encoded(start))

    def trials(self, trials: Trials) -> list[Trial]:
        """The experiment's method with the seeds [first, end): ``{"seeds": [first, end], "drives": …}``: when the best J fell, and to what."""
        return self._call("trials", encoded(with_ends(trials)))


def with_ends(given):
    """A ``range`` says from where to before where, as the two numbers do for which it stands."""
    if not isinstance(given, Mapping):
        return given
    return {name: _ends(name, value) if name in _PARTS else value for name, value in given.items()}


def _with_gains(given):
    """The same, with gains as all else takes them that drives one robot."""
    given = with_ends(given)
    if not isinstance(given, Mapping):
        return given
    return {**given, "gains": Encoded(encoded_gains(given.get("gains"))[0])}


_PARTS = ("seeds", "rows", "part")


def _ends(name, value):
    if not isinstance(value, range):
        return value
    if value.step != 1:
        raise ValueError(f"{name} must be a range of every one, but was {value}")
    return [value.start, value.stop]


@functools.lru_cache(maxsize=8)
def _kept(_, given):
    task = Task.__new__(Task)
    task._given = given
    task._begin()
    return task


def _task(experiment: Given) -> Task:
    """A task, kept for who asks again in the same thread."""
    import threading

    return _kept(threading.get_ident(), encoded(experiment))


@overload
def evaluate(experiment: Given, gains: Sequence[float]) -> float: ...
@overload
def evaluate(experiment: Given, gains: Sequence[Triple]) -> list[float]: ...
@overload
def evaluate(experiment: Given, gains: Array) -> Any: ...
def evaluate(experiment: Given, gains: Gains) -> Any:
    """J of each gain triple: ``Task(experiment).evaluate(gains)``. Many triples in one call are much the faster."""
    return _task(experiment).evaluate(gains)


def simulate(experiment: Given, gains: Triple, start: int = 0) -> Run:
    """One run: ``Task(experiment).simulate(gains, start)``."""
    return _task(experiment).simulate(gains, start)
