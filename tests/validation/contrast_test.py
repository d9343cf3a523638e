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
            # The column is shorter by rho g H/(2 M) = 0.3 and 1.2 %, and so is the step's h/c: the first order is half.
            self.assertAlmostEqual(softer / steps[0], 0.5, delta=0.02)
            # Four times the settlement. Under the weight the strain at the base is 0.6 and 2.3 %: of second order in it.
            for change in row[7].split(","):
                self.assertAlmostEqual(float(change.strip(" %")), 300.0, delta=12.0)

    def test_a_scaled_part_settles_as_the_heavy_one_does(self):
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder) / "ground.toml"
            scene.write_text((FOLDER / "ground.toml").read_text().replace('"0.25 m"', '"1 m"'))
            table = self.run_script("measure.py", scene, "--contrast", "100", "--reduced", "10", "--scaled", "100")
        names = [row[0] for row in table]
        self.assertEqual(names, ["as it is", "soft everywhere", "contrast 10", "mass_scaling 100"])
        error = {row[0]: float(row[5].strip("%")) for row in table}
        # The probe follows the particle at 9.5 m of 10: its way is gamma (37.5/M_stiff + 12.375/M_soft). The place of the interface
        # is known to first order in the spacing: 0.9 % of the settlement at 0.25 m (THEORY, section 13), four times that at 1 m.
        for name, contrast in (("soft everywhere", 1), ("contrast 10", 10)):
            expected = (37.5 / contrast + 12.375) / (37.5 / 100 + 12.375)
            self.assertAlmostEqual((1 + error[name] / 100) / expected, 1, delta=0.04, msg=name)
        # Of the scaled part the same at rest; `rest_velocity` leaves 1e-5 m/s over the passage of a wave.
        self.assertLess(error["mass_scaling 100"], 1.0)


if __name__ == "__main__":
    unittest.main()
