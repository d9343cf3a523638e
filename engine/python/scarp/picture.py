# SPDX-License-Identifier: BSD-3-Clause
"""Particles that one can turn, colour and play in a notebook or in a page of its own."""

from __future__ import annotations

import html
import os
import pathlib
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Union

import numpy as np

from ._core import Error, FileError

if TYPE_CHECKING:
    from .simulation import Simulation


NOTEBOOK_MEGABYTES = 10.0  # that a notebook, which is saved with it, grows by at most


class _Moment:
    """A simulation as it is now, in the form of run_files.load_frame and of scarp_picture.StoredMoment."""

    def __init__(self, simulation: "Simulation", number: int) -> None:
        scene, self.number = simulation.scene, number
        self.info = {"time": simulation.time, "step": simulation.last_step.step, "stage": simulation.stage, "event": ""}
        infos = simulation.fields.values()
        self._frame = {**self.info, "title": scene.title, "dimension": scene.dimension, "spacing": scene.spacing,
                       "position": simulation.field("position"),
                       "fields": {info.name: _single(simulation.field(info.name)) for info in infos},
                       "units": {info.name: info.unit for info in infos},
                       "descriptions": {info.name: info.description for info in infos}}
        self._faces = dict(zip(("corners", "wall"), simulation.wall_faces()), names=scene.walls)

    def load(self) -> Dict[str, Any]:
        return self._frame

    def faces(self) -> Optional[Dict[str, Any]]:
        return self._faces if len(self._faces["wall"]) else None


def _single(values: np.ndarray) -> np.ndarray:
    return values.astype(np.float32) if values.dtype == np.float64 else values


class Picture:
    """Particles of a simulation as it is now, to which `add` adds later moments, or of the frames in a run's folder.

    In a notebook it shows itself; `save` makes a page that needs no server and no network. Needs h5py. Raises FileError for a
    folder without frames.

        picture = scarp.Picture(simulation)
        simulation.run(every="0.1 s", callback=picture.add)
        picture
    """

    def __init__(self, source: Union["Simulation", str, os.PathLike]) -> None:
        try:
            from . import run_files, scarp_picture
        except ImportError as error:
            raise ImportError("pictures need h5py: install Debian's python3-h5py") from error
        self._moments: List[Any] = []
        self._left_out: List[str] = []  # sentences about frames that are damaged
        if isinstance(source, (str, os.PathLike)):
            folder = pathlib.Path(source)
            try:
                self._moments += scarp_picture.stored_moments(folder, self._left_out)
            except run_files.Damaged as error:
                raise FileError(str(error)) from error
            if not self._moments:
                raise FileError(f"'{folder}': there are no frames in it. Try the output folder of a run.")
            self._title = self._moments[0].info.get("title") or folder.name
            self._materials = scarp_picture.materials_of(folder)
        else:
            self.add(source)
            self._title = source.scene.title or "scarp"
            self._materials = scarp_picture.materials_in(source.scene.text)

    def __len__(self) -> int:
        return len(self._moments)

    def add(self, simulation: "Simulation") -> None:
        """Adds the present moment."""
        self._moments.append(_Moment(simulation, len(self._moments)))

    def html(self, megabytes: float = 40.0) -> str:
        """The page; where its data would take more, it has fewer moments, then fewer particles, and says so. Raises Error if scarp was
        built without the viewer."""
        from . import scarp_picture, scarp_viewer
        if scarp_viewer.script_file() is None:
            raise Error(scarp_viewer.MISSING)
        made = scarp_picture.picture_of(self._moments, self._title, self._materials, 1e6 * megabytes, self._left_out)
        return scarp_viewer.picture_page(self._title, scarp_viewer.picture_element(*made, css=" alone"))

    def save(self, path: Union[str, os.PathLike], megabytes: float = 40.0) -> None:
        """Writes the page to a file."""
        try:
            pathlib.Path(path).write_text(self.html(megabytes), encoding="utf-8")
        except OSError as error:
            raise FileError(f"'{os.fspath(path)}': cannot be written: {error.strerror}.") from error

    def _repr_html_(self) -> str:
        from . import scarp_viewer
        if scarp_viewer.script_file() is None:
            return f"<p>{scarp_viewer.MISSING}</p>"
        return (f'<iframe srcdoc="{html.escape(self.html(NOTEBOOK_MEGABYTES), quote=True)}" style="width:100%;height:720px;border:0" '
                'allowfullscreen></iframe>')

    def __repr__(self) -> str:
        return f"<scarp.Picture of {len(self)} moments>"
