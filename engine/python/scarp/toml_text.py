# SPDX-License-Identifier: BSD-3-Clause
"""Scenes from Python's own values, written as the TOML that scarp reads."""

from __future__ import annotations

import json
import re
from typing import Any, Mapping

_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")


def _key(name: str) -> str:
    return name if _BARE_KEY.fullmatch(name) else _text(name)


def _text(value: str) -> str:
    # TOML's basic strings are those of JSON, but for DEL.
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")


def _value(value: Any, where: str) -> str:
    if hasattr(value, "tolist"):  # numpy's arrays and numbers
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, Mapping):
        inside = ", ".join(f"{_key(str(name))} = {_value(item, f'{where}.{name}')}"
                           for name, item in value.items() if item is not None)
        return "{" + inside + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_value(item, where) for item in value) + "]"
    raise TypeError(f"key '{where}' = {value!r}: a scene holds numbers, texts, lists and dicts. Try one of them.")


def _lines(table: Mapping, where: str) -> list[str]:
    return [f"{_key(str(name))} = {_value(value, f'{where}{name}')}" for name, value in table.items() if value is not None]


def scene_text(keys: Mapping[str, Any]) -> str:
    """The TOML of a scene: keys of the top level, dicts as [tables], lists of dicts as [[tables]]. None leaves a key out."""
    top, rest = [], []
    for name, value in keys.items():
        if value is None:
            continue
        if isinstance(value, Mapping):
            rest += [f"[{_key(name)}]", *_lines(value, f"{name}."), ""]
        elif isinstance(value, (list, tuple)) and value and all(isinstance(item, Mapping) for item in value):
            for number, item in enumerate(value):
                rest += [f"[[{_key(name)}]]", *_lines(item, f"{name}[{number}]."), ""]
        else:
            top += _lines({name: value}, "")
    return "\n".join([*top, "", *rest])
