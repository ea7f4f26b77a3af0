"""The core: WebAssembly without imports, run by wasmtime. What goes over its boundary is told in src/bytes/."""

import functools
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
        self._memory = exports["memory"]
        self._exports = exports
        self._turn = threading.Lock()
        self.is_lost = False

    def call(self, name, *given):
        """The answer in bytes. What the core refuses is a ValueError with its message."""
        asked = request(name, given)
        with self._turn:
            try:
                self._memory.write(self._store, asked, self._export("reserve", len(asked)))
                refused = self._export("call")
            except (self._wasmtime.WasmtimeError, self._wasmtime.Trap):
                self.is_lost = True
                raise InternalError(f"ep-locomotion: internal error ({self._last_words()})") from None
            answer = self._answer()
        if refused:
            raise ValueError(answer.decode())
        return answer

    def _export(self, name, *numbers):
        return self._exports[name](self._store, *numbers)

    def _answer(self):
        # An address is a signed number here.
        first = self._export("answer") & 0xFFFF_FFFF
        return self._memory.read(self._store, first, first + self._export("answer_length"))

    def _last_words(self):
        """The message of the panic; what stops without one has no room left."""
        return self._answer().decode(errors="replace") or "its memory or its stack is used up"


def ask(name, *given):
    """The answer of a core that remembers nothing, in plain values."""
    return decoded(_shared().call(name, *map(encoded, given)))


_kept = []


def _shared():
    with _kept_lock:
        if not _kept or _kept[0].is_lost:
            _kept[:] = [Instance()]
        return _kept[0]


_kept_lock = threading.Lock()
