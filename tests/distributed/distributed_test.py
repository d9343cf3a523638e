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


# A block that slides off its base and falls: the upper half later than the lower one.
FALL = """title = "Fall"
dimension = 2
spacing = "0.1 m"
[[material]]
name = "sand"
density = 1600.0
youngs_modulus = "5 MPa"
poisson_ratio = 0.3
cohesion = "1 kPa"
friction_angle = "30 deg"
[[body]]
material = "sand"
box = {min = [0, 0], max = [2, 0.5]}
velocity = [4, 0]
[[wall]]
name = "base"
kind = "no_slip"
line = [[-1, 0], [2.2, 0]]
[[stage]]
name = "fall"
duration = "1.2 s"
[output]
every = "0.4 s"
"""

# Verlet with a step too long for it.
UNSTABLE = """title = "Column with a step too long"
dimension = 2
spacing = "0.125 m"
[[material]]
name = "rock"
model = "linear_elastic"
density = 2000.0
youngs_modulus = "10 MPa"
poisson_ratio = 0.3
[[body]]
material = "rock"
box = {min = [0, 0], max = [1, 4]}
[[wall]]
name = "box"
kind = "free_slip"
box = {min = [0, 0], max = [1, 6], open = ["+y"]}
[[stage]]
name = "settle"
duration = "0.2 s"
damping = 30
[numerics]
integrator = "verlet"
cfl = 1.5
[run]
retry = RETRY
[output]
every = "50 ms"
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

    def assert_same_outputs(self, one, other, precision=2.0**-53):
        a, b = (json.loads((folder / "results.json").read_text()) for folder in (one, other))
        self.assertEqual(a["complete"], b["complete"])
        for key in ("particles", "wall_particles", "steps"):
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
            small = max(1e-6, 100.0 * 50.0 * precision)
            bound = small * numpy.abs(numbers[0]).max(axis=0) + 1e4 * precision * numpy.abs(numbers[0]).max()
            self.assertTrue((numpy.abs(numbers[0] - numbers[1]) <= bound).all(), table)
        for frame in sorted((one / "frames").glob("soil_*.hdf")):
            with h5py.File(frame) as left, h5py.File(other / "frames" / frame.name) as right:
                points = numpy.array(left["VTKHDF/Points"]), numpy.array(right["VTKHDF/Points"])
                self.assertEqual(points[0].shape, points[1].shape)
                self.assertLess(numpy.abs(points[0] - points[1]).max(), 1e-5 * numpy.abs(points[0]).max())  # 4 bytes

    def compare(self, scene, counts=(1, 2, 4), **options):
        alone, _ = self.run_scene(0, scene)
        for processes in counts:
            with self.subTest(processes=processes):
                together, said = self.run_scene(processes, scene)
                self.assert_equal_to_round_off(alone, together, **options)
                self.assert_same_outputs(alone, together, options.get("precision", 2.0**-53))
        return said


class QuickTest(Comparison):
    def test_counts_of_messages_are_those_of_the_model(self):
        """Two processes send each other one message a refresh, of which a step has two: x, v and the diffusivity of
        the stress (5 numbers in 2D), later x, density and stress (7); all 10 where lists were built. Both divisions of
        this soil, which all yields, have as many ghosts, if the wall that moves has no images, which make lists shorter-lived."""
        scene = scene_of(SLIDE, numerics="force_correction = false").replace(
            'kind = "free_slip"\nline = [[24', 'kind = "no_slip"\nline = [[24')
        self.assertIn('model = "linear_elastic"\n', scene)
        _, said = self.run_scene(2, scene.replace('model = "linear_elastic"\n', 'cohesion = "1 MPa"\nfriction_angle = "20 deg"\n'))
        deals = int(re.search(r"(\d+) divisions", said)[1])
        ghosts = 1000 * float(re.search(r"([\d.]+) ghosts per particle", said)[1])
        refreshes, messages, numbers = map(int, re.search(
            r"(\d+) refreshes in (\d+) messages with (\d+) numbers", said).groups())
        steps = json.loads((self.folder / "p2" / "results.json").read_text())["steps"]
        self.assertEqual(deals, 2)  # of which one at the start, and the other before the second sweep of a step
        self.assertEqual(refreshes, 2 * steps + 2)  # and two for the first forces of each stage
        self.assertEqual(messages, 2 * refreshes)
        self.assertEqual(numbers, round(ghosts * ((steps + 1) * (5 + 7) + 8)))

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


    def test_what_one_process_finds_ends_all(self):
        alone = self.call(0, *self.written(UNSTABLE.replace("RETRY", "0")), "-o", "alone", "-q")
        together = self.call(2, *self.written(UNSTABLE.replace("RETRY", "0")), "-o", "together", "-q")
        self.assertEqual(alone.returncode, 3)
        self.assertEqual(together.returncode, 3, together.stderr)
        words = re.search(r"scarp: (step .*)", alone.stderr)[1]
        self.assertIn(f"scarp-lammps: {words}", together.stderr)
        for folder in ("alone", "together"):
            results = json.loads((self.folder / folder / "results.json").read_text())
            self.assertEqual(results["failure"], words)
            self.assertTrue(list((self.folder / folder / "frames").glob("soil_*.hdf")))

    def written(self, scene):
        (self.folder / "scene.toml").write_text(scene)
        return "run", "scene.toml"

    def test_bad_input_is_said_once_and_ends_all(self):
        few = SLIDE.split("[[material]]")[0] + "[[material]]" + UNSTABLE.split("[[material]]")[1]
        few = scene_of(few).replace("0.5 m", "1 m").replace("[1, 4]", "[2, 1]").replace("[1, 6]", "[2, 6]").replace("cfl = 1.5", "cfl = 0.2").replace(
            "RETRY", "0")
        for scene, processes, words in (
                (scene_of(SLIDE).replace("density = 2000.0", "density = -1"), 2, "key 'material[0].density' = -1"),
                (scene_of(SLIDE, numerics="sleep = 0.01"), 2, "not offered by scarp-lammps: soil asleep"),
                (few, 4, "4 processes for 2 particles. Try at most as many processes as particles")):
            with self.subTest(words=words):
                done = self.call(processes, *self.written(scene), "-o", "bad", "-q")
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertEqual(done.stderr.count(words), 1, done.stderr)
        done = self.call(2, "fos", "scene.toml")
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr.count("not offered by scarp-lammps: fos"), 1, done.stderr)


class LongTest(Comparison):
    def test_lost_soil(self):
        alone, _ = self.run_scene(0, FALL, code=4)
        together, _ = self.run_scene(3, FALL, code=4)
        failures = [json.loads((folder / "results.json").read_text())["failure"] for folder in (alone, together)]
        self.assertEqual(failures[0], failures[1])
        self.assertRegex(failures[0], r"soil was lost: \d+ of 100 particles")

    def test_retry(self):
        """Goes back with shorter steps, in all processes, until it stands."""
        together, said = self.run_scene(2, UNSTABLE.replace("RETRY", "3"))
        self.assertIn("Retry 2 of 3", said)
        self.assertTrue(json.loads((together / "results.json").read_text())["complete"])

    def test_mixed_precision_and_other_models(self):
        scene = scene_of(SLIDE, numerics='precision = "mixed"').replace(
            'cohesion = "2 kPa"', 'model = "mohr_coulomb"\ncohesion = "2 kPa"\nresidual_cohesion = "1 kPa"\n'
            'softening_slip = "0.2 m"')
        # Records are of single precision relative to an origin of their own.
        self.compare(scene, counts=(2,), precision=2.0**-24)

    def test_a_killed_process_ends_all_and_the_last_checkpoint_is_there(self):
        scene = scene_of(SLIDE).replace("0.08 s", "0.5 s")
        (self.folder / "scene.toml").write_text(scene)
        process = subprocess.Popen(self.command(2, "run", "scene.toml", "-o", "killed", "-q"), cwd=self.folder, text=True,
                                   env=ENVIRONMENT, stderr=subprocess.PIPE)
        checkpoints = self.folder / "killed" / "checkpoints"
        end = time.monotonic() + 100.0
        while not (checkpoints.is_dir() and list(checkpoints.glob("step_*.h5"))):
            self.assertLess(time.monotonic(), end)
            time.sleep(0.01)
        children = subprocess.run(["pgrep", "-P", str(process.pid)], capture_output=True, text=True, check=True)
        os.kill(int(children.stdout.split()[-1]), signal.SIGKILL)
        _, said = process.communicate(timeout=60)
        self.assertNotEqual(process.returncode, 0)
        self.assertIn("killed", said.lower())
        done = self.call(2, "resume", "killed", "-q")
        self.assertEqual(done.returncode, 0, done.stderr)
        alone, _ = self.run_scene(0, scene)
        self.assert_equal_to_round_off(alone, self.folder / "killed")

    def test_slide_paper(self):
        self.compare(scene_of(SLIDE, "paper"), counts=(2, 4))

    def test_column_across_cuts(self):
        said = self.compare(scene_of(COLUMN, duration="0.12"), counts=(2, 4), spacing=0.02)
        self.assertGreater(int(re.search(r"(\d+) particles moved", said)[1]), 10)

    def test_uncorrected_forces(self):
        self.compare(scene_of(SLIDE, numerics="force_correction = false"), counts=(2,))

    def test_cut_once_and_a_part_runs_empty(self):
        """The column leaves the part at its top, whose cuts stay; the others have all soil."""
        scene = scene_of(COLUMN, duration="0.4")
        alone, _ = self.run_scene(0, scene)
        together, said = self.run_scene(4, scene, "--cut-once")
        self.assert_equal_to_round_off(alone, together, spacing=0.02)
        self.assertGreater(float(re.search(r"([\d.]+) at most", said)[1]), 1.5)


if __name__ == "__main__":
    unittest.main()
