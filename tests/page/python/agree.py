# Whether values are what the types of the package say: a line for each question, and for each what is wrong.
import json
import sys
import typing

import ep_locomotion as ep
from ep_locomotion import types


def wrong(value, kind, path):
    origin, given = typing.get_origin(kind), typing.get_args(kind)
    if typing.is_typeddict(kind):
        given = set(value) if isinstance(value, dict) else {type(value).__name__}
        if not kind.__required_keys__ <= given <= kind.__required_keys__ | kind.__optional_keys__:
            yield f"{path} has {sorted(given)}, {kind.__name__} {sorted(kind.__annotations__)}"
            return
        hints = typing.get_type_hints(kind)
        for name, field in value.items():
            yield from wrong(field, hints[name], f"{path}.{name}")
    elif origin is typing.Union:
        if all([*wrong(value, one, path)] for one in given):
            yield f"{path} is {value!r}, not {kind}"
    elif origin is typing.Literal:
        if value not in given:
            yield f"{path} is {value!r}, not {kind}"
    elif origin in (list, typing.get_origin(typing.Sequence[float])):
        if not isinstance(value, list):
            yield f"{path} is {type(value).__name__}, not {kind}"
        for i, one in enumerate(value if isinstance(value, list) else []):
            yield from wrong(one, given[0], f"{path}[{i}]")
    elif type(value) is not kind:
        yield f"{path} is {value!r}, not {kind}"


for line in sys.stdin:
    expression, kind = json.loads(line)
    scope = {"ep": ep, "types": types, "typing": typing}
    print(json.dumps([*wrong(eval(expression, scope), eval(kind, scope), expression)]))
