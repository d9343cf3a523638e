# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the Python module share: small scenes, and the program to compare with."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import scarp

PROGRAM = sys.argv.pop(1) if __name__ != "__main__" and len(sys.argv) > 1 else ""

CLAY = dict(name="clay", density=2000.0, youngs_modulus="10 MPa", poisson_ratio=0.3, cohesion="2 kPa",
            friction_angle="20 deg")


def column(**changes):
    """A column of clay, 1 m by 1 m, that spreads on a rough base; some 100 particles."""
    keys = dict(
        title="Column", dimension=2, spacing="0.1 m", material=CLAY,
        body=dict(material="clay", box=dict(min=[0, 0], max=[1, 1])),
        wall=[dict(name="base", kind="no_slip", line=[[-1, 0], [3, 0]]),
              dict(name="side", kind="free_slip", line=[[0, 2], [0, 0]])],
        initial=dict(stress="geostatic"), stage=dict(name="spread", duration="0.2 s"),
        probe=dict(name="crest", at=[1, 1]), output=dict(every="0.05 s", energy=True))
    return scarp.Scene(**{**keys, **changes})


def slope(spacing="1 m"):
    """A slope of 5 m that settles and then has its strength cut, as `fos` wants it."""
    return scarp.Scene(
        dimension=2, spacing=spacing, material={**CLAY, "cohesion": "10 kPa", "youngs_modulus": "100 MPa"},
        body=dict(material="clay", polygon=[[0, 0], [24, 0], [24, 3], [18, 3], [8, 8], [0, 8]]),
        wall=[dict(name="base", kind="no_slip", line=[[0, 0], [24, 0]]),
              dict(name="sides", kind="free_slip", box=dict(min=[0, 0], max=[24, 12], open=["-y", "+y"]))],
        initial=dict(stress="geostatic", k0=0.5),
        stage=[dict(name="settle", until="rest", duration="2 s", rest_velocity="5 mm/s"), dict(name="fail", duration="1 s")],
        probe=dict(name="crest", at=[8, 8]))


class TestCase(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)

    def program(self, scene, *arguments):
        """Runs the program on a scene and returns what it printed."""
        file = self.folder / "scene.toml"
        scene.save(file)
        command = [PROGRAM, arguments[0], str(file), *map(str, arguments[1:])]
        done = subprocess.run(command, capture_output=True, text=True, cwd=self.folder)
        self.assertEqual(done.returncode, 0, f"{command}: {done.stderr}")
        return done.stdout

    def assert_same(self, first, second, what=""):
        np.testing.assert_array_equal(first, second, what)
