"""Scenarios as trees of dictionaries, and trees as TOML."""

from __future__ import annotations

import json
import math
import tomllib
from collections.abc import Mapping, Sequence
from typing import Any

Tree = dict[str, Any]


def inline(value: object) -> str:
    """A value as inline TOML.

    >>> inline({"speed": "4 kn", "points": [(0, 1.5), (2, -0.5)]})
    '{ speed = "4 kn", points = [[0, 1.5], [2, -0.5]] }'
    """
    if hasattr(value, "tolist"):  # NumPy's numbers and arrays
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        if math.isnan(value):
            return "nan"
        return repr(value) if math.isfinite(value) else ("inf" if value > 0 else "-inf")
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, Mapping):
        items = (f"{_key(key)} = {inline(item)}" for key, item in value.items())
        return "{ " + ", ".join(items) + " }"
    if isinstance(value, Sequence):
        return "[" + ", ".join(inline(item) for item in value) + "]"
    raise TypeError(f"{type(value).__name__} cannot be used in a scenario: {value!r}")


def dumps(tree: Mapping[str, object]) -> str:
    """A tree as TOML: tables and lists of tables with headers, one key per line.

    >>> print(dumps({"title": "Tug", "time": {"step": 0.1}, "pair": [{"bodies": ["a", "b"]}]}))
    title = "Tug"
    <BLANKLINE>
    [time]
    step = 0.1
    <BLANKLINE>
    [[pair]]
    bodies = ["a", "b"]
    <BLANKLINE>
    """
    # Callers without a type checker may give anything.
    given: object = tree
    if not isinstance(given, Mapping):
        raise TypeError(f"tree: a scenario is a tree of dictionaries, not {given!r}")
    lines: list[str] = []
    _table(tree, "", lines)
    return "\n".join(lines) + "\n"


def _key(key: object) -> str:
    if not isinstance(key, str):
        raise TypeError(f"the keys of a scenario are texts, not {key!r}")
    bare = key.isascii() and key.replace("_", "").replace("-", "").isalnum()
    return key if bare else json.dumps(key, ensure_ascii=False).replace("\x7f", "\\u007f")


def _is_list_of_tables(value: object) -> bool:
    is_list = isinstance(value, Sequence) and not isinstance(value, str) and len(value) > 0
    return is_list and all(isinstance(item, Mapping) for item in value)  # type: ignore[attr-defined]


def _table(tree: Mapping[str, object], path: str, lines: list[str]) -> None:
    below: list[tuple[str, object]] = []
    for key, value in tree.items():
        if isinstance(value, Mapping) or _is_list_of_tables(value):
            below.append((key, value))
        else:
            lines.append(f"{_key(key)} = {inline(value)}")
    for key, value in below:
        name = f"{path}.{_key(key)}" if path else _key(key)
        if isinstance(value, Mapping):
            lines += ([""] if lines else []) + [f"[{name}]"]
            _table(value, name, lines)
        else:
            for item in value:  # type: ignore[attr-defined]
                lines += ([""] if lines else []) + [f"[[{name}]]"]
                _table(item, name, lines)


def tree(text: str, replaced: Sequence[tuple[Sequence[str], str]]) -> Tree:
    """A scenario's text as a tree, with keys replaced in their order.

    >>> tree("[time]\\nstep = 0.1", [(["time", "step"], "1 s"), (["time", "duration"], "20.0")])
    {'time': {'step': '1 s', 'duration': 20.0}}
    """
    document = tomllib.loads(text)
    for path, value in replaced:
        at: Any = document
        for name in path[:-1]:
            at = at[int(name)] if isinstance(at, list) else at.setdefault(name, {})
        last = path[-1]
        at[int(last) if isinstance(at, list) else last] = _value(value)
    return document


def _value(text: str) -> object:
    try:
        return tomllib.loads(f"value = {text}")["value"]
    except tomllib.TOMLDecodeError:
        return text
