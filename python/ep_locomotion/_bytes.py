"""Plain values as bytes, and back; the tags are those of src/bytes/value.rs."""

import itertools
import math
import struct
import sys
from array import array
from collections.abc import Iterable, Mapping, Sequence, Set
from numbers import Real

_NULL, _FALSE, _TRUE, _NUMBER, _TEXT, _COLUMN, _FLAGS, _LIST, _OBJECT, _OTHER, _WHOLE = (
    bytes([tag]) for tag in range(11)
)

#: An experiment goes four deep.
_DEEPEST = 60
_POSTURE = ("x", "y", "theta")
_GAINS = ("kx", "ky", "ktheta")
#: What has no order of its own, or no numbers.
_NO_ROW = (str, bytes, Mapping, Set)
#: A million gain triples take 24 MB.
_LARGEST = 1 << 26


def _counted(tag, count, *rest):
    return b"".join((tag, count.to_bytes(4, "little"), *rest))


def _text(tag, text):
    data = text.encode(errors="replace")
    return _counted(tag, len(data), data)


def _floats(numbers):
    """Eight bytes each, little-endian."""
    if sys.byteorder == "big":
        numbers.byteswap()
    return numbers.tobytes()


def request(name, given):
    """A call in bytes; what is given is in bytes already."""
    asked = _counted(_LIST, 1 + len(given), _text(_TEXT, name), *given)
    if len(asked) > _LARGEST:
        raise ValueError(f"what is given must be at most {_LARGEST} bytes, but was {len(asked)}")
    return asked


class Encoded(bytes):
    """A value that is in bytes already."""


def encoded(value, depth=_DEEPEST):
    """A value in bytes. Arrays of numpy, series of pandas and the like count as the lists that they are."""
    if depth == 0:
        raise ValueError("what is given must be nested less deeply")
    if isinstance(value, Encoded):
        return value
    if getattr(value, "shape", None) == () and hasattr(value, "item"):
        # What is masked has no number, but an item.
        value = getattr(value, "tolist", value.item)()
    if value is None:
        return _NULL
    if isinstance(value, bool):
        return _TRUE if value else _FALSE
    if isinstance(value, Real):
        return _NUMBER + struct.pack("<d", _number(value))
    if isinstance(value, str):
        return _text(_TEXT, value)
    if isinstance(value, Mapping):
        fields = ((_text(b"", str(name)), _encoded_field(name, field, depth - 1)) for name, field in value.items())
        return _counted(_OBJECT, len(value), *itertools.chain.from_iterable(fields))
    value = _listed(value)
    if isinstance(value, Sequence) and not isinstance(value, (bytes, bytearray)):
        return _counted(_LIST, len(value), *(encoded(one, depth - 1) for one in value))
    return _text(_OTHER, type(value).__name__)


def _listed(value):
    if hasattr(value, "to_numpy"):
        value = value.to_numpy()
    return value.tolist() if hasattr(value, "tolist") else value


def _encoded_field(name, value, depth):
    if name == "starts":
        return _encoded_starts(value, depth)
    return encoded(value, depth)


def _encoded_starts(value, depth):
    """Rows of three numbers go side by side."""
    rows = _rows(value, _POSTURE)
    if rows is None:
        return encoded(value, depth)
    threes = [isinstance(row, (list, tuple)) for row in rows]
    for i, row in enumerate(rows):
        if threes[i] and len(row) != 3:
            raise ValueError(f"starts[{i}] must be three numbers (x, y, θ), but was an array of {len(row)}")
    if rows and all(threes):
        numbers = list(itertools.chain.from_iterable(rows))
        if _are_numbers(numbers):
            return _column(numbers)
    # The core says which of them is wrong.
    named = [dict(zip(_POSTURE, row)) if is_three else row for row, is_three in zip(rows, threes)]
    return encoded(named, depth)


def _rows(value, names):
    """What stands in a list or a table, each row by these names where it has them; of anything else None."""
    value = _listed(_in_order(value, names))
    if not isinstance(value, (list, tuple)):
        return None
    return [row if _is_plain(row) else _listed(_in_order(row, names)) for row in value]


def _is_plain(row):
    """Whether it has no names, as a named tuple has."""
    return isinstance(row, (list, tuple)) and not hasattr(row, "_fields")


def _in_order(value, names):
    """A table whose columns, a series whose labels, or a tuple whose fields have these names, with them in this order; what
    has other names goes by place."""
    fields = getattr(value, "_fields", None)
    labels = getattr(value, "columns", getattr(getattr(value, "dtype", None), "names", fields))
    labels = getattr(value, "index", None) if labels is None else labels
    # A list has an index too, which is a method.
    if not isinstance(labels, Iterable):
        return value
    labels = [label if isinstance(label, str) else None for label in labels]
    if sorted(map(str, labels)) == sorted(names):
        return [getattr(value, name) for name in names] if fields else value[list(names)]
    if any(label in names and label != name for label, name in zip(labels, names)):
        found = ", ".join(map(str, labels))
        raise ValueError(f"names must be {', '.join(names)}, in any order, or all be others, but were {found}")
    return value


