"""The core: WebAssembly without imports, run by wasmtime. What goes over its boundary is told in src/bytes/."""

import functools
import re
import threading
from pathlib import Path

from ._bytes import encoded, decoded, request

_path = Path(__file__).with_name("core.wasm")
_lock = threading.Lock()


class InternalError(RuntimeError):
    """The core has stopped at a mistake of its own. What asked it goes on with a fresh one."""


@functools.lru_cache(maxsize=None)
def _compiled():
    """Translated to the machine's code once a process."""
    try:
        import wasmtime
    except ImportError as error:
        message = "ep_locomotion computes with the package wasmtime: pip install wasmtime"
        raise ImportError(message) from error
    engine = wasmtime.Engine()
    return wasmtime, engine, wasmtime.Module(engine, _path.read_bytes())


class Instance:
    """One core with a memory of its own, gone when nobody has it any more. Calls from several threads wait for each other."""

    def __init__(self):
        with _lock:
            self._wasmtime, engine, module = _compiled()
        self._store = self._wasmtime.Store(engine)
        exports = self._wasmtime.Instance(self._store, module, []).exports(self._store)
        self._memory, self._reserve, self._call, self._last = (
            exports[name] for name in ("memory", "reserve", "call", "last_words")
        )
        self._turn = threading.Lock()
        #: Where there is room for how many bytes.
        self._room = (0, -1)
        self.is_lost = False

    def call(self, name, *given):
        """The answer in bytes. What the core refuses is a ValueError with its message."""
        asked = request(name, given)
        with self._turn:
            try:
                self._write(asked)
                refused, answer = self._read(self._call(self._store, len(asked)))
            except (self._wasmtime.WasmtimeError, self._wasmtime.Trap):
                self.is_lost = True
                raise InternalError(f"ep-locomotion: internal error ({self._last_words()})") from None
        if refused:
            raise ValueError(_in_python(answer.decode()))
        return answer

    def _write(self, asked):
        address, room = self._room
        # What a large call took is given back with the next one.
        if not len(asked) <= room <= max(4 * len(asked), _USUAL):
            room = max(len(asked), _USUAL)
            self._room = (0, -1)
            address = _unsigned(self._reserve(self._store, room))
            self._room = (address, room)
        self._memory.write(self._store, asked, address)

    def _read(self, address):
        """The byte before an answer, and the answer."""
        first = _unsigned(address) + 5
        kind, *count = self._memory.read(self._store, first - 5, first)
        return kind, self._memory.read(self._store, first, first + int.from_bytes(count, "little"))

    def _last_words(self):
        """The message of the panic; what stops without one has no room left."""
        _, message = self._read(self._last(self._store))
        return message.decode(errors="replace") or "its memory or its stack is used up"


#: Room for an experiment and a few gains.
_USUAL = 1 << 12


def _in_python(message):
    """What is left out is undefined in JavaScript alone, which counts gains one by one, not in rows."""
    message = re.sub(r"^(\S+ \(gains\[)(\d+)", lambda at: f"{at[1]}{int(at[2]) // 3}", message)
    absent = "but was undefined"
    return message[: -len(absent)] + "but was missing" if message.endswith(absent) else message


def _unsigned(address):
    """Addresses come as signed numbers."""
    return address & 0xFFFF_FFFF


def ask(name, *given):
    """The answer of a core that remembers nothing, in plain values."""
    return decoded(_shared().call(name, *map(encoded, given)))


_kept = []
_kept_lock = threading.Lock()


def _shared():
    with _kept_lock:
        if not _kept or _kept[0].is_lost:
            _kept[:] = [Instance()]
        return _kept[0]
