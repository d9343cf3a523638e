# SPDX-License-Identifier: BSD-3-Clause
"""The scripts of validation/contrast on a column of a few particles.

Usage: contrast_test.py PATH_OF_SCARP"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "validation/contrast"
sys.path[:0] = [str(FOLDER), str(ROOT / "tests/engine/cli")]
import soften  # noqa: E402
from scenes import COLUMN  # noqa: E402

SCARP = sys.argv.pop(1)


def rows(text):
    """The cells of a table, without its head."""
    lines = [line for line in text.splitlines() if line.startswith("| ")]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines[1:]]


class ContrastTest(unittest.TestCase):
    def run_script(self, name, *arguments):
        done = subprocess.run([sys.executable, FOLDER / name, SCARP, *arguments], capture_output=True, text=True,
                              timeout=100, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return rows(done.stdout)

    def test_softer_scenes_keep_what_they_are_told_to(self):
        soft = soften.softened(COLUMN, 0.25, None)
        self.assertIn('youngs_modulus = "2.5 MPa"', soft)
        self.assertNotIn("viscosity_alpha", soft)
        self.assertTrue(soften.softened(COLUMN, 1, 0.2).endswith("[numerics]\nviscosity_alpha = 0.2\n"))
        told = COLUMN + "[numerics]\ncfl = 0.5\nviscosity_alpha = 0.3\n"
        self.assertEqual(soften.softened(told, 1, 0.6), told.replace("cfl = 0.5\nviscosity_alpha = 0.3", "viscosity_alpha = 0.6\ncfl = 0.5"))

    def test_an_elastic_column_settles_by_one_over_its_stiffness(self):
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder) / "column.toml"
            scene.write_text(COLUMN)
            table = self.run_script("soften.py", scene, "--share", "0.25")
        self.assertEqual([row[1] for row in table], ["0.1", "0.1", "0.2"])
        steps = [int(row[2]) for row in table]
        for softer, row in zip(steps[1:], table[1:]):
            # A step goes with the h/c of the densest soil. The base is strained by rho g H/M, 0.6 and 2.3 %, and c goes with the root
            # of 1/rho: 0.9 % between the two.
            self.assertAlmostEqual(softer / steps[0], 0.5, delta=0.005)
            # Four times the settlement, but for what is of second order: the strain of the softer column, 2.3 % of its way.
            for change in row[7].split(","):
                self.assertAlmostEqual((1 + float(change.strip(" %")) / 100) / 4, 1, delta=0.023)

    def test_a_layer_on_stiff_ground_settles_as_the_closed_form_says(self):
        with tempfile.TemporaryDirectory() as folder:
            table = self.run_script("measure.py", FOLDER / "ground.toml", "--contrast", "100", "--reduced", "10", "--scaled", "100")
        # The probe follows the particle nearest to the top, at y = 9.875 m: its way is gamma [5 (10 - 2.5)/M_stiff + (10 (y - 5) -
        # (y^2 - 25)/2)/M_soft]. Where the two meet is known to half a row: as much more or less of soft soil, under gamma 5 m.
        gamma, modulus, y, dx = 2000 * 9.81, 10e6 * 0.7 / (1.3 * 0.4), 9.875, 0.25
        half_a_row = gamma * 5 / modulus * dx / 2
        way = {row[0]: float(row[4]) for row in table}
        for name, contrast in (("as it is", 100), ("soft everywhere", 1), ("contrast 10", 10)):
            expected = gamma / modulus * (37.5 / contrast + 10 * (y - 5) - (y * y - 25) / 2)
            self.assertAlmostEqual(way[name], expected, delta=half_a_row, msg=name)
        # A scaled part is the same at rest: what is slower than 1e-5 m/s goes on by a micrometre in a passage of sound, and the
        # table has 1e-5 m.
        self.assertAlmostEqual(way["mass_scaling 100"], way["as it is"], delta=2e-5)


if __name__ == "__main__":
    unittest.main()
