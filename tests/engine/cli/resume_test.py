# SPDX-License-Identifier: BSD-3-Clause
"""A run that is stopped or killed goes on to the very same end.

Usage: resume_test.py PATH_OF_SCARP [--kills N] [TEST...]"""

import json
import os
import random
import shutil
import signal
import sys
import time
import unittest

from slide_run import SLIDE, SlideRun

KILLS = 4
if "--kills" in sys.argv:
    place = sys.argv.index("--kills")
    KILLS = int(sys.argv[place + 1])
    del sys.argv[place:place + 2]


class ResumeTest(SlideRun):
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
