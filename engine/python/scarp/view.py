# SPDX-License-Identifier: BSD-3-Clause
"""A field without a copy, whose life is enforced."""

from __future__ import annotations

import contextlib
from typing import Any, Iterator

import numpy as np

from . import _core


class View(np.lib.mixins.NDArrayOperatorsMixin):
    """One component of a field as the particles lie in memory: nothing is copied, nothing can be written.

    It works in numpy's functions and operators like an array of one dimension (`np.sum(view)`, `2.0 * view`, `view[mask]`);
    what they return is always an array of its own. The view is over with the next step or change of the simulation, because
    particles are then put in another order now and then: each later use raises `Error`. It never shows other particles. Because
    a numpy array could not be told that it is over, no array of the simulation's memory is ever handed out: `np.asarray(view)`,
    `view[:]` and `view.copy()` are copies.

    Some slots only pad and hold no particle: their id, in `Simulation.view("id")`, is -1.
    """

    __slots__ = ("_slots", "_name")

    def __init__(self, slots: _core.Slots, name: str) -> None:
        self._slots, self._name = slots, name

    @property
    def valid(self) -> bool:
        """Whether it can still be used."""
        return self._slots.valid

    @contextlib.contextmanager
    def _raw(self) -> Iterator[np.ndarray]:
        array = self._slots.pin()
        try:
            yield array
        finally:
            self._slots.unpin()

    def __array__(self, dtype: Any = None, copy: Any = None) -> np.ndarray:
        if copy is False:
            raise ValueError("a view gives out copies only.")
        with self._raw() as raw:
            return np.array(raw, dtype=dtype)

    def copy(self) -> np.ndarray:
        """An array of its own."""
        return self.__array__()

    def __getitem__(self, key: Any) -> Any:
        with self._raw() as raw, contextlib.ExitStack() as stack:
            return _own(raw[_opened(key, stack)], [raw])

    def __iter__(self) -> Iterator:
        return iter(self.copy())

    def __len__(self) -> int:
        with self._raw() as raw:
            return len(raw)

    @property
    def shape(self) -> tuple:
        """(slots,)"""
        return (len(self),)

    @property
    def ndim(self) -> int:
        """1"""
        return 1

    @property
    def size(self) -> int:
        """The number of slots."""
        return len(self)

    @property
    def dtype(self) -> np.dtype:
        """float64; int64 of ids."""
        with self._raw() as raw:
            return raw.dtype

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **keywords: Any) -> Any:
        # numpy's `at` writes to arrays that cannot be written.
        if any(isinstance(out, View) for out in (*keywords.get("out", ()), *inputs[:method == "at"])):
            raise ValueError("a view cannot be written. Try Simulation.set_field().")
        with contextlib.ExitStack() as stack:
            result = getattr(ufunc, method)(*_opened(inputs, stack), **_opened(keywords, stack))
        return result  # of the inputs, a ufunc returns none

    def __array_function__(self, function: Any, types: Any, inputs: tuple, keywords: dict) -> Any:
        if any(callable(value) for value in (*inputs, *keywords.values())):
            # A function of the caller's could keep what it is shown.
            return function(*_copied(inputs), **_copied(keywords))
        with contextlib.ExitStack() as stack:
            raws: list = []
            result = function(*_opened(inputs, stack, raws), **_opened(keywords, stack, raws))
            return _own(result, raws)

    def sum(self) -> Any:
        """np.sum of all slots, those that only pad included."""
        return np.sum(self)

    def __repr__(self) -> str:
        return f"<scarp.View of {self._name}, {f'{len(self)} slots' if self.valid else 'over'}>"


def _opened(value: Any, stack: contextlib.ExitStack, raws: Any = None) -> Any:
    """The same with arrays in place of views, for as long as the stack lives."""
    if isinstance(value, View):
        raw = stack.enter_context(value._raw())
        if raws is not None:
            raws.append(raw)
        return raw
    if type(value) in (tuple, list):
        return type(value)(_opened(item, stack, raws) for item in value)
    if type(value) is dict:
        return {name: _opened(item, stack, raws) for name, item in value.items()}
    return value


def _copied(value: Any) -> Any:
    """The same with copies in place of views."""
    if isinstance(value, View):
        return value.copy()
    if type(value) in (tuple, list):
        return type(value)(_copied(item) for item in value)
    if type(value) is dict:
        return {name: _copied(item) for name, item in value.items()}
    return value


def _own(value: Any, raws: list) -> Any:
    """The same with a copy of each array that lies in the simulation's memory."""
    if isinstance(value, np.ndarray):
        return value.copy() if any(np.may_share_memory(value, raw) for raw in raws) else value
    if isinstance(value, (tuple, list)):
        items = [_own(item, raws) for item in value]
        return items if isinstance(value, list) else tuple(items)
    return value
