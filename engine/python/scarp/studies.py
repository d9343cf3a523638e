# SPDX-License-Identifier: BSD-3-Clause
"""Factor of safety, estimates of errors, element tests: what `scarp fos`, `converge` and `element` do, as objects."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Dict, Mapping, Optional, Sequence

import numpy as np

from . import _core
from .records import Table
from .scene import Quantity, Scene, quantity


def _columns(rows: Sequence[Mapping[str, Any]]) -> Table:
    """A table of rows with the same keys."""
    return {name: np.array([row[name] for row in rows]) for name in rows[0]} if rows else {}


def _optional(value: Optional[Quantity], unit: str) -> Optional[float]:
    return None if value is None else quantity(value, unit)


@dataclass(frozen=True)
class FactorOfSafety:
    """What a search for a factor of safety found. `trials` is a table: reduction, fails, end, displacement [m], speed [m/s],
    time [s], steps, wall_s."""

    factor: Optional[float]  #: the middle of the bracket; None while one end is missing
    stands: Optional[float]  #: the largest factor seen to stand
    fails: Optional[float]  #: the least factor seen to fail
    complete: bool  #: the bracket is as narrow as was asked for
    trials: Table
    elastic: Dict[str, Any]  #: the response with nothing reduced
    strengthening: float  #: of the stages it settled in, over what the scene gives them
    settle_time: float  #: simulated [s]
    height: float  #: of the slope [m]
    limit: float  #: displacement beyond the elastic one at which it counts as failed [m]
    ramp: float  #: time that a cut by 1.5 takes [s]
    window: float  #: time after it [s]
    probe: str  #: whose displacement is judged; "": the largest of the soil
    notes: list  #: what limits the number, a sentence each


def fos(scene: Scene, *, tolerance: float = 0.01, start: float = 1.0, to: Optional[float] = None,
        height: Optional[Quantity] = None, ramp: Optional[Quantity] = None, window: Optional[Quantity] = None,
        probe: str = "", early_stop: bool = True, threads: Optional[int] = None, isa: Optional[str] = None,
        progress: Optional[Callable[[Dict[str, Any]], Any]] = None) -> FactorOfSafety:
    """Finds the factor of safety of a slope by cutting its strength by different factors.

    The scene is settled by all its stages but the last, in which the strength is cut. `start` and `to` are the factors tried
    first and second (`--from` and `--to` of the program); the others are the options of `scarp fos`. `progress` hears of each
    trial as a dict. Nothing is written. Ctrl-C ends it with KeyboardInterrupt. Raises SceneError, SimulationInstability.
    """
    if not tolerance > 0.0:
        raise ValueError(f"tolerance: {tolerance:g} is not above 0. Try 0.01.")
    for name, value in (("start", start), ("to", to)):
        if value is not None and not 0.02 <= value <= 50.0:
            raise ValueError(f"{name}: {value:g} is not within 0.02 to 50.")
    if to is not None and not to > start:
        raise ValueError(f"to: {to:g} is not above start, {start:g}. Try a larger one.")
    found = _core.fos(scene._core, start, to, tolerance, _optional(height, "length"), _optional(ramp, "time"),
                      _optional(window, "time"), probe, early_stop, threads, isa or "", progress)
    return FactorOfSafety(**{**found, "trials": _columns(found["trials"])})


@dataclass(frozen=True)
class Convergence:
    """What three spacings say of the errors.

    `runs` is a table: spacing [m], wall_s, particles, steps, mass. `quantities` is a table with a row for each number compared:
    name, unit, value_coarse, value_middle, value_fine, error_coarse, error_middle, error_fine (relative), observed_order, order,
    extrapolated (NaN where there is none), trend, remark. `advice` is a table: target (relative error), spacing [m] (NaN: none
    can be named), wall_s, decided_by.
    """

    runs: Table
    quantities: Table
    advice: Table
    notes: list  #: what limits the estimates, a sentence each


def converge(scene: Scene, spacings: Optional[Sequence[Quantity]] = None, *, threads: Optional[int] = None,
             isa: Optional[str] = None, progress: Optional[Callable[[Dict[str, float]], Any]] = None) -> Convergence:
    """Runs a scene at three spacings, coarse first, and estimates the errors; by default 4, 2 and 1 times its own.

    `progress` hears of each run as a dict of spacing, wall_s, particles, steps. Nothing is written. Raises SceneError,
    SimulationInstability.
    """
    values = [4.0 * scene.spacing, 2.0 * scene.spacing, scene.spacing] if spacings is None else [
        quantity(value, "length") for value in spacings]
    values.sort(reverse=True)
    if len(values) != 3 or not values[2] > 0.0 or values[0] < 1.1 * values[1] or values[1] < 1.1 * values[2]:
        raise ValueError("spacings: three above 0 are needed, each at least 1.1 times the next.")
    heard = None if progress is None else lambda *run: progress(
        dict(zip(("spacing", "wall_s", "particles", "steps"), run)))
    found = _core.converge([scene.at(spacing=value)._core for value in values], threads, isa or "", heard)
    rows = []
    for row in found["quantities"]:
        flat = {name: row[name] for name in ("name", "unit")}
        for kind in ("value", "error"):
            flat.update({f"{kind}_{place}": number
                         for place, number in zip(("coarse", "middle", "fine"), row[f"{kind}s"])})
        flat.update({name: row[name] for name in ("observed_order", "order", "trend", "remark")})
        flat["extrapolated"] = np.nan if row["extrapolated"] is None else row["extrapolated"]
        rows.append(flat)
    advice = [{**row, "spacing": np.nan if row["spacing"] is None else row["spacing"]} for row in found["advice"]]
    return Convergence(_columns(found["runs"]), _columns(rows), _columns(advice), found["notes"])


@dataclass(frozen=True)
class ElementTest:
    """A laboratory test on one point of soil. `table` has a row for the start and for each step: strain_xx ..., stress_xx ...
    [Pa] (tension positive), I1, sqrt_J2, deviator [Pa], volumetric_strain, and of soil that yields yield_function, its history
    and plastic_volumetric_strain."""

    table: Table
    isa: str
    constants: Dict[str, float]  #: that the model shows
    bulk_modulus: float  #: [Pa]
    shear_modulus: float  #: [Pa]
    first_yield: int  #: first row whose history differs from the start; 0: there is none
    control_error: float  #: largest departure of a held stress [Pa]


def element(scene: Scene, path: str, *, material: str = "", confining: Quantity = 100e3, strain: float = 0.05,
            steps: int = 1000, isa: Optional[str] = None) -> ElementTest:
    """Drives one material point along a laboratory test, with the scene's numerics.

    `path`: "triaxial", "plane_strain", "simple_shear" or "isotropic". `confining`: pressure at the start [Pa]. `strain`: at the
    end, positive in compression (simple_shear: gamma). Raises SceneError, Error where no increment holds the stress.
    """
    if not 1 <= steps <= 10_000_000:
        raise ValueError(f"steps: {steps} is not within 1 to 10000000.")
    return ElementTest(**_core.element(scene._core, path, material, quantity(confining, "pressure"), strain, steps, isa or ""))
