# SPDX-License-Identifier: BSD-3-Clause
"""A small slide, run by the program, and when two runs of it count as the same."""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

import h5py
import numpy

SCARP = sys.argv.pop(1)

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
[[body]]
material = "clay"
polygon = [[0, 0], [24, 0], [24, 5], [20, 5], [12, 13], [0, 13]]
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
duration = "0.1 s"
[[stage]]
name = "fail"
strength_reduction = 2
duration = "0.9 s"
[[probe]]
name = "crest"
at = [12, 13]
[output]
every = "50 ms"
energy = true
[checkpoint]
every = "20 ms"
on_error = "stop"
"""


def state_of(checkpoint):
    """Every dataset but the time that the run took."""
    found = {}
    with h5py.File(checkpoint, "r") as file:
        file.visititems(lambda name, item: found.update({name: numpy.array(item)})
                        if isinstance(item, h5py.Dataset) and name != "outputs/wall_seconds" else None)
    return found


# Goes wrong with the time step of its start at step 1400, and back to step 500: a state that is no checkpoint.
RETRY = """title = "Column with a step too long"
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
polygon = [[0, 0], [1, 0], [1, 4], [0, 4]]
[[wall]]
name = "box"
kind = "free_slip"
box = {min = [0, 0], max = [1, 6], open = ["+y"]}
[[stage]]
name = "settle"
duration = "2.5 s"
damping = 30
[[probe]]
name = "top"
at = [0.5, 4]
[numerics]
integrator = "verlet"
cfl = 0.5465
[run]
retry = 3
[output]
every = "100 ms"
energy = true
[checkpoint]
every = "50 ms"
on_error = "stop"
"""


class SlideRun(unittest.TestCase):
    """Tests that run the slide; the first argument of the script is the path of scarp."""

    preset = "modern"
    scene = SLIDE
    says = ""  # what the run that is left alone has to say

    @classmethod
    def setUpClass(cls):
        cls.shared = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.shared.cleanup)
        cls.undisturbed = None

    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        self.addCleanup(self.temporary.cleanup)
        (self.folder / "slide.toml").write_text(self.scene.replace("PRESET", self.preset))

    def scarp(self, *arguments, **options):
        return subprocess.run([SCARP, *arguments], cwd=self.folder, capture_output=True, text=True, timeout=100,
                              check=False, **options)

    def start(self, *arguments):
        process = subprocess.Popen([SCARP, *arguments], cwd=self.folder, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.stderr.close)
        return process

    def checkpoints(self, run):
        return sorted((self.folder / run / "checkpoints").glob("step_*.h5"))

    def wait_for_checkpoints(self, run, count=1):
        end = time.monotonic() + 60
        while len(self.checkpoints(run)) < count:
            self.assertLess(time.monotonic(), end, "no checkpoint came")
            time.sleep(0.002)

    def whole(self):
        """A copy of the run that was left alone."""
        cls = type(self)
        if cls.undisturbed is None:
            began = time.monotonic()
            done = self.scarp("run", "slide.toml", "-o", cls.shared.name + "/whole", "--threads", "1", "-q")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stderr, f"(?s)^{self.says}$")
            cls.undisturbed = pathlib.Path(cls.shared.name) / "whole"
            cls.takes = time.monotonic() - began
        shutil.copytree(cls.undisturbed, self.folder / "whole")
        return self.folder / "whole"

    def expect_equal_runs(self, whole, other):
        """Tables and frames byte for byte, the state at the end bit for bit."""
        names = sorted(p.relative_to(whole) for p in [*whole.glob("*.csv"), *(whole / "frames").iterdir()])
        self.assertEqual(names, sorted(p.relative_to(other) for p in [*other.glob("*.csv"),
                                                                      *(other / "frames").iterdir()]))
        self.assertGreater(len(names), 20)
        for name in names:
            self.assertEqual((whole / name).read_bytes(), (other / name).read_bytes(), name)
        one, two = self.checkpoints(whole), self.checkpoints(other)
        self.assertEqual([p.name for p in one], [p.name for p in two])
        self.assertEqual(len(one), 2)
        first, second = state_of(one[-1]), state_of(two[-1])
        self.assertEqual(first.keys(), second.keys())
        for name, values in first.items():
            self.assertEqual(values.tobytes(), second[name].tobytes(), name)
        results = [json.loads((run / "results.json").read_text()) for run in (whole, other)]
        for key in ("complete", "steps", "stages", "measures", "simulated_s", "retries"):
            self.assertEqual(results[0][key], results[1][key], key)
