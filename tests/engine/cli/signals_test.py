# SPDX-License-Identifier: BSD-3-Clause
"""A signal in any phase of any command: it stops, leaves what it promises, and what it says to go on with works.

Usage: signals_test.py PATH_OF_SCARP [--validate PATH_OF_SCARP_VALIDATE] [--every-signal] [TEST...]

A phase is waited for by what the program says, writes or has used of the processor, never by time."""

import itertools
import json
import os
import pathlib
import re
import shlex
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from scenes import COLUMN, SLOPE, block_of

VALIDATE = None
if "--validate" in sys.argv:
    place = sys.argv.index("--validate")
    VALIDATE = sys.argv[place + 1]
    del sys.argv[place:place + 2]
EVERY_SIGNAL = "--every-signal" in sys.argv
if EVERY_SIGNAL:
    sys.argv.remove("--every-signal")
SCARP = sys.argv.pop(1)

ASKING = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGXCPU)
BOUND = 100.0  # [s]; a step takes milliseconds, but the machine may be busy
turn = itertools.cycle(ASKING)


class SignalTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        (self.folder / "column.toml").write_text(COLUMN.replace('"1 s"', '"100 s"'))
        (self.folder / "slope.toml").write_text(SLOPE)

    def start(self, *command, program=SCARP, **options):
        options = {"stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE, **options}
        process = subprocess.Popen([program, *command], cwd=self.folder, text=True, **options)
        self.addCleanup(lambda: process.poll() is not None or process.kill())
        for stream in (process.stderr, process.stdout):
            if stream:
                self.addCleanup(stream.close)
        return process

    def wait_until(self, ready, process, what):
        end = time.monotonic() + BOUND
        while not ready():
            self.assertIsNone(process.poll(), f"ended before {what}")
            self.assertLess(time.monotonic(), end, f"never came to {what}")
            time.sleep(0.002)

    # What a phase is waited for by; each takes the process.

    def caught(self, process):
        """The handlers stand: the scene is read, or about to be."""
        def ready():
            status = pathlib.Path(f"/proc/{process.pid}/status").read_text()
            return int(re.search(r"SigCgt:\s*(\w+)", status)[1], 16) >> (signal.SIGXCPU - 1) & 1
        self.wait_until(ready, process, "its handlers")

    def used(self, seconds):
        """Processor time used, all threads."""
        def wait(process):
            self.caught(process)
            ticks = seconds * os.sysconf("SC_CLK_TCK")
            self.wait_until(lambda: sum(map(int, pathlib.Path(f"/proc/{process.pid}/stat").read_text()
                                            .rpartition(")")[2].split()[11:13])) >= ticks,
                            process, f"{seconds} s of the processor")
        return wait

    def rows(self, table, count=5):
        def wait(process):
            path = self.folder / table
            self.wait_until(lambda: path.exists() and path.read_bytes().count(b"\n") > count, process,
                            f"{count} rows of {table}")
        return wait

    def there(self, name):
        return lambda process: self.wait_until((self.folder / name).exists, process, name)

    def says(self, word):
        def wait(process):
            for line in process.stderr:
                if word in line:
                    return
            self.fail(f"never said {word!r}")
        return wait

    def child(self, process):
        """The interpreter that draws the report runs."""
        path = pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children")
        self.wait_until(lambda: path.read_text().split(), process, "its child")
        return int(path.read_text().split()[0])

    def stopped(self, command, phase, program=SCARP, number=None):
        """Starts, signals in that phase; what it said after the signal."""
        number = number or next(turn)
        process = self.start(*command, program=program)
        phase(process)
        process.send_signal(number)
        began = time.monotonic()
        _, said = process.communicate(timeout=BOUND)
        self.assertEqual(process.returncode, 130, (command, number, said))
        self.assertLess(time.monotonic() - began, BOUND)
        self.assertIn("stopped on request", said)
        return said

    def in_phase(self, command, phase, check, program=SCARP):
        for number in ASKING if EVERY_SIGNAL else (None,):
            check(self.stopped(command, phase, program, number))

    def go_on(self, said, program="scarp"):
        """Carries out the command that was named."""
        command = re.search(rf"To go on[^:]*: ({program} .*)", said)
        self.assertTrue(command, said)
        return self.start(*shlex.split(command[1])[1:])


class CommandsTest(SignalTest):
    def test_before_anything_was_made_nothing_is_left(self):
        """The scene comes through a pipe, so that the signal is there before the set-up begins."""
        os.mkfifo(self.folder / "pipe.toml")
        for command in ("run", "fos", "converge", "check", "element"):
            process = self.start(command, "pipe.toml", *(["--path", "triaxial"] if command == "element" else []))
            self.caught(process)
            process.send_signal(next(turn))
            with open(self.folder / "pipe.toml", "w", encoding="utf-8") as pipe:
                pipe.write(SLOPE)
            said = process.communicate(timeout=BOUND)[1]
            self.assertEqual(process.returncode, 130, (command, said))
            self.assertTrue(said.endswith("scarp: stopped on request\n"), said)
            self.assertEqual([p.name for p in self.folder.rglob("*") if p.suffix in (".json", ".csv", ".hdf")], [])

    def test_run_leaves_a_checkpoint_and_resume_stops_the_same_way(self):
        def check(said):
            self.assertFalse(json.loads((self.folder / "out/results.json").read_text())["complete"])
            steps = [json.loads((self.folder / "out/results.json").read_text())["steps"]]
            self.assertRegex(said, "To go on: scarp resume out")
            again = self.go_on(said)
            self.says("goes on at step")(again)
            again.send_signal(signal.SIGTERM)
            said = again.communicate(timeout=BOUND)[1]
            self.assertEqual(again.returncode, 130, said)
            self.assertIn("To go on: scarp resume out", said)
            steps.append(json.loads((self.folder / "out/results.json").read_text())["steps"])
            self.assertGreaterEqual(steps[1], steps[0])
        self.in_phase(["run", "column.toml", "-o", "out"], self.rows("out/history.csv", 0), check)

    def test_fos_leaves_what_is_known(self):
        fos = ["fos", "slope.toml", "-o", "out", "--from", "1.2", "--to", "1.6", "--tolerance", "0.05", "--threads", "1"]

        def check(said):
            study = json.loads((self.folder / "out/fos.json").read_text())
            self.assertEqual((study["complete"], study["failure"]), (False, "stopped on request"))
            self.assertIn("To go on: the same command again", said)
        self.stopped(fos, self.says("particles"))  # settles: nothing is known yet
        self.assertFalse((self.folder / "out/fos.json").exists())
        self.in_phase(fos, self.says("SRF 1.2 stands"), check)
        self.stopped(fos, self.says("SRF 1.6 fails"))
        self.stopped(fos, self.says("2 trials are known from before"))
        self.stopped(fos, self.there("out/failure/history.csv"))
        self.assertFalse(json.loads((self.folder / "out/failure/results.json").read_text())["complete"])
        self.assertIsNotNone(json.loads((self.folder / "out/fos.json").read_text())["factor_of_safety"])

    def test_converge_keeps_what_is_complete(self):
        (self.folder / "short.toml").write_text(COLUMN)
        converge = ["converge", "short.toml", "-o", "out", "--spacings", "0.5, 0.25, 0.02"]
        self.in_phase(converge, self.rows("out/dx_0.02/history.csv", 0),
                      lambda said: self.assertIn("To go on: the same command", said))
        again = self.start(*converge)
        self.says("0.25 m: was there already")(again)
        again.kill()
        again.communicate()

    def test_check_stops_in_every_part(self):
        (self.folder / "wide.toml").write_text(block_of(20_000))
        # Trial, rehearsal, probe, costs. The parts are as long as the clock says, so that on a busy machine a later
        # one may be over before its processor time has come.
        for extra, seconds, surely in (([], 0.3, True), ([], 3.0, False), (["--probe"], 1.0, False),
                                       (["--costs"], 8.0, False)):
            process = self.start("check", "wide.toml", *extra, "--threads", "1")
            try:
                self.used(seconds)(process)
            except AssertionError:
                if surely or process.wait() != 0:
                    raise
                continue
            process.send_signal(next(turn))
            said = process.communicate(timeout=BOUND)[1]
            self.assertIn(process.returncode, (130,) if surely else (130, 0), said)

    def test_element_stops(self):
        self.in_phase(["element", "column.toml", "--path", "triaxial", "--steps", "10000000", "-o", "table.csv"],
                      self.used(0.2), lambda said: self.assertFalse((self.folder / "table.csv").exists()))

    def test_report_takes_its_child_with_it(self):
        subprocess.run([SCARP, "run", "slope.toml", "-o", "out", "-q", "--spacing", "2 m"], cwd=self.folder, check=True,
                       timeout=BOUND)
        for number in ASKING if EVERY_SIGNAL else (signal.SIGTERM,):
            process = self.start("report", "out")
            child = self.child(process)
            process.send_signal(number)
            said = process.communicate(timeout=BOUND)[1]
            self.assertEqual(process.returncode, 130, said)
            self.assertNotIn("Traceback", said)
            self.assertFalse(pathlib.Path(f"/proc/{child}").exists())
            self.assertFalse((self.folder / "out/report.html").exists())


class WaysTest(SignalTest):
    """Of a run that is under way."""

    def running(self, **options):
        process = self.start("run", "column.toml", "-o", "out", "--threads", "1", **options)
        self.rows("out/history.csv", 0)(process)
        return process

    def test_a_signal_sent_twice_at_once_is_one_wish(self):
        process = self.running()
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
            process.send_signal(number)
        self.assertEqual((process.wait(BOUND), len(list((self.folder / "out/checkpoints").iterdir()))), (130, 1))

    def test_a_second_one_later_ends_at_once(self):
        os.mkfifo(self.folder / "pipe")  # nobody reads: the program waits there for ever
        (self.folder / "short.toml").write_text(COLUMN)
        process = self.start("run", "short.toml", "-o", "out", "--json", "pipe")
        self.there("out/results.json")(process)
        process.send_signal(signal.SIGTERM)
        time.sleep(1.5)  # what counts as the same wish is shorter
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(BOUND), -signal.SIGTERM)

    def test_quit_is_left_alone(self):
        process = self.running()
        process.send_signal(signal.SIGQUIT)
        self.assertEqual(process.wait(BOUND), -signal.SIGQUIT)

    def test_nohup_holds(self):
        process = self.running(preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        process.send_signal(signal.SIGHUP)
        self.rows("out/history.csv", 1)(process)
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(BOUND), 130)

    def test_a_reader_that_has_gone_stops_nothing(self):
        (self.folder / "short.toml").write_text(COLUMN)
        process = self.start("run", "short.toml", "-o", "out")
        process.stderr.close()
        self.assertEqual(process.wait(BOUND), 0)
        self.assertTrue(json.loads((self.folder / "out/results.json").read_text())["complete"])


