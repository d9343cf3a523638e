# SPDX-License-Identifier: BSD-3-Clause
"""What long commands say meanwhile, on terminals of every kind and without one.

Usage: progress_test.py PATH_OF_SCARP FOLDER_OF_REPORT_SCRIPTS"""

import contextlib
import fcntl
import io
import os
import pathlib
import pty
import re
import signal
import struct
import subprocess
import sys
import tempfile
import termios
import unittest
import unittest.mock

from scenes import COLUMN, SLOPE, block_of

sys.path.insert(0, sys.argv.pop())
from scarp_progress import Progress  # noqa: E402

SCARP = sys.argv.pop(1)
LONG = block_of(900).replace("duration = 10", "duration = 1000")


class ProgressTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        for name, scene in (("long", LONG), ("column", COLUMN), ("slope", SLOPE.replace('"1 m"', '"0.5 m"'))):
            (self.folder / f"{name}.toml").write_text(scene)

    def on_terminal(self, *command, columns=100, kind="xterm", until=None):
        """What the command writes on a terminal of its own; once `until` says of it that it is enough, the command is
        interrupted."""
        ours, theirs = pty.openpty()
        fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 40, columns, 0, 0))
        environment = {**os.environ, "TERM": kind}
        with subprocess.Popen([SCARP, *command, "--threads", "1"], cwd=self.folder, env=environment, stderr=theirs,
                              stdout=subprocess.DEVNULL) as process:
            os.close(theirs)
            said = b""
            with contextlib.suppress(OSError):  # the other end is closed
                while part := os.read(ours, 1 << 16):
                    said += part
                    if until and until(said):
                        process.send_signal(signal.SIGINT)
                        until = None
        os.close(ours)
        return said.decode()

    def long_run(self, lines, **terminal):
        """The long run until it has said so many lines of progress."""
        return self.on_terminal("run", "long.toml", "-o", "out", "--overwrite",
                                until=lambda said: said.count(b" left") >= lines, **terminal)

    def test_a_bar_stays_within_its_line(self):
        for columns in (60, 80, 200):
            said = self.long_run(4, columns=columns)
            bars = [bar.split("\r\n")[0] for bar in said.split("\r\x1b[K")[1:]]
            self.assertGreater(len(bars), 2, said)
            for bar in bars:
                self.assertRegex(bar, r"^\[#*\.*\]  +\d+ %  .* left")
                self.assertLess(len(bar), columns)
        self.assertIn("M particle-steps/s", bars[-1])  # there is room for it in 200 columns

    def test_plain_lines_where_no_bar_can_be_drawn(self):
        for terminal in ({"columns": 40}, {"kind": "dumb"}, {"kind": ""}):
            said = self.long_run(1, **terminal)
            self.assertNotIn("\x1b", said, terminal)
            self.assertRegex(said, r"(?m)^ *\d+ %  .* left  .* M particle-steps/s\r$", terminal)
        with subprocess.Popen([SCARP, "run", "long.toml", "-o", "out", "--overwrite", "--threads", "1"], cwd=self.folder, text=True,
                              stderr=subprocess.PIPE) as process:
            for line in process.stderr:
                self.assertNotRegex(line, "[\r\x1b]")
                if re.match(r" *\d+ %  .* left  .* M particle-steps/s$", line):
                    process.send_signal(signal.SIGINT)
        self.assertEqual(process.returncode, 130)

    def test_quiet_says_nothing(self):
        for command in (["run", "column.toml"], ["converge", "column.toml", "--spacings", "0.5,0.25,0.125"],
                        ["fos", "slope.toml", "--tolerance", "0.5"]):
            self.assertEqual(re.sub("(?m)^warning: .*\r\n", "", self.on_terminal(*command, "--quiet", "-o", command[0])),
                             "")

    def test_parts_of_a_whole_say_what_comes_after_them(self):
        said = self.on_terminal("converge", "column.toml", "--spacings", "0.25,0.125,0.0625", "-o", "out")
        self.assertRegex(said, r" left  spacing 3 of 3  .* left in all")
        said = self.on_terminal("fos", "slope.toml", "--tolerance", "0.3", "-o", "fos")
        self.assertRegex(said, r" left  trial \d+ of about \d+  .* left in all")

    def test_figures_are_counted(self):
        class Terminal(io.StringIO):
            def isatty(self):
                return True

        for kind, columns, drawn in (("xterm", "100", True), ("xterm", "40", False), ("dumb", "100", False)):
            stream, progress = Terminal(), Progress()
            progress.expect(4)
            with unittest.mock.patch.dict(os.environ, {"TERM": kind, "COLUMNS": columns}), \
                    contextlib.redirect_stderr(stream):
                for _ in range(2):
                    progress.last -= 6.0
                    progress.begin -= 6.0
                    progress.step()
                progress.end()
            self.assertEqual("\x1b" in stream.getvalue(), drawn)
            self.assertRegex(stream.getvalue(), r"figure 2 of 4  1[12] s left")


if __name__ == "__main__":
    unittest.main()
