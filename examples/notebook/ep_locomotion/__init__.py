"""A robot learns to park: the figures of ep-locomotion in a notebook.

    from ep_locomotion import EpLocomotion

    w = EpLocomotion(experiment={"goal": {"x": 3, "y": 1, "theta": 0}, "evolution": {"seed": 7}})
    w.step(30)
    w

and in a later cell, for instance, ``pandas.DataFrame(w.history)``.

The figure, in the browser, does the computing: a widget must be shown, and what it comes to is known once the cell has
ended. Nothing is asked of any network.
"""

import gzip
from pathlib import Path

import anywidget
import traitlets

_here = Path(__file__).parent


class EpLocomotion(anywidget.AnyWidget):
    """One figure. Everything that is set below may be changed while it is shown."""

    _esm = "\n".join((_here / name).read_text(encoding="utf-8") for name in ("embed.js", "widget.js"))
    _page = traitlets.Bytes(gzip.compress((_here / "page.html").read_bytes(), mtime=0)).tag(sync=True)
    _statistics = traitlets.List().tag(sync=True)
    _wanted = traitlets.Int(0, help="How many generations there are to be after generation 0.").tag(sync=True)

    link = traitlets.Unicode("lab", help="The part and the run to open: the end of the page's address, after its #.").tag(sync=True)
    experiment = traitlets.Dict(help="Fields of the experiment that are other than in the link; {} for none.").tag(sync=True)
    state = traitlets.Dict(help="What the figure answered last: the whole experiment, the drive, the hash …").tag(sync=True)
    error = traitlets.Unicode(help="What was wrong with what was set last; empty if nothing.").tag(sync=True)

    @traitlets.observe("link", "experiment")
    def _begin_anew(self, _change):
        self._wanted = 0
        self._statistics = []

    def step(self, generations=1):
        """Evolves so many generations more than there are."""
        self._wanted = max(self._wanted, len(self._statistics) - 1) + generations

    @property
    def history(self):
        """Every generation so far as one dict, with the numbers of the page's own CSV in the same order.

        J and the gains are those of the best; gains in 1/s, 1/(m² s) and rad/s, sigmas in the same units.
        """
        return [
            {
                "generation": one["generation"],
                "drives": one["evaluations"],
                "best": one["best"]["cost"],
                "median": one["median"],
                "worst": one["worst"],
                **dict(zip(("kx", "ky", "ktheta"), one["best"]["gains"])),
                **dict(zip(("sigma_x", "sigma_y", "sigma_theta"), one["meanSigmas"])),
            }
            for one in self._statistics
        ]
