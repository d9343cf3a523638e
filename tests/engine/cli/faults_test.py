# SPDX-License-Identifier: BSD-3-Clause
"""Disks that are full, read-only or gone, and folders that are taken: a run ends with a clear message and what
it had written is good.

Usage: faults_test.py PATH_OF_SCARP [TEST...]"""

import fcntl
import resource
import subprocess
import unittest

from slide_run import SLIDE, SlideRun


class FaultsTest(SlideRun):
    preset = "modern"

    def mounted(self, name, options):
        """A small file system of its own."""
        path = self.folder / name
        path.mkdir()
        done = subprocess.run(["mount", "-t", "tmpfs", "-o", options, "tmpfs", path], capture_output=True, text=True,
                              check=False)
        if done.returncode != 0:
            self.skipTest(f"mounting is not allowed here: {done.stderr.strip()}")
        self.addCleanup(subprocess.run, ["umount", path], check=True)
        return path

    def remount(self, path, options):
        subprocess.run(["mount", "-o", f"remount,{options}", path], check=True)

    def expect_frames_as_of(self, whole, run):
        """Every frame that has its name is complete: the bytes of the run that was left alone."""
        frames = sorted((run / "frames").glob("*.hdf"))
        for frame in frames:
            self.assertEqual(frame.read_bytes(), (whole / "frames" / frame.name).read_bytes(), frame.name)
        return len(frames)

    def test_a_full_disk_stops_the_run_and_a_larger_one_takes_it_on(self):
        whole = self.whole()
        needed = sum(p.stat().st_blocks * 512 for p in whole.rglob("*") if p.is_file())
        stopped_with_frames = 0
        for eighths in (1, 3, 4, 5, 6, 7):
            disk = self.mounted(f"disk{eighths}", f"size={eighths * needed // 8}")
            run = f"disk{eighths}/run"
            full = self.scarp("run", "slide.toml", "-o", run, "--threads", "1", "-q")
            self.assertEqual(full.returncode, 1, full.stderr)
            self.assertIn("No space left on device", full.stderr)
            self.assertIn("scarp resume " + run, full.stderr)
            stopped_with_frames += self.expect_frames_as_of(whole, disk / "run") > 1
            self.remount(disk, f"size={4 * needed}")
            done = self.scarp("resume", run, "-q")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.expect_equal_runs(whole, disk / "run")
        self.assertGreater(stopped_with_frames, 2)

    def test_a_disk_that_cannot_be_written_is_named(self):
        self.mounted("disk", "size=1m,ro")
        done = self.scarp("run", "slide.toml", "-o", "disk/run")
        self.assertEqual(done.returncode, 1)
        self.assertIn("'disk/run': cannot be used as output folder: Read-only file system", done.stderr)

    def test_a_disk_that_becomes_read_only_is_named_at_resume(self):
        disk = self.mounted("disk", "size=64m")
        process = self.start("run", "slide.toml", "-o", "disk/run", "--threads", "1")
        self.wait_for_checkpoints("disk/run")
        process.kill()
        process.wait(60)
        self.remount(disk, "ro")
        done = self.scarp("resume", "disk/run")
        self.assertEqual(done.returncode, 1)
        self.assertIn("Read-only file system", done.stderr)
        self.remount(disk, "rw")
        self.assertEqual(self.scarp("resume", "disk/run", "-q").returncode, 0)
        self.expect_equal_runs(self.whole(), disk / "run")

    def test_two_runs_do_not_share_a_folder(self):
        (self.folder / "out").mkdir()
        with open(self.folder / "out" / ".lock", "w", encoding="utf-8") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            done = self.scarp("run", "slide.toml", "-o", "out")
            self.assertEqual(done.returncode, 1)
            self.assertIn("another run is writing there", done.stderr)
            self.assertEqual([p.name for p in (self.folder / "out").iterdir()], [".lock"])

    def test_a_second_run_leaves_the_first_alone(self):
        whole = self.whole()
        first = self.start("run", "slide.toml", "-o", "shared", "--threads", "1", "-q")
        self.wait_for_checkpoints("shared")
        for command in (["run", "slide.toml", "-o", "shared"], ["resume", "shared"]):
            second = self.scarp(*command)
            self.assertEqual(second.returncode, 1)
            self.assertIn("another run is writing there", second.stderr)
        self.assertEqual((first.wait(60), first.stderr.read()), (0, ""))
        self.expect_equal_runs(whole, self.folder / "shared")

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
                rows = 'frames = false\nprobes_every = "1 us"'
                (self.folder / "slide.toml").write_text(scene.replace("energy = true", rows))
            stopped = self.limited(size, "run", "slide.toml", "-o", "short", "-q", "--overwrite")
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


class FaultsPaperTest(FaultsTest):
    preset = "paper"


if __name__ == "__main__":
    unittest.main()
