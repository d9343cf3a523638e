# SPDX-License-Identifier: BSD-3-Clause
"""The report reads frames and tables as they were written and draws every kind of run.

Usage: report_test.py FOLDER_OF_THE_REPORT_SCRIPTS"""

import pathlib
import sys
import tempfile
import unittest

import numpy as np

from run_folder import lattice, write_frame, write_run

sys.path.insert(0, sys.argv.pop(1))
import scarp_figures  # noqa: E402
import scarp_frames  # noqa: E402
import scarp_page  # noqa: E402
import scarp_report  # noqa: E402


class ReportTest(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def frame(self, position, **values):
        write_frame(self.folder / "frame.hdf", position, **values)
        return scarp_frames.load_frame(self.folder / "frame.hdf")

    def test_frame_gives_back_what_was_written(self):
        frame = self.frame(lattice(3, 2), time=1.5)
        self.assertEqual(frame["time"], 1.5)
        self.assertEqual(frame["stage"], "fail")
        self.assertEqual(frame["dimension"], 2)
        np.testing.assert_array_equal(frame["position"], lattice(3, 2))
        self.assertEqual(frame["units"]["displacement"], "m")

    def test_scalar_is_length_or_component(self):
        frame = self.frame(lattice(3, 2))
        np.testing.assert_allclose(scarp_frames.scalar(frame, "displacement"), 5.0 * np.arange(6))
        np.testing.assert_allclose(scarp_frames.scalar(frame, "stress_xy"), 4.0)
        np.testing.assert_allclose(scarp_frames.scalar(frame, "displacement_y"), 4.0 * np.arange(6))
        with self.assertRaisesRegex(KeyError, "no field 'heat'"):
            scarp_frames.scalar(frame, "heat")

    def test_particles_that_are_nowhere_are_left_out(self):
        position = lattice(3, 2)
        position[2] = np.nan
        frame = self.frame(position)
        self.assertEqual(len(frame["position"]), 5)
        self.assertEqual(len(frame["fields"]["stress"]), 5)

    def test_half_a_row_of_a_killed_run_is_left_out(self):
        write_run(self.folder / "run", lattice(4, 4))
        columns, units = scarp_frames.read_table(self.folder / "run" / "probes.csv")
        np.testing.assert_array_equal(columns["time"], [0, 1])
        self.assertEqual(units["toe.velocity_x"], "m/s")
        self.assertEqual(columns["stage"], ["settle", "fail"])

    def test_a_table_needs_times_only_where_it_is_a_history(self):
        path = self.folder / "slip_band.csv"
        path.write_text("x [m],y [m]\n1,2\n3,4\n", encoding="utf-8")
        columns, units = scarp_frames.read_table(path)
        np.testing.assert_array_equal(columns["y"], [2, 4])
        self.assertEqual(units["x"], "m")
        with self.assertRaisesRegex(scarp_frames.Damaged, "has no column of times"):
            scarp_frames.read_history(path)

    def test_outline_of_a_block_is_its_rectangle(self):
        (line,) = scarp_figures.outline(self.frame(lattice(16, 8)))
        self.assertEqual(len(line), 5)  # four corners and the first again
        # The lines run 1e-4 spacings inside the cells' edges, and floats hold seven digits.
        np.testing.assert_allclose(line.min(axis=0), [0, 0], atol=1e-4)
        np.testing.assert_allclose(line.max(axis=0), [4, 2], atol=1e-4)

    def test_outline_of_a_hole_is_a_second_line(self):
        position = lattice(16, 16)
        hole = np.all(np.abs(position[:, :2] - 2.0) < 0.75, axis=1)
        self.assertEqual(len(scarp_figures.outline(self.frame(position[~hole]))), 2)

    # Shaken by a tenth of the spacing, the edge stays within a spacing of where it was.
    def test_outline_of_disordered_soil_encloses_about_its_area(self):
        position = lattice(16, 8)
        position[:, :2] += 0.025 * np.random.default_rng(1).standard_normal((128, 2))
        lines = scarp_figures.outline(self.frame(position))
        self.assertEqual(len(lines), 1)
        x, y = lines[0].T
        area = 0.5 * abs(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]))
        self.assertAlmostEqual(area, 8.0, delta=0.1 * 8.0)

    def test_only_outer_particles_are_drawn_in_3d(self):
        frame = self.frame(lattice(10, 10, 10), dimension=3)
        frame["position"] *= 1.05  # one particle per cell
        seen = scarp_figures.surface_particles(frame, layers=2)
        self.assertEqual(seen.sum(), 10**3 - 6**3)

    def test_section_is_the_middle_layer(self):
        cut = scarp_figures.section(self.frame(lattice(4, 5, 3), dimension=3))
        self.assertEqual(len(cut["position"]), 4 * 3)
        self.assertEqual(len(cut["fields"]["stress"]), 4 * 3)

    def test_page_of_a_2d_run_has_verdicts_and_figures_inside(self):
        run = self.folder / "slope"
        write_run(run, lattice(16, 8), complete=True, measures=[
            {"name": "run-out <b>", "value": 7.31234, "unit": "m", "reference": 7.0, "band": [6.5, 7.5],
             "source": "a book", "pass": True},
            {"name": "factor of safety", "value": 1.6, "unit": "", "reference": 1.4, "band": [1.3, 1.5],
             "source": "", "pass": False},
            {"name": "speed", "value": None, "unit": "1/s", "reference": None, "band": None, "source": "",
             "pass": None}])
        text = scarp_report.report(run).read_text(encoding="utf-8")
        self.assertIn("7.312", text)
        self.assertIn("6.5 … 7.5", text)
        self.assertIn("run-out &lt;b&gt;", text)
        self.assertNotIn("<b>", text)
        self.assertNotIn("Slope <1>", text)
        for word in ("✓ pass", "✗ fail", "reported"):
            self.assertIn(word, text)
        self.assertEqual(text.count("data:image/png;base64"), 6)  # 2 fields, 4 histories
        self.assertNotIn("src=\"http", text)
        self.assertTrue((run / "figures" / "accumulated_plastic_strain_00001.png").exists())

    def test_page_of_a_3d_run_has_view_plan_and_sections(self):
        run = self.folder / "cuboid"
        write_run(run, lattice(8, 6, 4), dimension=3)
        scarp_report.report(run)
        names = {path.name for path in (run / "figures").iterdir()}
        self.assertLessEqual({"view_00001.png", "plan_00001.png", "section_displacement_00001.png"}, names)

    def test_page_of_a_killed_run_says_so(self):
        run = self.folder / "killed"
        write_run(run, lattice(8, 4))
        (run / "results.json").unlink()
        self.assertIn("no results", scarp_report.report(run).read_text(encoding="utf-8"))

    def test_page_of_a_failed_run_says_why(self):
        run = self.folder / "failed"
        write_run(run, lattice(8, 4), complete=False, failure="step 9: density is nan")
        text = scarp_report.report(run).read_text(encoding="utf-8")
        self.assertIn("step 9: density is nan", text)
        self.assertIn("✗ incomplete", text)

    def test_page_of_a_run_that_lost_soil_says_so_at_its_head(self):
        run = self.folder / "leak"
        lost = {"particles": 2, "mass": 40.0, "first": {}}
        failure = "soil was lost: 2 of 32 particles (6 %)"
        write_run(run, lattice(8, 4), complete=False, finished=True, failure=failure, lost_soil=lost)
        text = scarp_report.report(run).read_text(encoding="utf-8")
        self.assertIn("✗ lost soil", text)
        self.assertIn("reached its end, but soil was lost: 2 of 32", text)
        run = self.folder / "unstable"
        write_run(run, lattice(8, 4), complete=False, finished=False, failure="step 9: speed", lost_soil=lost)
        text = scarp_report.report(run).read_text(encoding="utf-8")
        self.assertIn("did not reach its end: step 9", text)
        self.assertIn("soil was lost: 2 particles", text)

    def test_a_folder_that_is_no_run_gets_no_page(self):
        (self.folder / "empty").mkdir()
        with self.assertRaisesRegex(scarp_report.NoRun, "empty.*no run in it"):
            scarp_report.report(self.folder / "empty")
        self.assertEqual(list((self.folder / "empty").iterdir()), [])

    def test_overall_page_lists_every_run(self):
        write_run(self.folder / "a", lattice(8, 4), **{"measures": [{"name": "m", "value": 1, "pass": True}]})
        write_run(self.folder / "b", lattice(8, 4), **{"complete": False})
        out = scarp_report.overall_page(self.folder / "all.html", [self.folder / "a", self.folder / "b"])
        text = out.read_text(encoding="utf-8")
        self.assertIn('href="#a"', text)
        self.assertIn("1 of 1", text)
        self.assertIn("✗ incomplete", text)

    def test_pictures_from_outside_the_run_are_not_taken(self):
        run = self.folder / "run"
        (self.folder / "secret.png").write_bytes(b"not for the page")
        write_run(run, lattice(8, 4), figures=[{"file": "../secret.png"}])
        page = scarp_page.Page("p")
        scarp_report.own_figures(page, run, scarp_frames.read_results(run))
        self.assertEqual(len(page.parts), 1)

    def test_bands_and_numbers_read_well(self):
        self.assertEqual(scarp_page.band([1, 2.5]), "1 … 2.5")
        self.assertEqual(scarp_page.band([None, 2.5]), "≤ 2.5")
        self.assertEqual(scarp_page.band(0.1), "± 0.1")
        self.assertEqual(scarp_page.number(1234567), "1\u202f234\u202f567")
        self.assertEqual(scarp_page.number(1288.4), "1\u202f288")
        self.assertEqual(scarp_page.number(0.000123456), "0.0001235")
        self.assertEqual(scarp_page.number(None), "")


if __name__ == "__main__":
    unittest.main()
