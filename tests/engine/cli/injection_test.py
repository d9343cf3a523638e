# SPDX-License-Identifier: BSD-3-Clause
"""The n-th allocation, open, write, sync or rename of a run fails, n in turn: the run ends with a documented exit code
and a sentence, and its folder is one that can be gone on from or begun again.

Usage: injection_test.py PATH_OF_SCARP PATH_OF_SHIM [--each N] [TEST...]; N calls of each kind, 0 for all of them"""

import os
import subprocess
import sys
import unittest

from slide_run import SCARP, SLIDE, SlideRun

SHIM = sys.argv.pop(1)
EACH = 6
if "--each" in sys.argv:
    place = sys.argv.index("--each")
    EACH = int(sys.argv[place + 1])
    del sys.argv[place:place + 2]


class InjectionTest(SlideRun):
    preset = "modern"

    def setUp(self):
        super().setUp()
        short = SLIDE.replace("PRESET", self.preset).replace('"0.1 s"', '"20 ms"').replace('"0.9 s"', '"40 ms"')
        (self.folder / "slide.toml").write_text(short.replace('"50 ms"', '"15 ms"').replace('"0.5 m"', '"1 m"'))

    def faulty(self, kind, at, *command, stays=False, threads=1):
        settings = {"LD_PRELOAD": SHIM, "SCARP_FAULT_KIND": kind, "SCARP_FAULT_AT": str(at),
                    "SCARP_FAULT_COUNT": str(self.folder / "count")}
        if stays:
            settings["SCARP_FAULT_STAYS"] = "1"
        return subprocess.run([SCARP, *command, "--threads", str(threads)], cwd=self.folder, capture_output=True,
                              text=True, timeout=300, check=False, env={**os.environ, **settings})

    def tables(self, run):
        return {p.name: p.read_bytes() for p in (self.folder / run).glob("*.csv")}

    def places(self, count):
        """Some calls, the first and the last among them, or all of 1 to count."""
        if EACH == 0 or count <= EACH:
            return range(1, count + 1)
        return sorted({1 + round(k * (count - 1) / (EACH - 1)) for k in range(EACH)})

    def expect_good_end(self, done, run, whole, what):
        # 0: what failed can be done without, such as the name of the processor.
        self.assertIn(done.returncode, (0, 1), f"{what}: {done.stderr}")
        if done.returncode == 1:
            self.assertRegex(done.stderr.splitlines()[-1], r"^scarp: .*\.$", what)
        self.assertEqual(list((self.folder / run).rglob("*.part")) if done.returncode == 0 else [], [], what)
        again = self.scarp("resume", run, "-q") if (self.folder / run / "run.json").exists() else None
        if again is None or again.returncode != 0:
            # Nothing was begun, or its every state is lost; then it can be begun again.
            if again is not None:
                self.assertRegex(again.stderr, "To start over|no run to go on", what)
            subprocess.run(["rm", "-rf", self.folder / run], check=True)
            again = self.scarp("run", "slide.toml", "-o", run, "-q")
        self.assertEqual(again.returncode, 0, f"{what}: {again.stderr}")
        self.assertEqual(self.tables(run), whole, what)

    def in_turn(self, kind, **options):
        run = ["run", "slide.toml", "-q", "-o"]
        whole = self.faulty(kind, 0, *run, "whole", **options)
        self.assertEqual((whole.returncode, whole.stderr), (0, ""))
        count = int((self.folder / "count").read_text())
        self.assertGreater(count, 2, "the shim sees none")
        tables = self.tables("whole")
        ended = 0
        for at in self.places(count):
            name = f"{kind}{at}"
            done = self.faulty(kind, at, *run, name, **options)
            ended += done.returncode == 1
            self.expect_good_end(done, name, tables, f"{kind} {at} of {count}")
        self.assertGreater(ended, 0)
        print(f"{kind} {options}: {len(self.places(count))} of {count} calls failed in turn, {ended} ended the run",
              file=sys.stderr)

    def test_memory(self):
        self.in_turn("memory")

    def test_memory_that_stays_gone(self):
        self.in_turn("memory", stays=True)

    def test_memory_in_two_threads(self):
        self.in_turn("memory", threads=2)

    def test_open(self):
        self.in_turn("open")

    def test_write(self):
        self.in_turn("write")

    def test_a_disk_that_stays_full(self):
        self.in_turn("write", stays=True)

    def test_sync(self):
        self.in_turn("sync")

    def test_rename(self):
        self.in_turn("rename")


if __name__ == "__main__":
    unittest.main()
