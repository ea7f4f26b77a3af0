"""A figure of the page in a notebook.

    from ep_locomotion import EpLocomotion

    w = EpLocomotion(experiment={"goal": {"x": 3, "y": 1, "theta": 0}, "evolution": {"seed": 7}})
    w.step(30)
    w

and in a later cell, for instance, ``pandas.DataFrame(w.history)``.

The figure, in the browser, does the computing: a widget must be shown, and what it comes to is known once the cell has
ended. Nothing is asked of any network.
"""

from __future__ import annotations

import gzip
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import anywidget
import traitlets

from ._bytes import one_triple
from ._evolution import row, whole_number
from ._task import experiment as whole_experiment

_here = Path(__file__).parent


def _plain(given, whole):
    """The fields that were given, as the core read them: a browser knows no numpy."""
    return {name: _plain(one, whole[name]) if isinstance(one, Mapping) else whole[name] for name, one in given.items()}


class EpLocomotion(anywidget.AnyWidget):
    """One figure. Everything that is set below may be changed while it is shown."""

    _esm = "\n".join((_here / name).read_text(encoding="utf-8") for name in ("embed.js", "widget.js"))
    _page = traitlets.Bytes(gzip.compress((_here / "page.html").read_bytes(), mtime=0)).tag(sync=True)
    _statistics = traitlets.List().tag(sync=True)
    _wanted = traitlets.Int(0, help="How many generations there are to be after generation 0.").tag(sync=True)

    link = traitlets.Unicode("lab", help="The part and the run to open: the end of the page's address, after its #.").tag(sync=True)
    experiment = traitlets.Dict(help="Fields of the experiment that are other than in the link; {} for none.").tag(sync=True)
    gains = traitlets.Any(None, allow_none=True, help="Three gains (kx, ky, kθ) to drive by hand; None for the best of the generation.").tag(sync=True)
    state = traitlets.Dict(help="What the figure answered last: the whole experiment, the drive, the hash …").tag(sync=True)
    error = traitlets.Unicode(help="What was wrong with what was set last; empty if nothing.").tag(sync=True)

    def __init__(self, **given: Any) -> None:
        for name in given:
            self._refuse_unknown(name)
        super().__init__(**given)

    def __setattr__(self, name: str, value: Any) -> None:
        if not name.startswith("_"):
            self._refuse_unknown(name)
        super().__setattr__(name, value)

    def _refuse_unknown(self, name):
        """Python would take a misspelt name for a new one."""
        if not hasattr(type(self), name):
            raise AttributeError(f"a figure has no {name!r}: it has link, experiment and gains")

    @traitlets.validate("experiment")
    def _refuse_wrong(self, proposal):
        try:
            return _plain(proposal.value, whole_experiment(proposal.value))
        except ImportError:
            # Without wasmtime the page says it.
            return proposal.value

    @traitlets.validate("gains")
    def _three_numbers(self, proposal):
        return None if proposal.value is None else one_triple(proposal.value)

    @traitlets.observe("link", "experiment")
    def _begin_anew(self, _change):
        self._wanted = 0
        self._statistics = []

    def step(self, generations: int = 1) -> None:
        """Evolves so many generations more than there are."""
        self._wanted = max(self._wanted, len(self._statistics) - 1) + whole_number(generations)

    @property
    def history(self) -> list[dict[str, Any]]:
        """Every generation so far as one dict, with the numbers of the page's own CSV, as ``Evolution.history`` has it."""
        return [row(one) for one in self._statistics]