def _number(value):
    try:
        return float(value)
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def _are_numbers(values):
    return all(issubclass(kind, Real) and kind is not bool for kind in set(map(type, values)))


def _column(numbers):
    """Numbers side by side."""
    try:
        flat = array("d", numbers)
    except OverflowError:
        flat = array("d", map(_number, numbers))
    return _counted(_COLUMN, len(flat), _floats(flat))


def encoded_gains(gains):
    """Gain triples in bytes, and what becomes of the numbers that come back, one for each triple."""
    numpy = sys.modules.get("numpy")
    gains = _in_order(gains, _GAINS)
    if hasattr(gains, "to_numpy"):
        gains = gains.to_numpy()
    if numpy is not None and getattr(getattr(gains, "dtype", None), "names", None):
        gains = numpy.array(gains.tolist())
    if numpy is not None and isinstance(gains, numpy.ndarray):
        are_rows = gains.ndim == 1 and gains.dtype.kind == "O"
        if not are_rows and (gains.ndim not in (1, 2) or gains.shape[-1] != 3):
            raise ValueError(_wrong(f"an array of shape {gains.shape}"))
        if gains.dtype.kind in "fiu" and not numpy.ma.is_masked(gains):
            data = numpy.ascontiguousarray(gains, "<f8").tobytes()
            answer = numpy.array if gains.ndim == 2 else _single
            return _counted(_COLUMN, gains.size, data), answer
    if not isinstance(gains, Iterable) or isinstance(gains, _NO_ROW):
        raise ValueError(_wrong(f"of type {type(gains).__name__}"))
    rows = gains.tolist() if hasattr(gains, "tolist") else list(gains)
    rows = [row if isinstance(row, float) or _is_plain(row) else _listed(_in_order(row, _GAINS)) for row in rows]
    if not any(_is_row(row) for row in rows) and not isinstance(next(iter(rows), None), (Mapping, Set)):
        if rows and len(rows) != 3:
            raise ValueError(_wrong(f"an array of {len(rows)}"))
        return _encoded_numbers(rows), _single if rows else list
    for i, row in enumerate(rows):
        if not _is_row(row) or len(row) != 3:
            found = f"an array of {len(row)}" if _is_row(row) else f"of type {type(row).__name__}"
            raise ValueError(f"gains[{i}] must be three numbers (kx, ky, kθ), but was {found}")
    return _encoded_numbers(list(itertools.chain.from_iterable(rows))), list


def one_triple(gains):
    """Three finite numbers."""
    given, answer = encoded_gains(gains)
    numbers = decoded(given)
    if answer is not _single:
        raise ValueError(f"gains must be three numbers (kx, ky, kθ), but was {'rows of three' if numbers else 'empty'}")
    for name, number in zip(("kx", "ky", "kθ"), numbers):
        if not isinstance(number, float) or not math.isfinite(number):
            raise ValueError(f"{name} must be a finite number, but was {number!r}")
    return numbers


def _wrong(found):
    return f"gains must be three numbers (kx, ky, kθ) or rows of three, but was {found}"


def _is_row(value):
    return hasattr(value, "__len__") and not isinstance(value, _NO_ROW) and getattr(value, "shape", None) != ()


def _single(numbers):
    return numbers[0]


def _encoded_numbers(numbers):
    """Side by side where they are numbers; else as they are, so that the core says which is none."""
    return _column(numbers) if _are_numbers(numbers) else encoded(numbers)


def decoded(data):
    """The value that bytes are."""
    return _Reader(data).value()


class _Reader:
    def __init__(self, data):
        self._data = data
        self._at = 0

    def value(self):
        tag = self._take(1)
        if tag == _NUMBER:
            return struct.unpack("<d", self._take(8))[0]
        if tag in (_NULL, _FALSE, _TRUE):
            return {_NULL: None, _FALSE: False, _TRUE: True}[bytes(tag)]
        if tag in (_TEXT, _OTHER):
            return self._text()
        count = self._count()
        if tag == _WHOLE:
            return count
        if tag == _COLUMN:
            return list(struct.unpack(f"<{count}d", self._take(8 * count)))
        if tag == _FLAGS:
            return list(map(bool, self._take(count)))
        if tag == _LIST:
            return [self.value() for _ in range(count)]
        return {self._text(): self.value() for _ in range(count)}

    def _text(self):
        return self._take(self._count()).decode()

    def _count(self):
        return int.from_bytes(self._take(4), "little")

    def _take(self, count):
        self._at += count
        return bytes(self._data[self._at - count : self._at])
