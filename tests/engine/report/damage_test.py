# SPDX-License-Identifier: BSD-3-Clause
"""No folder, however damaged, ends `scarp report` in a traceback or asks it for a picture without end.

Usage: damage_test.py FOLDER_OF_THE_REPORT_SCRIPTS [--all] [TEST...]; --all: every damage to every file."""

import contextlib
import copy
import io
import itertools
import json
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

from run_folder import lattice, write_converge, write_fos, write_frame, write_run

SCRIPTS = str(pathlib.Path(sys.argv.pop(1)).resolve())
EVERY = "--all" in sys.argv
if EVERY:
    sys.argv.remove("--all")
# Any text, so that the data of the moving picture is made; nobody looks at it.
os.environ["SCARP_VIEWER"] = str(pathlib.Path(__file__).with_name("run_folder.py"))
sys.path.insert(0, SCRIPTS)
import scarp_figures  # noqa: E402
import scarp_frames  # noqa: E402
import scarp_report  # noqa: E402


def half(path):
    data = path.read_bytes()
    path.write_bytes(data[:len(data) // 2])


def garbage(path):
    path.write_bytes(bytes(np.random.default_rng(3).integers(0, 256, 5000, dtype=np.uint8)))


def flipped(path):
    data = bytearray(path.read_bytes())
    for place in np.random.default_rng(4).integers(0, len(data), 40):
        data[place] ^= 1 << (place % 8)
    path.write_bytes(data)


def folder_instead(path):
    path.unlink()
    path.mkdir()


DAMAGES = {"removed": lambda path: path.unlink(), "empty": lambda path: path.write_bytes(b""), "half": half,
           "garbage": garbage, "flipped": flipped, "a list": lambda path: path.write_text("[1, 2]"),
           "a text": lambda path: path.write_text("time,stage,x\nlater,s,y\nnow,s,z\n"), "a folder": folder_instead}


WRONG = ("x", [], {}, None, 7, [1, "y"], math.inf, True, "<b>")


def is_shown(name):
    """Of the run of the failure the page of a factor of safety shows the frames alone."""
    return name.parts[:2] != ("fos", "failure") or "frames" in name.parts


class DamageTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def drawn(self, folder):
        """What the program would say, and whether there is a page; fails on whatever would be a traceback."""
        said = io.StringIO()
        with contextlib.redirect_stderr(said), contextlib.redirect_stdout(io.StringIO()):
            try:
                scarp_report.in_words(lambda: scarp_report.main([str(folder)]), str(folder))
            except SystemExit as end:
                self.assertIsInstance(end.code, str)  # a sentence, and exit code 1
                self.assertRegex(end.code, r"^scarp report: '.*'.*\.$")
                return end.code, False
        return said.getvalue(), True

    def test_every_file_damaged_in_every_way(self):
        whole = self.folder / "whole"
        (whole / "run").mkdir(parents=True)
        write_run(whole / "run", lattice(8, 4), complete=True, measures=[{"name": "m", "value": 1.0, "unit": "m"}])
        (whole / "fos").mkdir()
        write_fos(whole / "fos", lattice(8, 4))
        (whole / "converge").mkdir()
        write_converge(whole / "converge")
        ways, number = itertools.cycle(DAMAGES), itertools.count()
        for kind in ("run", "fos", "converge"):
            for path in sorted(p for p in (whole / kind).rglob("*") if p.is_file()):
                name = path.relative_to(whole)
                for way in DAMAGES if EVERY else [next(ways)]:
                    with self.subTest(file=str(name), way=way):
                        copied = self.folder / f"copied{next(number)}"
                        shutil.copytree(whole, copied)
                        DAMAGES[way](copied / name)
                        words, page = self.drawn(copied / kind)
                        told = way == "garbage" or way in ("empty", "a list") and name.suffix == ".json"
                        if told and is_shown(name):
                            self.assertIn(name.name, words)
                        self.assertNotIn("Traceback", words)

    def test_every_value_of_results_of_a_wrong_kind(self):
        """Without frames and tables, so that a page is quick."""
        results = {"case": "c", "title": "t", "pass": True, "complete": True, "failure": None, "particles": 4, "steps": 9,
                   "spacing": 0.5, "wall_s": 1.0, "step_limits": {"acoustic": 9}, "signal_material": "clay",
                   "retries": [{"step": 3, "back_to": 1, "step_factor": 0.5, "reason": "r"}],
                   "measures": [{"name": "m", "value": 1.0, "unit": "m", "band": [0, 2], "pass": True}],
                   "stages": [{"name": "s", "end_time_s": 1.0, "reached_rest": True}],
                   "profile": [{"phase": "watch", "wall_s": 0.5}], "machine": {"processor": "p"},
                   "versions": {"scarp": "1"}, "numerics": {"cfl": 0.2}, "figures": [{"file": "a.png", "caption": "b"}]}

        wrongs = itertools.cycle(WRONG)

        def places(value, path=()):
            yield path
            for key, inner in (value.items() if isinstance(value, dict) else
                               enumerate(value) if isinstance(value, list) else ()):
                yield from places(inner, (*path, key))
        for path in list(places(results))[1:]:
            for wrong in WRONG if EVERY else [next(wrongs)]:
                changed = copy.deepcopy(results)
                inner = changed
                for key in path[:-1]:
                    inner = inner[key]
                inner[path[-1]] = wrong
                (self.folder / "results.json").write_text(json.dumps(changed))
                with self.subTest(place=path, wrong=wrong):
                    words, page = self.drawn(self.folder)
                    self.assertTrue(page, words)

    def test_frames_that_hold_nothing_or_too_much(self):
        frame = self.folder / "frame.hdf"
        for change in (lambda f: f["VTKHDF"].__delitem__("Points"), lambda f: f.__delitem__("VTKHDF"),
                       lambda f: f.attrs.__setitem__("spacing", 0.0), lambda f: f.attrs.__setitem__("spacing", np.nan),
                       lambda f: f.attrs.__setitem__("dimension", [7]), lambda f: f.attrs.__delitem__("spacing"),
                       lambda f: f.attrs.__setitem__("time", np.bytes_("soon")),
                       lambda f: f["VTKHDF/PointData"].__setitem__("short", np.zeros(3))):
            write_frame(frame, lattice(4, 4))
            with h5py.File(frame, "r+") as file:
                change(file)
            with self.assertRaisesRegex(scarp_frames.Damaged, "frame.hdf"):
                scarp_frames.load_frame(frame)
        write_frame(frame, np.full((5, 3), np.nan))
        with self.assertRaisesRegex(scarp_frames.Damaged, "no particle"):
            scarp_frames.load_frame(frame)
        with h5py.File(frame, "w") as file:  # says it holds 24 TB, and is a kilobyte long
            file.attrs.update(time=0.0, dimension=[2], spacing=0.25)
            file.create_group("VTKHDF").create_dataset("Points", (10**12, 3), "f8", chunks=(1000, 3))
            file["VTKHDF"].create_group("PointData")
        with self.assertRaisesRegex(scarp_frames.Damaged, "more than it has"):
            scarp_frames.load_frame(frame)

    def test_a_stray_grain_is_left_out_of_the_picture_and_told(self):
        for dimension, size in ((2, (16, 8)), (3, (8, 6, 4))):
            run = self.folder / f"stray{dimension}"
            position = lattice(*size)
            position[5] = [600.0, 400.0, 0.0 if dimension == 2 else -500.0]
            write_run(run, position, dimension)
            scarp_report.report(run)
            text = (run / "report.html").read_text(encoding="utf-8")
            self.assertRegex(text, "1 grain lies outside this picture, the farthest [5-7]\\d\\d m away")
            self.assertNotIn("Left out", text)
            last = scarp_frames.load_frame(run / "frames/soil_00001.hdf")
            seen, words = scarp_figures.in_view(last)
            self.assertEqual((len(seen["position"]), len(last["position"])), (len(position) - 1, len(position)))
            (line,) = scarp_figures.outline(last) if dimension == 2 else [None]
            self.assertTrue(line is None or line.max() < 10)

    def test_soil_that_ran_far_is_shown_whole(self):
        # A fan whose density falls off evenly to ten times the height: nothing stands apart.
        position = np.stack([np.linspace(0, 40, 2000) ** 1.2, np.random.default_rng(1).uniform(0, 4, 2000),
                             np.zeros(2000)], axis=1)
        write_frame(self.folder / "frame.hdf", position)
        frame = scarp_frames.load_frame(self.folder / "frame.hdf")
        self.assertEqual(scarp_figures.in_view(frame), (frame, ""))
        write_frame(self.folder / "frame.hdf", lattice(1, 1))
        self.assertEqual(len(scarp_figures.in_view(scarp_frames.load_frame(self.folder / "frame.hdf"))[0]["position"]), 1)

    def test_the_program_ends_with_a_sentence(self):
        for folder, word in (("empty", "there is no run in it"), ("missing", "is no folder")):
            if folder == "empty":
                (self.folder / folder).mkdir()
            done = subprocess.run([sys.executable, SCRIPTS + "/scarp_report.py", folder], cwd=self.folder, text=True,
                                  capture_output=True, check=False, timeout=100)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertRegex(done.stderr, rf"^scarp report: '{folder}'.*{word}.*\n$")


if __name__ == "__main__":
    unittest.main()
