# SPDX-License-Identifier: BSD-3-Clause
"""A simulation: steps, runs, fields, probes, checkpoints."""

from __future__ import annotations

import os
import warnings
from typing import Any, Callable, Dict, Mapping, Optional, Tuple, Union

import numpy as np

from . import _core
from .records import COMPONENTS, FieldInfo, ModelStep, ProbeSample, StepReport, Table
from .scene import Quantity, Scene, quantity
from .view import View


class Simulation:
    """The particles of a scene, which `step()` and `run()` advance.

        simulation = scarp.Simulation(scene)
        simulation.run(until="2 s")
        x, y, _ = simulation.field("position").T

    `threads`: exactly that many; None: as many as make it faster. The results do not depend on it, bit for bit. `isa`: "sse2",
    "avx2" or "avx512", on ARM "neon"; None: the best of the machine. `oversubscribe` allows up to 16 threads on fewer cores, for tests.
    `particles` takes the place of what the scene's bodies would be filled with: a dict of "position" (n, 2 or 3) [m] and, where wanted, "velocity",
    "material" (indices), "id", "stress" (n, 6) and "density".

    What the scene probably does not mean is said as a RuntimeWarning. Errors: SceneError.

    A simulation may be used by one thread at a time; other threads of Python go on while it steps.
    """

    def __init__(self, scene: Scene, *, threads: Optional[int] = None, isa: Optional[str] = None,
                 oversubscribe: bool = False, particles: Optional[Mapping[str, Any]] = None) -> None:
        for words in scene.warnings():
            warnings.warn(words, RuntimeWarning, stacklevel=2)
        self._scene = scene
        if particles is None:
            self._core = _core.Session(scene._core, threads, isa or "", oversubscribe)
        else:
            self._core = _core.Session.from_particles(scene._core, threads=threads, isa=isa or "",
                                                      oversubscribe=oversubscribe, **particles)

    @classmethod
    def _of(cls, scene: Scene, core: _core.Session) -> "Simulation":
        simulation = cls.__new__(cls)
        simulation._scene, simulation._core = scene, core
        return simulation

    @classmethod
    def resume(cls, scene: Scene, checkpoint: Union[str, os.PathLike], *, threads: Optional[int] = None,
               isa: Optional[str] = None) -> "Simulation":
        """Goes on, bit for bit, from a checkpoint of the same scene: one of `save`, or of the folder of a run.

        Raises CheckpointError for a file that is damaged or of another scene or version.
        """
        return cls._of(scene, _core.Session.resume(scene._core, os.fspath(checkpoint), threads, isa or ""))

    @classmethod
    def resume_run(cls, folder: Union[str, os.PathLike], *, threads: Optional[int] = None,
                   isa: Optional[str] = None) -> "Simulation":
        """Goes on with a run that was stopped or killed, from the newest checkpoint in its folder that is whole, as `scarp
        resume` does: `Simulation.resume_run("out/bank").run()`. Without a checkpoint it starts over. The outputs in the folder
        go on as if it had never stopped.

        Raises FileError if the folder holds no run or is in use, Error if the run is complete, CheckpointError.
        """
        core, preset, spacing, session = _core.Session.resume_folder(os.fspath(folder), threads, isa or "")
        return cls._of(Scene._of(core, preset, spacing), session)

    def save(self, path: Union[str, os.PathLike]) -> None:
        """Writes the complete state to a checkpoint. A model in Python is not part of it. Raises FileError."""
        self._core.save(os.fspath(path))

    def clone(self) -> "Simulation":
        """An independent copy, which goes on from here bit for bit."""
        return self._of(self._scene, self._core.clone())

    # steps

    def step(self) -> StepReport:
        """Advances one time step. Raises SimulationInstability; the state stays readable."""
        self._core.step()
        return self.last_step

    def run(self, until: Optional[Quantity] = None, *, every: Optional[Quantity] = None,
            callback: Optional[Callable[["Simulation"], Any]] = None,
            folder: Optional[Union[str, os.PathLike]] = None, overwrite: bool = False) -> StepReport:
        """Runs to the end of the last stage, or to the first step at or after the simulated time `until`.

        `callback(simulation)` is called at the first step at or after each multiple of `every` [s], and at the end; without
        `every` after each step. It may read everything; if it returns False, the run ends.

        `folder` gets what `scarp run` leaves in one: frames, tables, results.json, checkpoints; `scarp report` and `scarp
        resume` take it, and `read_frames` reads it. `retry` of the scene's [run] acts with a folder only. `overwrite`
        removes the results in it first. Give the same folder again where a run is continued after `until`.

        Ctrl-C ends it between two steps with KeyboardInterrupt; the simulation can be read and run on. With a folder, a
        checkpoint is written before, from which `resume_run` goes on with the outputs too. Raises SimulationInstability, FileError.
        """
        self._core.run(None if until is None else quantity(until, "time"),
                       None if every is None else quantity(every, "time"),
                       None if callback is None else lambda: callback(self),
                       "" if folder is None else os.fspath(folder), overwrite)
        return self.last_step

    def end_stage(self) -> None:
        """Ends the current stage now: the next step enters the next one."""
        self._core.end_stage()

    def perturb(self, speed: float) -> None:
        """Adds noise within +-`speed` [m/s] to each component of the velocities, by the ids alone."""
        self._core.perturb(speed)

    @property
    def step_factor(self) -> float:
        """Factor on every time step from now on; 1 at the start."""
        return self._core.step_factor

    @step_factor.setter
    def step_factor(self, factor: float) -> None:
        self._core.step_factor = factor

    # where it stands

    @property
    def scene(self) -> Scene:
        """The scene it was made of."""
        return self._scene

    @property
    def last_step(self) -> StepReport:
        """What the last step did."""
        return StepReport(*self._core.last_step())

    @property
    def time(self) -> float:
        """Simulated time [s]."""
        return self.last_step.time

    @property
    def finished(self) -> bool:
        """Whether the last stage has ended."""
        return self._core.finished

    @property
    def stage(self) -> str:
        """Name of the current stage."""
        return self._scene.stages[self._core.stage_index]

    @property
    def stage_ended(self) -> bool:
        """Whether the current stage has reached its end."""
        return self._core.stage_ended

    @property
    def stage_reached_rest(self) -> bool:
        """Whether it ended because everything came to rest."""
        return self._core.stage_reached_rest

    @property
    def soil_count(self) -> int:
        """The number of soil particles."""
        return self._core.soil_count

    @property
    def wall_count(self) -> int:
        """The number of dummy particles of the walls."""
        return self._core.wall_count

    @property
    def soil_mass(self) -> float:
        """[kg, in 2D per metre]"""
        return self._core.soil_mass

    @property
    def smoothing_length(self) -> float:
        """[m]"""
        return self._core.smoothing_length

    @property
    def isa(self) -> str:
        """The instruction set in use."""
        return self._core.isa

    @property
    def threads(self) -> int:
        """Threads that a step may have."""
        return self._core.threads

    def warnings(self) -> list[str]:
        """Before the first step: initial stresses that the soil cannot bear, and soil with nothing below it."""
        return self._core.start_warnings()

    # fields

    @property
    def fields(self) -> Dict[str, FieldInfo]:
        """What frames hold of each particle, by name. `field` also knows "position" and "lost"."""
        return {row[0]: FieldInfo(*row) for row in self._core.fields()}

    @property
    def ids(self) -> np.ndarray:
        """The permanent ids of all particles, ascending: the order of `field`."""
        return self._core.ids()

    def field(self, name: str) -> np.ndarray:
        """A copy of a field by ascending id, SI: (n,), (n, 3) x, y, z or (n, 6) xx, yy, zz, xy, yz, zx (tension positive).

        Raises Error for a name that the run does not have.
        """
        values = self._core.field(name)
        info = self.fields.get(name)
        return values.astype(np.int64) if (info and info.integer) or name == "lost" else values

    def set_field(self, name: str, values: Any) -> None:
        """Replaces "velocity", "density", "stress" or a history variable by values in the form that `field` gives.

        Raises Error, before anything is changed, for another name, another count and values that are not finite.
        """
        self._core.set_field(name, np.asarray(values, dtype=float))

    def view(self, name: str, component: str = "") -> View:
        """A stored field without a copy, in the order of memory: `view("density")`, `view("velocity", "x")`, `view("id")`.

        It is over with the next step; see `View`. What is computed when it is read ("displacement") has none.
        """
        names = {label: number for labels in COMPONENTS.values() for number, label in enumerate(labels)}
        if component and component not in names:
            raise ValueError(f"component '{component}' is none of {', '.join(names)}.")
        label = f"{name}.{component}" if component else name
        return View(_core.Slots(self._core, name, names.get(component, 0)), label)

    def table(self, *names: str) -> Table:
        """Fields as columns by ascending id: "id", "position_x", ..., or those that are named. For `pandas.DataFrame`."""
        columns: Table = {"id": self.ids}
        for name in names or ("position", *(name for name in self.fields if name != "id")):
            values = self.field(name)
            if values.ndim == 1:
                columns[name] = values
            else:
                for number, label in enumerate(COMPONENTS[values.shape[1]]):
                    columns[f"{name}_{label}"] = values[:, number]
        return columns

    @property
    def wall_positions(self) -> np.ndarray:
        """(n, 3) positions of the walls' dummy particles [m]."""
        return self._core.wall_positions()

    def wall_faces(self) -> Tuple[np.ndarray, np.ndarray]:
        """The faces of the walls that stand, where they are now: corners (n, 4, 3), in 2D (n, 2, 3) [m], and the number of each
        one's wall in `scene.walls`."""
        corners, walls = self._core.wall_faces()
        return corners.reshape(-1, 2 if self.scene.dimension == 2 else 4, 3), walls.astype(int)

    # what is measured

    def probe(self, name: str) -> ProbeSample:
        """What a probe of the scene reads now. Raises Error for a name that it does not have."""
        return ProbeSample(**self._core.probe(name))

    @property
    def probes(self) -> Dict[str, ProbeSample]:
        """All probes of the scene by name."""
        return {name: self.probe(name) for name in self._scene.probes}

    @property
    def energies(self) -> Dict[str, float]:
        """Energies of the stage [J, in 2D per metre]; what is dissipated is 0 unless the scene's [output] has energy = true."""
        return self._core.energy()

    @property
    def reactions(self) -> Dict[str, np.ndarray]:
        """Force of the soil on each wall, x, y, z [N, in 2D per metre]."""
        return self._core.reactions()

    @property
    def lost_particles(self) -> int:
        """Particles that have left everything that could hold them; counted every 50 steps."""
        return self._core.lost()[0]

    # a soil model in Python

    def set_model(self, update: Callable[[ModelStep], Any], *, material: Optional[str] = None,
                  history: Optional[Mapping[str, float]] = None) -> None:
        """Lets a function of numpy correct the stress of a material in each step: a soil model to try out.

        The material must be `linear_elastic` in the scene: its moduli make the trial stress and set the time step. The function
        gets a `ModelStep` of all particles at once and returns their stress (n, 6); in 2D yz and zx are left as they are. It may
        change the arrays of `step.history`, which begin with the given values:

            def tresca_like(step):
                mean = step.trial[:, :3].mean(axis=1)
                deviator = step.trial - mean[:, None] * [1, 1, 1, 0, 0, 0]
                root_j2 = np.sqrt(0.5 * (deviator**2 @ [1, 1, 1, 2, 2, 2]))
                factor = np.minimum(1.0, 10e3 / np.maximum(root_j2, 1e-9))
                return step.trial + (factor - 1.0)[:, None] * deviator

            simulation.set_model(tresca_like)

        What the stress loses counts as work of "hooks" in the energies. Limits: preset "modern" (kick-drift-kick) only; no
        stress diffusion, since the material is elastic; strength reduction does not reach it; checkpoints do not hold the
        history; a simulation with a model has no `clone`; `fos` and `converge` know nothing of it.
        """
        name = material if material is not None else self._scene.materials[0]
        if material is None and len(self._scene.materials) > 1:
            raise ValueError(f"material: there are several. Try one of {', '.join(self._scene.materials)}.")
        self._core.set_model(name, lambda *values: update(ModelStep(*values)), dict(history or {}))

    def model_history(self, material: Optional[str] = None) -> Dict[str, np.ndarray]:
        """The variables of the model that was set for a material, by ascending id of its particles."""
        return dict(self._core.model_history(material if material is not None else self._scene.materials[0]))

    def __repr__(self) -> str:
        return f"<scarp.Simulation of {self.soil_count} particles at {self.time:.4g} s, stage {self.stage!r}>"
