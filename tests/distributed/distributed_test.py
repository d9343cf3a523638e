# SPDX-License-Identifier: BSD-3-Clause
"""scarp-lammps on 1, 2 and 4 processes leaves what scarp leaves.

Usage: distributed_test.py PATH_OF_SCARP PATH_OF_SCARP_LAMMPS MPIRUN [TEST...]"""

import csv
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import h5py
import numpy

SCARP, SCARP_LAMMPS, MPIRUN = (sys.argv.pop(1) for _ in range(3))

# Lets several processes share a core, and root run them (as in a container).
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_mpi_yield_when_idle": "1",
               "OMPI_MCA_hwloc_base_binding_policy": "none", "OMPI_MCA_btl_vader_single_copy_mechanism": "none"}

SLIDE = """title = "Slide"
dimension = 2
spacing = "0.5 m"
preset = "PRESET"
[[material]]
name = "clay"
density = 2000.0
youngs_modulus = "100 MPa"
poisson_ratio = 0.3
cohesion = "2 kPa"
friction_angle = "20 deg"
[[material]]
name = "rock"
model = "linear_elastic"
density = 2200.0
youngs_modulus = "100 MPa"
poisson_ratio = 0.3
[[body]]
material = "clay"
polygon = [[0, 2], [24, 2], [24, 5], [20, 5], [12, 13], [0, 13]]
[[body]]
material = "rock"
polygon = [[0, 0], [24, 0], [24, 2], [0, 2]]
[[wall]]
name = "base"
kind = "no_slip"
line = [[0, 0], [24, 0]]
[[wall]]
name = "left"
kind = "free_slip"
line = [[0, 20], [0, 0]]
[[wall]]
name = "right"
kind = "free_slip"
line = [[24, 0], [24, 20]]
motion = {velocity = [0.5, 0], from = "fail"}
[initial]
stress = "geostatic"
k0 = 0.6
[[stage]]
name = "settle"
duration = "0.02 s"
[[stage]]
name = "fail"
strength_reduction = 2
duration = "0.08 s"
[[probe]]
name = "crest"
at = [12, 13]
[[probe]]
name = "toe"
at = [20, 5]
[output]
every = "50 ms"
energy = true
[checkpoint]
every = "20 ms"
[numerics]
NUMERICS
"""

# A column that stands free when its gate goes, in 3D; it runs out along x across every cut.
COLUMN = """title = "Column"
dimension = 3
gravity = [0.0, 0.0, -9.81]
spacing = "20 mm"
preset = "PRESET"
[[material]]
name = "sand"
density = 1530.0
youngs_modulus = "2 MPa"
poisson_ratio = 0.25
cohesion = "0 Pa"
friction_angle = "33 deg"
cone = "outer"
[[body]]
material = "sand"
box = {min = [0, 0, 0], max = [0.24, 0.12, 0.2]}
[[wall]]
name = "base"
kind = "no_slip"
rectangle = {origin = [0, 0, 0], u = [1.2, 0, 0], v = [0, 0.12, 0]}
[[wall]]
name = "sides"
kind = "free_slip"
box = {min = [0, 0, 0], max = [1.2, 0.12, 0.32], open = ["-z", "+z", "+x"]}
[[wall]]
name = "gate"
kind = "free_slip"
rectangle = {origin = [0.24, 0, 0], u = [0, 0, 0.32], v = [0, 0.12, 0]}
until = "collapse"
[initial]
stress = "geostatic"
[[stage]]
name = "fill"
duration = "0.005 s"
[[stage]]
name = "collapse"
duration = "DURATION s"
[[probe]]
name = "top"
at = [0.23, 0.06, 0.2]
[output]
every = "20 ms"
energy = true
[checkpoint]
every = "100 ms"
[numerics]
NUMERICS
"""


def scene_of(text, preset="modern", numerics="", duration="0.03"):
    return text.replace("PRESET", preset).replace("NUMERICS", numerics).replace("DURATION", duration)


def state_of(checkpoint):
    """Every dataset but the time that the run took and how long its tables are; fields by id."""
    found = {}
    with h5py.File(checkpoint, "r") as file:
        file.visititems(lambda name, item: found.update({name: numpy.array(item)})
                        if isinstance(item, h5py.Dataset) and name != "outputs/wall_seconds" else None)
    return found


def by_id(state):
    ids = state["particles/id"]
    order = numpy.argsort(ids)[numpy.count_nonzero(ids < 0):]
    fields = {name: values[:, order] for name, values in state.items() if name.startswith("fields/")}
    return {"particles/id": ids[order], **fields}


