# SPDX-License-Identifier: BSD-3-Clause
"""bench/peers: what its programs print of jobs of a few particles, and what they say where a program is missing. No time is
judged.

Usage: test_peers.py FOLDER_OF_THE_SCRIPTS FOLDER_OF_THE_PROGRAMS [PROGRAM_OF_LAMMPS]"""
import argparse
import contextlib
import importlib.machinery
import importlib.util
import io
import itertools
import os
import subprocess
import sys
import unittest
import unittest.mock

SCRIPTS, PROGRAMS = sys.argv[1:3]
LMP = sys.argv[3] if len(sys.argv) > 3 else None
del sys.argv[1:]
sys.path.insert(0, SCRIPTS)
loader = importlib.machinery.SourceFileLoader("lammps_script", os.path.join(SCRIPTS, "lammps"))
lammps = importlib.util.module_from_spec(importlib.util.spec_from_loader("lammps_script", loader))
loader.exec_module(lammps)
turns = lammps.turns


def script(name, *words):
    return subprocess.run([sys.executable, os.path.join(SCRIPTS, name), *words], capture_output=True, text=True, timeout=250)


class Peers(unittest.TestCase):
    def test_turns_change_who_is_first(self):
        order = []
        measured = turns.in_turns(2, 3, lambda which: order.append(which) or len(order))
        self.assertEqual(order, [0, 1, 1, 0, 0, 1])
        self.assertEqual(measured, [[1, 4, 5], [2, 3, 6]])

    def test_pairs_of_a_lattice(self):
        side = 5
        points = list(itertools.product(range(side), repeat=3))
        pairs = sum(0 < sum((a - b) ** 2 for a, b in zip(p, q)) < 2.4**2 for p in points for q in points)
        self.assertAlmostEqual(lammps.pairs_per_particle(side), pairs / side**3)

    def test_a_scene_takes_values_and_numerics(self):
        text = turns.scene_text("column.toml", "paper/mixed", spacing=0.02)
        self.assertIn('preset = "paper"', text)
        self.assertIn('precision = "mixed"', text)
        self.assertIn("\nspacing = 0.02\n", text)
        with self.assertRaisesRegex(RuntimeError, "nothing = "):
            turns.scene_text("column.toml", "paper/mixed", nothing=1)

    def test_a_failing_program_is_named_with_what_it_said(self):
        with self.assertRaisesRegex(RuntimeError, "exit code 3\n.*out of sand"):
            turns.cpu_seconds_and_output(["sh", "-c", "echo out of sand; exit 3"])

    def test_a_coarse_column_in_turns_of_two_builds(self):
        done = script("column", PROGRAMS, PROGRAMS, "--spacing", "0.025", "--duration", "0.001", "--turns", "1",
                      "--numerics", "modern/double")
        self.assertEqual(done.returncode, 0, done.stderr)
        _, first, second = done.stdout.splitlines()
        steps, front, crest = (first.split()[column] for column in (6, 8, 9))
        self.assertGreater(int(steps), 0)
        # It has hardly moved in a millisecond: the outermost particles are a quarter to three quarters of a spacing inside
        # the mantle, the highest half a spacing below the top.
        self.assertTrue(0.1 - 0.75 * 0.025 < float(front) < 0.1, first)
        self.assertAlmostEqual(float(crest), 0.1 - 0.5 * 0.025, delta=1e-4)
        self.assertEqual((steps, front, crest), tuple(second.split()[column] for column in (6, 8, 9)))

    def test_a_missing_lammps_is_named_with_its_package(self):
        done = script("lammps", PROGRAMS, "--lmp", "/nowhere/lmp")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("no program '/nowhere/lmp'", done.stderr)
        self.assertIn("cmake/setup.sh lammps", done.stderr)

    @unittest.skipUnless(LMP, "needs LAMMPS")
    def test_the_styles_of_lammps_and_scarp_take_the_same_lattice(self):
        options = argparse.Namespace(build=PROGRAMS, lmp=LMP, liggghts="/nowhere/liggghts", side=6)
        with contextlib.redirect_stderr(io.StringIO()) as said:
            rows = {row.name: row for row in lammps.contestants(options)}
        self.assertIn("'/nowhere/liggghts'", said.getvalue())
        self.assertEqual([name for name in rows if name.startswith("LAMMPS")],
                         ["LAMMPS peri/lps", "LAMMPS peri/eps", "LAMMPS lj/cut"])
        for name, row in rows.items():
            if name.startswith("LAMMPS"):
                self.assertEqual(row.timed(2)[1], 2)
        seconds, steps = rows["scarp paper/mixed"].timed(3)
        self.assertGreater(seconds, 0.0)
        self.assertGreater(steps, 0)
        rows["LAMMPS lj/cut"].particles += 1
        with self.assertRaisesRegex(RuntimeError, "made 216 particles in place of 217"):
            rows["LAMMPS lj/cut"].timed(2)

    def test_the_start_is_taken_off_and_times_are_of_a_particle_and_step(self):
        class Row:
            def __init__(self, name, each):
                self.name, self.each, self.particles = name, each, 8

            def timed(self, steps):
                """A second for the start."""
                return 1.0 + self.each * steps, steps

        rows = [Row("one", 8e-6), Row("two", 24e-6)]
        with unittest.mock.patch.object(lammps, "contestants", lambda options: rows), \
                contextlib.redirect_stdout(io.StringIO()) as said:
            lammps.main([PROGRAMS, "--side", "2", "--steps", "10", "--turns", "3"])
        first, second = said.getvalue().splitlines()[2:]
        # 8 particles: 1000 and 3000 ns a particle and step; the 8 corners of a cube are all within 2.4 spacings: 7 pairs.
        self.assertEqual(first.split(), "one 1000 (1000 to 1000) 142.86 1.00 (1.00 to 1.00)".split())
        self.assertEqual(second.split(), "two 3000 (3000 to 3000) 428.57 3.00 (3.00 to 3.00)".split())


if __name__ == "__main__":
    unittest.main()
