# SPDX-License-Identifier: BSD-3-Clause
"""A run that is stopped, killed or short of disk goes on to the very same end.

Usage: resume_test.py PATH_OF_SCARP [--kills N] [TEST...]"""

import fcntl
import json
import os
import pathlib
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import h5py
import numpy

SCARP = sys.argv.pop(1)
KILLS = 4
if "--kills" in sys.argv:
    place = sys.argv.index("--kills")
    KILLS = int(sys.argv[place + 1])
    del sys.argv[place:place + 2]

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


class ResumeTest(unittest.TestCase):
    preset = "modern"

    @classmethod
    def setUpClass(cls):
        cls.shared = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.shared.cleanup)
        cls.undisturbed = None

    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        self.addCleanup(self.temporary.cleanup)
        (self.folder / "slide.toml").write_text(SLIDE.replace("PRESET", self.preset))

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
            self.assertEqual((done.returncode, done.stderr), (0, ""))
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
        one, two = self.checkpoints(whole.name), self.checkpoints(other.name)
        self.assertEqual([p.name for p in one], [p.name for p in two])
        self.assertEqual(len(one), 2)
        first, second = state_of(one[-1]), state_of(two[-1])
        self.assertEqual(first.keys(), second.keys())
        for name, values in first.items():
            self.assertEqual(values.tobytes(), second[name].tobytes(), name)
        results = [json.loads((run / "results.json").read_text()) for run in (whole, other)]
        for key in ("complete", "steps", "stages", "measures", "simulated_s"):
            self.assertEqual(results[0][key], results[1][key], key)

    def test_a_signal_leaves_a_checkpoint_and_resume_goes_on(self):
        whole = self.whole()
        for k, number in enumerate((signal.SIGTERM, signal.SIGINT)):
            process = self.start("run", "slide.toml", "-o", f"cut{k}", "--threads", "1")
            self.wait_for_checkpoints(f"cut{k}")
            process.send_signal(number)
            said = process.stderr.read()
            self.assertEqual(process.wait(60), 130)
            self.assertIn(f"scarp resume cut{k}", said)
            self.assertEqual(json.loads((self.folder / f"cut{k}" / "results.json").read_text())["complete"], False)
            done = self.scarp("resume", f"cut{k}", "--threads", "3")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("goes on at step", done.stderr)
            self.expect_equal_runs(whole, self.folder / f"cut{k}")
        again = self.scarp("resume", "cut0")
        self.assertEqual(again.returncode, 0)
        self.assertIn("complete", again.stderr)

    def test_kills_at_any_moment_lose_nothing(self):
        whole = self.whole()
        takes = self.takes
        chance = random.Random(7)
        survived, starts = 0, 0
        while survived < KILLS:
            run = self.folder / f"killed{starts}"
            starts += 1
            command = ("run", "slide.toml", "-o", run.name, "--threads", "1", "-q")
            while True:
                process = self.start(*command)
                time.sleep(chance.uniform(0.0, 0.7 * takes))
                process.kill()
                code = process.wait(60)
                self.assertIn(code, (0, -signal.SIGKILL), process.stderr.read())
                if code == 0:
                    break  # reached its end first
                survived += 1
                if not (run / "run.json").exists():
                    continue  # so early that nothing has begun
                found = self.checkpoints(run.name)
                self.assertLessEqual(len(found), 3)  # a third between writing and removing
                command = ("resume", run.name, "-q")
            self.expect_equal_runs(whole, run)
            shutil.rmtree(run)
        print(f"{survived} kills, {starts} runs, each ended as the run of {takes:.2f} s that was left alone",
              file=sys.stderr)

    def test_resume_before_the_first_checkpoint_starts_over(self):
        whole = self.whole()
        shutil.copytree(whole, self.folder / "early")
        for path in self.checkpoints("early"):
            path.unlink()
        (self.folder / "early" / "results.json").unlink()
        with open(self.folder / "early" / "probes.csv", "a", encoding="utf-8") as table:
            table.write("half a row")
        done = self.scarp("resume", "early")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("starts over", done.stderr)
        self.expect_equal_runs(whole, self.folder / "early")

    def test_a_damaged_checkpoint_leaves_the_one_before(self):
        whole = self.whole()
        run = self.folder / "damaged"
        shutil.copytree(whole, run)
        (run / "results.json").unlink()
        newest = self.checkpoints("damaged")[-1]
        data = bytearray(newest.read_bytes())
        data[len(data) // 2] ^= 4
        newest.write_bytes(data)
        (newest.with_suffix(".h5.part")).write_bytes(b"half")
        done = self.scarp("resume", "damaged")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("is damaged", done.stderr)
        self.expect_equal_runs(whole, run)
        self.assertEqual(list((run / "checkpoints").glob("*.part")), [])
        for path in self.checkpoints("damaged"):
            path.write_bytes(b"")
        (run / "results.json").unlink()
        done = self.scarp("resume", "damaged")
        self.assertEqual(done.returncode, 1)
        self.assertIn("is empty", done.stderr)
        self.assertIn("no checkpoint can be used", done.stderr)

    def test_rows_or_frames_that_are_gone_are_missed(self):
        whole = self.whole()
        for name in ("probes.csv", "frames/soil_00003.hdf"):
            run = self.folder / "gone"
            shutil.copytree(whole, run)
            (run / "results.json").unlink()
            (run / name).unlink()
            done = self.scarp("resume", "gone")
            self.assertEqual(done.returncode, 1)
            self.assertIn(name.rsplit("/", maxsplit=1)[-1], done.stderr)
            shutil.rmtree(run)

    def test_two_runs_do_not_share_a_folder(self):
        (self.folder / "out").mkdir()
        with open(self.folder / "out" / ".lock", "w", encoding="utf-8") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            done = self.scarp("run", "slide.toml", "-o", "out")
            self.assertEqual(done.returncode, 1)
            self.assertIn("another run is writing there", done.stderr)
            self.assertEqual([p.name for p in (self.folder / "out").iterdir()], [".lock"])

    def test_a_new_run_forgets_the_checkpoints_of_the_old_one(self):
        self.whole()
        (self.folder / "slide.toml").write_text(SLIDE.replace("PRESET", self.preset).replace("2 kPa", "3 kPa"))
        process = self.start("run", "slide.toml", "-o", "whole", "-q")
        while json.loads((self.folder / "whole" / "run.json").read_text())["text"].find("3 kPa") < 0:
            time.sleep(0.002)
        self.wait_for_checkpoints("whole", 2)
        process.kill()
        process.wait()
        done = self.scarp("resume", "whole", "-q")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        other = self.scarp("run", "slide.toml", "-o", "other", "-q")
        self.assertEqual(other.returncode, 0)
        self.expect_equal_runs(self.folder / "other", self.folder / "whole")

    def limited(self, size, *arguments):
        """With files of `size` bytes at most: a write beyond fails as on a full disk."""
        return self.scarp(*arguments, restore_signals=False,  # SIGXFSZ stays ignored
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))

    def test_a_checkpoint_that_cannot_be_written(self):
        whole = self.whole()
        size = self.checkpoints("whole")[0].stat().st_size
        largest_output = max(p.stat().st_size for p in [*whole.glob("*.csv"), *(whole / "frames").iterdir()])
        self.assertLess(largest_output, size // 2)
        stopped = self.limited(size // 2, "run", "slide.toml", "-o", "full", "-q")
        self.assertEqual(stopped.returncode, 1)
        self.assertIn("File too large", stopped.stderr)
        self.assertIn("scarp resume full", stopped.stderr)
        self.assertEqual(list((self.folder / "full" / "checkpoints").iterdir()), [])
        self.assertEqual(self.scarp("resume", "full", "-q").returncode, 0)
        self.expect_equal_runs(whole, self.folder / "full")
        scene = (self.folder / "slide.toml").read_text()
        (self.folder / "slide.toml").write_text(scene.replace('"stop"', '"continue"'))
        going = self.limited(size // 2, "run", "slide.toml", "-o", "on", "-q")
        self.assertEqual(going.returncode, 0, going.stderr)
        self.assertIn("The run goes on.", going.stderr)
        self.assertEqual((whole / "probes.csv").read_bytes(), (self.folder / "on" / "probes.csv").read_bytes())

    def test_a_frame_or_table_that_cannot_be_written_stops_the_run(self):
        whole = self.whole()
        frame = (whole / "frames" / "soil_00000.hdf").stat().st_size
        (self.folder / "slide.toml").write_text(SLIDE.replace("PRESET", self.preset) + 'wall_every = 0\n')
        for size, word in ((frame // 2, "soil_00000.hdf"), (2000, ".csv")):
            scene = (self.folder / "slide.toml").read_text()
            if word == ".csv":
                (self.folder / "slide.toml").write_text(scene.replace("energy = true", "frames = false"))
            stopped = self.limited(size, "run", "slide.toml", "-o", "short", "-q")
            self.assertEqual(stopped.returncode, 1)
            self.assertIn(word, stopped.stderr)

    def test_a_folder_that_vanishes_stops_the_run(self):
        process = self.start("run", "slide.toml", "-o", "vanishing", "--threads", "1")
        self.wait_for_checkpoints("vanishing")
        (self.folder / "vanishing").rename(self.folder / "elsewhere")
        said = process.stderr.read()
        self.assertEqual(process.wait(60), 1)
        self.assertIn("vanishing", said)
        self.assertEqual(self.scarp("resume", "elsewhere", "-q").returncode, 0)
        self.expect_equal_runs(self.whole(), self.folder / "elsewhere")

    def test_errors_are_told(self):
        (self.folder / "empty").mkdir()
        (self.folder / "file").write_text("")
        for arguments, code, word in ((["resume", "nowhere"], 2, "nowhere"), (["resume"], 2, "folder"),
                                      (["resume", "empty"], 1, "run.json is missing"),
                                      (["run", "slide.toml", "-o", "file"], 1, "cannot be used as output folder")):
            done = self.scarp(*arguments)
            self.assertEqual(done.returncode, code, arguments)
            self.assertIn(word, done.stderr)
        if os.geteuid() != 0:  # root may write anywhere
            (self.folder / "empty").chmod(0o555)
            done = self.scarp("run", "slide.toml", "-o", "empty/run")
            self.assertEqual(done.returncode, 1)
            self.assertIn("Permission denied", done.stderr)


class ResumePaperTest(ResumeTest):
    preset = "paper"


if __name__ == "__main__":
    unittest.main()
