# SPDX-License-Identifier: BSD-3-Clause
"""Plain objects and tables that a simulation gives out."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Dict

import numpy as np

COMPONENTS = {3: ("x", "y", "z"), 6: ("xx", "yy", "zz", "xy", "yz", "zx")}
Table = Dict[str, np.ndarray]
"""Columns of equal length by name: what `pandas.DataFrame` takes."""


@dataclass(frozen=True)
class StepReport:
    """What the last step did. `limit` names the bound that set its size."""

    step: int
    time: float  #: simulated since the start [s]
    stage_time: float  #: since the start of the stage [s]
    time_step: float  #: [s]
    limit: str
    max_velocity: float  #: of the soil that is not lost [m/s]


@dataclass(frozen=True)
class FieldInfo:
    """A quantity of the particles that frames hold."""

    name: str
    unit: str
    components: int  #: 1, 3 (x, y, z) or 6 (xx, yy, zz, xy, yz, zx)
    description: str
    integer: bool


@dataclass(frozen=True)
class ProbeSample:
    """What a probe reads [SI]; stress xx, yy, zz, xy, yz, zx, tension positive."""

    name: str
    position: np.ndarray
    displacement: np.ndarray
    velocity: np.ndarray
    stress: np.ndarray
    density: float
    history: Dict[str, float]  #: variables of the soil model, such as accumulated_plastic_strain


@dataclass
class ModelStep:
    """What a soil model in Python sees of one step: arrays with a row for each particle of the material, by ascending id."""

    trial: np.ndarray  #: (n, 6) stress after rotation and an elastic step [Pa]: xx, yy, zz, xy, yz, zx, tension positive
    stress: np.ndarray  #: (n, 6) stress before the step, as it was [Pa]
    strain: np.ndarray  #: (n, 6) strain of the step, tensor components [-]
    density: np.ndarray  #: (n,) [kg/m3]
    history: Dict[str, np.ndarray]  #: (n,) each: the variables of the model, to be changed
    time_step: float  #: [s]
