# SPDX-License-Identifier: BSD-3-Clause
"""What a run leaves in its folder: frames and tables."""

from __future__ import annotations

import os
import pathlib
from dataclasses import dataclass
from typing import Any, Callable, Dict, Iterator, List, Sequence, Union, overload

import numpy as np

from ._core import FileError
from .records import COMPONENTS, Table


@dataclass(frozen=True)
class Frame:
    """All particles at one moment, by ascending id; numbers as the file has them (single precision)."""

    path: pathlib.Path
    time: float  #: [s]
    step: int
    stage: str
    event: str  #: why it was written
    position: np.ndarray  #: (n, 3) [m]
    fields: Dict[str, np.ndarray]  #: by name, in the form of `Simulation.field`
    units: Dict[str, str]

    def table(self, *names: str) -> Table:
        """Fields as columns: "position_x", ..., "velocity_x", ..., or those that are named."""
        columns: Table = {}
        for name in names or ("position", *self.fields):
            values = self.position if name == "position" else self.fields[name]
            if values.ndim == 1:
                columns[name] = values
            else:
                columns.update({f"{name}_{label}": values[:, number]
                                for number, label in enumerate(COMPONENTS[values.shape[1]])})
        return columns


class Frames(Sequence):
    """The frames of a run, read when they are asked for: `frames[-1].position`, `for frame in frames`."""

    def __init__(self, folder: Union[str, os.PathLike]) -> None:
        listed = _read(_files().read_series, folder)
        if not listed:
            raise FileError(f"'{os.fspath(folder)}': there are no frames in it. Try the output folder of a run.")
        self._paths = [path for path, _ in listed]
        self.times = np.array([time for _, time in listed])  #: [s]

    def __len__(self) -> int:
        return len(self._paths)

    @overload
    def __getitem__(self, index: int) -> Frame: ...

    @overload
    def __getitem__(self, index: slice) -> List[Frame]: ...

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            return [self[number] for number in range(*index.indices(len(self)))]
        loaded = _read(_files().load_frame, self._paths[index])
        fields = loaded["fields"]
        order = np.argsort(fields["id"], kind="stable") if "id" in fields else slice(None)
        return Frame(loaded["path"], loaded["time"], loaded.get("step", 0), loaded["stage"], loaded["event"],
                     loaded["position"][order], {name: values[order] for name, values in fields.items()},
                     loaded["units"])

    def __iter__(self) -> Iterator[Frame]:
        return (self[number] for number in range(len(self)))

    def __repr__(self) -> str:
        return f"<scarp.Frames: {len(self)} from {self.times[0]:.4g} s to {self.times[-1]:.4g} s>"


def read_frames(folder: Union[str, os.PathLike]) -> Frames:
    """The frames of a run's output folder. Needs h5py. Raises FileError for a folder without frames or a damaged file."""
    return Frames(folder)


def read_table(folder: Union[str, os.PathLike], name: str) -> Table:
    """A table of a run's output folder as columns: "history", "probes", "walls" or "energy". Units are those of the file's
    titles, SI. Raises FileError if it is not there or is damaged."""
    path = pathlib.Path(folder) / f"{name}.csv"
    table = _read(_files().read_table, path)
    if table is None:
        raise FileError(f"'{path}': it is not there, or has no row.")
    return table[0]


def _files() -> Any:
    """The reader of the report, which needs h5py."""
    try:
        from . import run_files
    except ImportError as error:
        raise ImportError("reading frames needs h5py: install Debian's python3-h5py") from error
    return run_files


def _read(read: Callable[[Any], Any], path: Any) -> Any:
    try:
        return read(path)
    except _files().Damaged as error:
        raise FileError(str(error)) from error
    except FileNotFoundError as error:
        raise FileError(f"'{error.filename}': it is not there.") from error
