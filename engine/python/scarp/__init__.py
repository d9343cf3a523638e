# SPDX-License-Identifier: BSD-3-Clause
"""Slope failure and granular collapse with smoothed-particle hydrodynamics.

    import scarp
    scene = scarp.Scene.from_toml("bank.toml")
    simulation = scarp.Simulation(scene)
    simulation.run(every="0.1 s", callback=lambda s: print(s.time, s.probe("crest").displacement))
    strain = simulation.field("accumulated_plastic_strain")

Scene           what the soil is, where it lies, what holds it: from TOML, or by keywords
Simulation      its particles: step, run, field, view, probe, energies, reactions, save, resume
fos             factor of safety by strength reduction
converge        estimates of the errors from three spacings
element         one point of soil along a laboratory test
Picture         particles to turn, colour and play, in a notebook or a page of its own
read_frames     what a run left in its folder; read_table for its tables

Numbers are SI, stresses positive in tension, tensors xx, yy, zz, xy, yz, zx. A text may carry a unit: "0.25 m". The results
are those of the program `scarp`, bit for bit. Errors are exceptions in the words of the program, below `scarp.Error`.
"""

try:
    from . import _core
except ImportError as error:
    import pathlib as _pathlib
    import sys as _sys
    _there = ", ".join(path.name for path in _pathlib.Path(__file__).parent.glob("_core.*.so"))
    raise ImportError(f"{_sys.executable} cannot load the compiled part of scarp, {_there or 'which is not there'}: {error}. "
                      "Try the interpreter that it was built for, mostly /usr/bin/python3.") from error
from ._core import CheckpointError, Error, FileError, SceneError, SimulationInstability
from ._core import version as __version__
from .frames import Frame, Frames, read_frames, read_table
from .picture import Picture
from .records import FieldInfo, ModelStep, ProbeSample, StepReport
from .scene import Scene
from .simulation import Simulation
from .studies import Convergence, ElementTest, FactorOfSafety, converge, element, fos
from .view import View

__all__ = [
    "CheckpointError", "Convergence", "ElementTest", "Error", "FactorOfSafety", "FieldInfo", "FileError", "Frame", "Frames",
    "ModelStep", "Picture", "ProbeSample", "Scene", "SceneError", "Simulation", "SimulationInstability", "StepReport", "View",
    "converge", "element", "fos", "read_frames", "read_table",
]