@unittest.skipIf(VALIDATE is None, "scarp-validate is not given")
class ValidateTest(SignalTest):
    def test_the_search_for_a_factor_of_safety_stops(self):
        command = ["run", "slope_2d", "--short", "--spacing", "2 m", "--threads", "1"]
        for phase in ("settle", "SRF 1.4 to rest", "SRF"):
            self.in_phase(command, self.says(f"slope_2d: {phase}" if phase != "SRF" else "slope_2d: SRF 1.2"),
                          lambda said: self.assertIn("To go on: the same command with --resume", said), VALIDATE)

    def test_a_study_goes_on_from_its_checkpoint(self):
        command = ["run", "slope_corner", "--short", "--spacing", "2 m"]
        self.in_phase(command, self.says("particles\n"), lambda said: self.assertTrue(
            list((self.folder / "out").rglob("checkpoints/step_*.h5"))), VALIDATE)
        again = self.start(*command, "--resume", program=VALIDATE)
        self.says("particles\n")(again)
        again.send_signal(signal.SIGTERM)
        self.assertEqual(again.wait(BOUND), 130, again.stderr.read())

    def test_error_time_and_stability_keep_their_records(self):
        for command, log in ((["error-time", "elastic_wave", "--short", "--axis", "preset"],
                              "out/error_time/elastic_wave/runs.jsonl"),
                             (["stability", "--short", "--axis", "stiffness"], "out/stability/runs.jsonl")):
            self.in_phase(command, self.rows(log, 0),
                          lambda said: self.assertRegex(said, "To go on: the same command\n"), VALIDATE)
            known = (self.folder / log).read_text()
            self.stopped(command, self.caught, VALIDATE)
            self.assertTrue((self.folder / log).read_text().startswith(known))


if __name__ == "__main__":
    unittest.main()
