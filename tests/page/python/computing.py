"""What is asked in JSON, one Python expression a line, is answered in JSON, with the same bits.

JSON has no infinite numbers: they come as {"float": "inf"}.
"""

from collections import namedtuple
import json
import math
import sys

import ep_locomotion as ep

try:
    import numpy
except ImportError:
    numpy = None


def plain(value):
    if isinstance(value, float) and not math.isfinite(value):
        return {"float": str(value)}
    if isinstance(value, dict):
        return {name: plain(field) for name, field in value.items()}
    if isinstance(value, (list, tuple)):
        return list(map(plain, value))
    if numpy is not None and isinstance(value, numpy.ndarray):
        return {"array": plain(value.tolist())}
    return value


class Series:
    """What of a series of pandas is asked for."""

    def __init__(self, **values):
        self.index = list(values)
        self._values = values

    def __getitem__(self, names):
        return type(self)(**{name: self._values[name] for name in names})

    def __len__(self):
        return len(self._values)

    def __iter__(self):
        return iter(self._values.values())

    def to_numpy(self):
        return list(self)


class Frame(Series):
    """What of a table of pandas is asked for; its columns are lists."""

    @property
    def columns(self):
        return self.index

    def to_numpy(self):
        return list(map(list, zip(*super().to_numpy())))


names = {"Frame": Frame, "Series": Series, "ep": ep, "numpy": numpy, "math": math, "json": json,
         "namedtuple": namedtuple}
for line in sys.stdin:
    asked = json.loads(line)
    names["given"] = asked["given"]
    try:
        answer = {"value": plain(eval(asked["expression"], names))}
    except Exception as error:
        answer = {"error": type(error).__name__, "message": str(error)}
    print(json.dumps(answer, allow_nan=False), flush=True)
