"""A robot learns to park: evolutionary programming of a posture controller, after Kim and Shim (1995).

The core computes here, without a browser, with the same bits as in the page:

    import ep_locomotion as ep

    goal = {"goal": {"x": 3, "y": 1, "theta": 0}}
    ep.evaluate(goal, [10, 10, 10])             # J
    ep.evaluate(goal, [[3, 1, 4], [6, 2, 5]])   # J of each
    ep.simulate(goal, [10, 10, 10])["x"]        # every sample of the drive

    evolution = ep.Evolution(goal)
    evolution.step(30)["best"]

``Task(experiment)`` reads an experiment once. The fields of an experiment are those of the page's files:
``experiment()`` shows them all, ``fields()`` their ranges, ``ep_locomotion.types`` names them for type checkers. In a notebook ``EpLocomotion`` is a figure of the page.
"""

from __future__ import annotations

from importlib.metadata import version as _version
from typing import TYPE_CHECKING, Any

from . import types
from ._core import InternalError, ask as _ask
from ._evolution import Evolution
from ._task import Task, evaluate, experiment, simulate, with_ends

if TYPE_CHECKING:
    from ._widget import EpLocomotion as EpLocomotion

__all__ = [
    "EpLocomotion",
    "Evolution",
    "InternalError",
    "Task",
    "evaluate",
    "experiment",
    "fields",
    "paper",
    "simulate",
    "starts_on_circle",
    "starts_on_grid",
    "word_fields",
]
__version__ = _version("ep-locomotion")


def fields() -> list[types.Field]:
    """Every number of an experiment with its unit and range."""
    return _ask("fields")


def word_fields() -> list[types.WordField]:
    """Every field of an experiment that is one of a few words, with the words."""
    return _ask("word_fields")


def paper() -> list[types.PaperResult]:
    """The results that the paper prints."""
    return _ask("paper")


def starts_on_circle(circle: types.Circle) -> list[types.Posture]:
    """Start postures evenly on a circle, each with a random heading: ``{"x", "y", "radius", "count", "seed"}``."""
    return _ask("starts_on_circle", circle)


def starts_on_grid(grid: types.Grid) -> list[types.Posture]:
    """Start postures at every position of a grid: ``{"x": {"from", "to", "count"}, "y": …, "headings"}``."""
    return _ask("starts_on_grid", with_ends(grid))


def __getattr__(name: str) -> Any:
    # The widget wants anywidget, which computing does not.
    if name == "EpLocomotion":
        from ._widget import EpLocomotion

        return EpLocomotion
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*__all__, "types", *(name for name in globals() if name.startswith("__"))})