class Comparison(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def command(self, processes, *arguments):
        if processes == 0:
            return [SCARP, *arguments, "--threads", "1"]
        return [MPIRUN, "-np", str(processes), SCARP_LAMMPS, *arguments]

    def call(self, processes, *arguments):
        """0 processes: scarp itself."""
        return subprocess.run(self.command(processes, *arguments), cwd=self.folder, capture_output=True, text=True,
                              timeout=300, check=False, env=ENVIRONMENT)

    def run_scene(self, processes, scene, *arguments, code=0):
        name = f"p{processes}"
        (self.folder / "scene.toml").write_text(scene)
        done = self.call(processes, "run", "scene.toml", "-o", name, "--overwrite", *arguments)
        self.assertEqual(done.returncode, code, done.stderr)
        return self.folder / name, done.stderr

    def newest(self, folder):
        return sorted((folder / "checkpoints").glob("step_*.h5"))[-1]

    def assert_equal_to_round_off(self, one, other, precision=2.0**-53, spacing=0.5):
        """Sums over some fifty neighbours run in another order: each step adds fifty roundings of the largest
        term, which stiff soil does not let grow over these few hundred steps. Where the soil flows they grow by
        the rate of shear, a factor of e for each unit of strain: a hundred is room for it."""
        a, b = (state_of(self.newest(folder)) for folder in (one, other))
        steps = int(a["clock/step"][0])
        self.assertEqual(steps, int(b["clock/step"][0]))
        self.assertAlmostEqual(float(a["clock/time"][0]), float(b["clock/time"][0]), delta=1e-12)
        left, right = by_id(a), by_id(b)
        self.assertEqual(left.keys(), right.keys())
        numpy.testing.assert_array_equal(left["particles/id"], right["particles/id"])
        bound = 100.0 * steps * 50.0 * precision
        speed = 250.0  # [m/s] of waves, in which a rounding of stress travels
        scales = {"fields/position": spacing, "fields/velocity": speed, "fields/acceleration": speed**2 / spacing}
        for name in left:
            if name == "particles/id" or name == "fields/build_position":
                continue
            scale = scales.get(name, numpy.abs(left[name]).max())
            worst = numpy.abs(left[name] - right[name]).max()
            self.assertLessEqual(worst, bound * max(scale, 1e-30), name)

    def assert_same_outputs(self, one, other):
        a, b = (json.loads((folder / "results.json").read_text()) for folder in (one, other))
        self.assertEqual(a["complete"], b["complete"])
        for key in ("soil_particles", "wall_particles", "steps"):
            if key in a:
                self.assertEqual(a[key], b[key], key)
        names = sorted(p.name for p in one.rglob("*") if "checkpoints" not in p.parts)
        self.assertEqual(names, sorted(p.name for p in other.rglob("*") if "checkpoints" not in p.parts))
        for table in ("probes.csv", "walls.csv", "history.csv", "energy.csv"):
            rows = [list(csv.reader((folder / table).read_text().splitlines())) for folder in (one, other)]
            self.assertEqual(len(rows[0]), len(rows[1]), table)
            self.assertEqual(rows[0][0], rows[1][0], table)
            numbers = [numpy.array([[float(v) for v in row if re.fullmatch(r"[-+]?[0-9][-+0-9.e]*", v)]
                                    for row in table_rows[1:]]) for table_rows in rows]
            # Tables hold ten digits. What is zero in exact arithmetic is some 10^4 roundings of the largest number.
            bound = 1e-6 * numpy.abs(numbers[0]).max(axis=0) + 1e-12 * numpy.abs(numbers[0]).max()
            self.assertTrue((numpy.abs(numbers[0] - numbers[1]) <= bound).all(), table)
        for frame in sorted((one / "frames").glob("soil_*.hdf")):
            with h5py.File(frame) as left, h5py.File(other / "frames" / frame.name) as right:
                points = numpy.array(left["VTKHDF/Points"]), numpy.array(right["VTKHDF/Points"])
                self.assertEqual(points[0].shape, points[1].shape)
                self.assertLess(numpy.abs(points[0] - points[1]).max(), 1e-5)  # 4-byte numbers

    def compare(self, scene, counts=(1, 2, 4), **options):
        alone, _ = self.run_scene(0, scene)
        for processes in counts:
            with self.subTest(processes=processes):
                together, said = self.run_scene(processes, scene)
                self.assert_equal_to_round_off(alone, together, **options)
                self.assert_same_outputs(alone, together)
        return said


class QuickTest(Comparison):
    def test_slide_modern(self):
        self.compare(scene_of(SLIDE))

    def test_resume_bit_for_bit_on_as_many_and_to_round_off_on_others(self):
        whole, _ = self.run_scene(2, scene_of(SLIDE))
        for processes in (2, 1, 0):
            with self.subTest(processes=processes):
                part = self.folder / f"resumed_by_{processes}"
                shutil.copytree(whole, part)
                self.newest(part).unlink()
                (part / "results.json").unlink()
                done = self.call(processes, "resume", part.name)
                self.assertEqual(done.returncode, 0, done.stderr)
                if processes == 2:
                    for name, values in state_of(self.newest(whole)).items():
                        numpy.testing.assert_array_equal(values, state_of(self.newest(part))[name], name)
                else:
                    self.assert_equal_to_round_off(whole, part)


class LongTest(Comparison):
    def test_slide_paper(self):
        self.compare(scene_of(SLIDE, "paper"), counts=(2, 4))

    def test_column_across_cuts(self):
        said = self.compare(scene_of(COLUMN, duration="0.12"), counts=(2, 4), spacing=0.02)
        self.assertGreater(int(re.search(r"(\d+) particles moved", said)[1]), 10)

    def test_corrected_forces(self):
        self.compare(scene_of(SLIDE, numerics="force_correction = true"), counts=(2,))


if __name__ == "__main__":
    unittest.main()
