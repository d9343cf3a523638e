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
import zlib

import h5py
import numpy

from slide_run import RETRY, SLIDE, SlideRun

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
            done = self.scarp("resume", f"cut{k}", "--threads", str(min(2, len(os.sched_getaffinity(0)))))
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

    def stopped_copy(self, name):
        """Of the whole run, as if it had been killed right after its end."""
        run = self.folder / name
        shutil.copytree(self.folder / "whole", run)
        (run / "results.json").unlink()
        return run

    def test_rows_that_are_gone_or_changed_are_missed(self):
        whole = self.whole()
        rows = (whole / "probes.csv").read_bytes()
        digit = rows[len(rows) // 3:].index(b"1") + len(rows) // 3
        for name, content in (("gone", None), ("edited", rows[:digit] + b"7" + rows[digit + 1:]),
                              ("short", rows[:len(rows) // 2]), ("empty", b"")):
            run = self.stopped_copy(name)
            (run / "probes.csv").unlink()
            if content is not None:
                (run / "probes.csv").write_bytes(content)
            done = self.scarp("resume", name)
            self.assertEqual(done.returncode, 1)
            for word in ("probes.csv", "--accept-tables", "no checkpoint can be used"):
                self.assertIn(word, done.stderr)
            done = self.scarp("resume", name, "--accept-tables", "-q")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual((whole / "walls.csv").read_bytes(), (run / "walls.csv").read_bytes())
            kept = content[:content.rindex(b"\n") + 1] if content else rows[:rows.index(b"\n") + 1]
            self.assertEqual((run / "probes.csv").read_bytes(), kept)

    def test_rows_changed_since_the_checkpoint_before_leave_that_one(self):
        whole = self.whole()
        run = self.stopped_copy("late")
        rows = (run / "history.csv").read_bytes()
        (run / "history.csv").write_bytes(rows[:-3] + b"9" + rows[-2:])
        done = self.scarp("resume", "late")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("are not those that were written", done.stderr)
        self.expect_equal_runs(whole, run)

    def test_a_run_goes_on_without_frames_that_are_damaged(self):
        whole = self.whole()
        damages = {"soil_00003.hdf": (None, "is gone"), "walls_00005.hdf": (b"", "has 0 bytes instead of"),
                   "soil_00008.hdf": ("flip", "has other bytes"), "soil_00010.hdf": ("pipe", "is no plain file")}
        run = self.stopped_copy("frames")
        for name, (content, _) in damages.items():
            path = run / "frames" / name
            data = bytearray(path.read_bytes())
            path.unlink()
            if content == "pipe":
                os.mkfifo(path)
            elif content is not None:
                data[len(data) // 2] ^= 1
                path.write_bytes(data if content == "flip" else content)
        done = self.scarp("resume", "frames")
        self.assertEqual(done.returncode, 0, done.stderr)
        for name, (_, word) in damages.items():
            self.assertRegex(done.stderr, f"frames/{name}' {word}.*without this frame")
        self.assertEqual(done.stderr.count("without this frame"), len(damages))
        numbers = {3, 5, 8, 10}
        for series in ("soil", "walls"):
            listed = [json.loads((place / "frames" / f"{series}.hdf.series").read_text())["files"]
                      for place in (whole, run)]
            self.assertEqual([f for f in listed[0] if int(f["name"][-9:-4]) not in numbers], listed[1])

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


    LONGER = '''[[stage]]
name = "on"
duration = "0.1 s"
strength_reduction = 3
'''

    def longer(self, change=lambda text: text):
        """The scene with one more stage."""
        text = SLIDE.replace("PRESET", self.preset)
        place = text.index("[[probe]]")
        (self.folder / "longer.toml").write_text(change(text[:place] + self.LONGER + text[place:]))
        return "longer.toml"

    def test_more_stages_go_on_from_the_end(self):
        self.whole()
        alone = self.scarp("run", self.longer(), "-o", "alone", "--threads", "1", "-q")
        self.assertEqual((alone.returncode, alone.stderr), (0, ""))
        done = self.scarp("resume", "whole", "--scene", "longer.toml", "--threads", "2")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("goes on at step", done.stderr)
        self.expect_equal_runs(self.folder / "alone", self.folder / "whole")
        self.assertEqual((self.folder / "whole" / "scene.toml").read_text(), (self.folder / "longer.toml").read_text())
        done = self.scarp("resume", "whole")
        self.assertIn("the run is complete", done.stderr)
        self.assertNotIn("warning", done.stderr)

    def test_more_stages_survive_a_kill(self):
        self.whole()
        process = self.start("resume", "whole", "--scene", self.longer(), "--threads", "1", "-q")
        while "longer.toml" not in (self.folder / "whole" / "run.json").read_text():
            time.sleep(0.002)
        process.kill()
        process.wait(60)
        self.assertEqual(self.scarp("resume", "whole", "-q").returncode, 0)
        self.assertEqual(self.scarp("run", "longer.toml", "-o", "alone", "-q").returncode, 0)
        self.expect_equal_runs(self.folder / "alone", self.folder / "whole")

    def test_only_more_stages_can_be_added(self):
        whole = self.whole()
        before = {p: p.read_bytes() for p in whole.rglob("*") if p.is_file()}
        for change, word in ((lambda t: t.replace("2 kPa", "3 kPa"), "material[0].parameters"),
                             (lambda t: t.replace('"0.9 s"', '"0.8 s"'), "stage[1].duration = 0.9, here stage[1]"),
                             (lambda t: t.replace('name = "fail"', 'name = "slide"', 1).replace('"fail"', '"slide"'),
                              "wall[2].from"),
                             (lambda t: t.replace("at = [12, 13]", "at = [10, 13]"), "probe[0].at"),
                             (lambda t: t.replace('"50 ms"', '"60 ms"'), "output.every"),
                             (lambda t: t.replace('name = "left"', 'name = "west"'), "wall[1].name")):
            done = self.scarp("resume", "whole", "--scene", self.longer(change))
            self.assertEqual(done.returncode, 1)
            self.assertIn(word, done.stderr)
        for path in self.checkpoints("whole"):
            del before[path]
            path.unlink()
        done = self.scarp("resume", "whole", "--scene", self.longer())
        self.assertEqual(done.returncode, 1)
        self.assertIn("no checkpoint of its end", done.stderr)
        self.assertEqual(before, {p: p.read_bytes() for p in whole.rglob("*") if p.is_file()})

    def test_what_stands_in_for_a_checkpoint_is_passed_over(self):
        whole = self.whole()
        for name, put in (("pipe", os.mkfifo), ("folder", lambda p: p.mkdir()),
                          ("device", lambda p: p.symlink_to("/dev/zero")),
                          ("nothing", lambda p: p.symlink_to("nowhere")), ("loop", lambda p: p.symlink_to(p)),
                          ("sparse", lambda p: self.sparse(p, 1 << 42))):
            run = self.stopped_copy(name)
            newest = self.checkpoints(name)[-1]
            newest.unlink()
            put(newest)
            done = self.scarp("resume", name)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(f"warning: {newest.name}: ", done.stderr)
            self.assertNotIn("not enough memory", done.stderr)
            self.assertEqual((whole / "probes.csv").read_bytes(), (run / "probes.csv").read_bytes(), name)

    @staticmethod
    def sparse(path, size):
        with open(path, "wb") as file:
            file.truncate(size)

    def test_a_tampered_checkpoint_with_the_right_sum_leaves_the_one_before(self):
        whole = self.whole()
        for name, change in (("fields/position", lambda d: d.__setitem__((0, 0), numpy.nan)),
                             ("clock/step_factor", lambda d: d.__setitem__(0, 0.0)),
                             ("stage/index", lambda d: d.__setitem__(0, 7)),
                             ("outputs/frame_numbers", lambda d: d.__setitem__(0, -1))):
            run = self.stopped_copy(name.replace("/", "_"))
            newest = self.checkpoints(run)[-1]
            data = newest.read_bytes()
            newest.write_bytes(data[:data.rindex(b"\nscarp checkpoint ends")])
            with h5py.File(newest, "r+") as file:
                change(file[name])
            data = newest.read_bytes()
            newest.write_bytes(data + f"\nscarp checkpoint ends, crc32 {zlib.crc32(data):08x}\n".encode())
            done = self.scarp("resume", run.name)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stderr, f"warning: {newest.name}: .*{name}")
            self.expect_equal_runs(whole, run)


class ResumeRetryTest(SlideRun):
    """Kills while a run goes wrong, goes back and goes on."""

    scene = RETRY
    says = r"warning: numerics: cfl .*Retry 1 of 3: back to step 500, with 0\.5 of the time step\.\n"

    def test_kills_change_nothing(self):
        whole = self.whole()
        self.assertEqual(json.loads((whole / "results.json").read_text())["retries"][0]["back_to"], 500)
        chance = random.Random(11)
        before_the_retry, starts = 0, 0
        while before_the_retry < max(2, KILLS // 2):
            run = self.folder / f"killed{starts}"
            starts += 1
            command = ("run", "slide.toml", "-o", run.name, "--threads", "1", "-q")
            for kill in range(3):
                process = self.start(*command)
                if kill < 2:  # the retry comes at about a third of the run
                    self.wait_for_step(run, chance.randrange(500 * kill + 500, 1400), process)
                    process.kill()
                code = process.wait(60)
                if code == 0:
                    break
                newest = self.checkpoints(run.name)[-1]
                with h5py.File(newest, "r") as file:
                    before_the_retry += file["outputs/retry_factors"].shape[0] == 0
                self.assertLessEqual(len(list((run / "checkpoints").glob("kept_*.h5"))), 5)
                command = ("resume", run.name, "-q")
            self.expect_equal_runs(whole, run)
            self.assertEqual(sorted(p.name for p in (whole / "checkpoints").iterdir()),
                             sorted(p.name for p in (run / "checkpoints").iterdir()))
            shutil.rmtree(run)

    def wait_for_step(self, run, step, process):
        end = time.monotonic() + 60
        while process.poll() is None and time.monotonic() < end:
            found = self.checkpoints(run.name)
            if found and int(found[-1].name[5:17]) >= step:
                return
            time.sleep(0.001)

    def test_a_damaged_kept_state_leaves_the_checkpoint_before(self):
        whole = self.whole()
        run = self.folder / "kept"
        shutil.copytree(whole, run)
        (run / "results.json").unlink()
        kept = sorted((run / "checkpoints").glob("kept_*.h5"))
        self.assertGreaterEqual(len(kept), 2)
        for path in kept:
            path.write_bytes(b"damaged")
        done = self.scarp("resume", "kept")
        self.assertEqual(done.returncode, 1)
        self.assertIn("kept_0", done.stderr)


class ResumePaperTest(ResumeTest):
    preset = "paper"


if __name__ == "__main__":
    unittest.main()
