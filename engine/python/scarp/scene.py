# SPDX-License-Identifier: BSD-3-Clause
"""Scenes: what the soil is, where it lies, what holds it, what happens to it."""

from __future__ import annotations

import os
import pathlib
from typing import Any, Mapping, Optional, Sequence, Union

from . import _core
from .toml_text import scene_text

Table = Mapping[str, Any]
Tables = Union[Table, Sequence[Table]]
Quantity = Union[float, str]
"""A number in SI, or a text with its unit: 0.25 or "25 cm"."""


def quantity(value: Quantity, unit: str) -> float:
    """The value in SI; `unit` is "length", "time" or "pressure". Raises ValueError with the program's words."""
    return _core.quantity(value, unit) if isinstance(value, str) else float(value)


def _listed(tables: Optional[Tables]) -> Any:
    return [tables] if isinstance(tables, Mapping) else tables


class Scene:
    """A scene that has been read and checked.

    The keywords are the sections of a scene file, and a dict takes the keys of its section with the same units
    (engine/scene/SCENE.md lists them; `scarp explain KEY` prints one). A section that may come several times takes a list of
    dicts, or one dict:

        scene = scarp.Scene(
            dimension=2, spacing="0.25 m",
            material=dict(name="clay", density=2000, youngs_modulus="100 MPa", poisson_ratio=0.3,
                          cohesion="10 kPa", friction_angle="20 deg"),
            body=dict(material="clay", box=dict(min=[0, 0], max=[4, 2])),
            wall=dict(name="base", kind="no_slip", line=[[0, 0], [10, 0]]),
            stage=dict(name="fall", duration="1 s"))

    Raises SceneError in the words of the program. Line numbers in them are those of `text`, the scene as TOML.
    """

    def __init__(self, *, title: Optional[str] = None, dimension: int, spacing: Quantity,
                 gravity: Optional[Sequence[Quantity]] = None, preset: Optional[str] = None,
                 numerics: Optional[Table] = None, material: Tables, body: Optional[Tables] = None,
                 wall: Optional[Tables] = None, initial: Optional[Table] = None, stage: Tables,
                 probe: Optional[Tables] = None, output: Optional[Table] = None, checkpoint: Optional[Table] = None,
                 run: Optional[Table] = None, **unknown: Any) -> None:
        text = scene_text(dict(
            title=title, dimension=dimension, spacing=spacing, gravity=gravity, preset=preset, **unknown,
            numerics=numerics, material=_listed(material), body=_listed(body), wall=_listed(wall), initial=initial,
            stage=_listed(stage), probe=_listed(probe), output=output, checkpoint=checkpoint, run=run))
        self._core = _core.Scene.read_text(text, "scene")
        self._preset, self._spacing = "", None

    @classmethod
    def _of(cls, core: _core.Scene, preset: str, spacing: Optional[float]) -> "Scene":
        scene = cls.__new__(cls)
        scene._core, scene._preset, scene._spacing = core, preset, spacing
        return scene

    @classmethod
    def from_toml(cls, source: Union[str, os.PathLike], *, preset: str = "",
                  spacing: Optional[Quantity] = None) -> "Scene":
        """Reads a scene file, or a text: what has a line end or "=" in it is a text. `preset` and `spacing` replace those of
        the scene, as the options of the program do.

        Raises FileError if the file cannot be read, SceneError "file:line: key 'a.b' = value: why. Try ..." for what is
        wrong with it.
        """
        metres = None if spacing is None else quantity(spacing, "length")
        if isinstance(source, str) and ("\n" in source or "=" in source):
            core = _core.Scene.read_text(source, "scene", preset, metres)
        else:
            core = _core.Scene.read(os.fspath(source), preset, metres)
        return cls._of(core, preset, metres)

    @classmethod
    def from_template(cls, name: str, *, preset: str = "", spacing: Optional[Quantity] = None) -> "Scene":
        """The scene that `scarp new NAME` writes: "slope", "layered_slope", "column", "footing", "terrain" or "chute".

        Raises ValueError for another name.
        """
        return cls.from_toml(_core.template_text(name), preset=preset, spacing=spacing)

    def at(self, *, spacing: Optional[Quantity] = None, preset: Optional[str] = None) -> "Scene":
        """The same scene with another particle spacing or preset."""
        metres = self._spacing if spacing is None else quantity(spacing, "length")
        words = self._preset if preset is None else preset
        return self._of(_core.Scene.read_text(self.text, self.file, words, metres), words, metres)

    def save(self, path: Union[str, os.PathLike]) -> None:
        """Writes `text` to a file that `scarp run` takes. What `preset` and `spacing` replaced is not in it."""
        pathlib.Path(path).write_text(self.text, encoding="utf-8")

    @property
    def text(self) -> str:
        """The scene as TOML, before any replacement."""
        return self._core.text

    @property
    def file(self) -> str:
        """Where it was read from; "scene" for a text."""
        return self._core.file

    @property
    def title(self) -> str:
        """Its title, or ""."""
        return self._core.title

    @property
    def dimension(self) -> int:
        """2 (plane strain, y up) or 3 (z up)."""
        return self._core.dimension

    @property
    def spacing(self) -> float:
        """Distance of the particles [m]."""
        return self._core.spacing

    @property
    def preset(self) -> str:
        """"modern" or "paper"."""
        return self._core.preset

    @property
    def materials(self) -> list[str]:
        """Names of the materials, in the order of the field "material"."""
        return self._core.materials

    @property
    def walls(self) -> list[str]:
        """Names of the walls."""
        return self._core.walls

    @property
    def stages(self) -> list[str]:
        """Names of the stages, in their order."""
        return self._core.stages

    @property
    def probes(self) -> list[str]:
        """Names of the probes."""
        return self._core.probes

    def warnings(self) -> list[str]:
        """What is allowed in the scene but probably not meant, a sentence each, as `scarp check` says it."""
        return self._core.warnings()

    def __repr__(self) -> str:
        return f"<scarp.Scene {self.title or self.file!r}, {self.dimension}D, spacing {self.spacing:g} m>"
