# SPDX-License-Identifier: BSD-3-Clause
"""Standard streams that are closed, full or without reader, and files that --json may not touch.

Usage: streams_test.py PATH_OF_SCARP"""

import json
import os
import pathlib
import stat
import subprocess
import sys
import tempfile
import unittest

from scenes import SCENE

SCARP = sys.argv.pop(1)
RUN = ["run", "block.toml", "-o", "out"]
CHECK = ["check", "block.toml", "--json"]


class StreamsTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        (self.folder / "block.toml").write_text(SCENE + '[[probe]]\nname = "top"\nat = [2, 2]\n')

    def scarp(self, *command, **options):
        options = {"capture_output": True, **options}
        return subprocess.run([SCARP, *command], cwd=self.folder, text=True, timeout=100, check=False, **options)

    def shell(self, redirection, *command):
        return subprocess.run(["bash", "-c", f'"$0" "$@" {redirection}', SCARP, *command], cwd=self.folder, text=True,
                              timeout=100, check=False, capture_output=True)

    def tables(self):
        return {path.name: path.read_text() for path in (self.folder / "out").glob("*.csv")}

    def test_closed_streams_change_no_file(self):
        self.assertEqual(self.scarp(*RUN).returncode, 0)
        whole = self.tables()
        self.assertIn("probes.csv", whole)
        for closed in (">&- 2>&-", "<&- >&- 2>&-", "2>&-", "<&- 2>&-"):
            self.assertEqual(self.shell(closed, *RUN, "--overwrite").returncode
                             if self.overwrites() else self.shell(closed, *RUN).returncode, 0, closed)
            self.assertEqual(self.tables(), whole, closed)
            self.assertEqual((self.folder / "out/.lock").read_bytes(), b"")
            self.assertTrue(json.loads((self.folder / "out/results.json").read_text())["complete"])

    def overwrites(self):
        return "--overwrite" in self.scarp("run", "--help").stdout

    def test_a_full_standard_error_stops_nothing(self):
        done = self.shell("2> /dev/full", *RUN)
        self.assertEqual(done.returncode, 0)
        self.assertTrue(json.loads((self.folder / "out/results.json").read_text())["complete"])
        for command, code in ((["run", "missing.toml"], 1), (["run", "block.toml", "--spacing", "1 kg"], 2)):
            self.assertEqual(self.shell("2> /dev/full", *command).returncode, code)

    def test_a_full_standard_output_is_an_error(self):
        for command in ([*CHECK, "-"], ["check", "block.toml"], ["--help"], ["--version"],
                        ["run", "block.toml", "-o", "full", "--json", "-", "-q"]):
            done = self.shell("> /dev/full", *command)
            self.assertEqual(done.returncode, 1, command)
            self.assertIn("standard output cannot be written: No space left on device", done.stderr)
        self.assertTrue(json.loads((self.folder / "full/results.json").read_text())["complete"])

    def test_json_keeps_devices_pipes_and_links(self):
        try:  # nodes of our own: the machine's are not to be tried upon
            for name, minor in (("null", 3), ("full", 7)):
                os.mknod(self.folder / name, 0o600 | stat.S_IFCHR, os.makedev(1, minor))
                open(self.folder / name, "rb").close()
        except PermissionError:
            print("no device nodes can be made here", file=sys.stderr)
        else:
            self.assertEqual(self.scarp(*CHECK, "null").returncode, 0)
            full = self.scarp(*CHECK, "full")
            self.assertEqual(full.returncode, 1)
            self.assertIn("'full': cannot be written: No space left", full.stderr)
            for name in ("null", "full"):
                self.assertTrue((self.folder / name).is_char_device(), name)

        os.mkfifo(self.folder / "pipe")
        with subprocess.Popen(["cat", "pipe"], cwd=self.folder, stdout=subprocess.PIPE, text=True) as reader:
            self.assertEqual(self.scarp(*CHECK, "pipe").returncode, 0)
            self.assertEqual(json.loads(reader.communicate(timeout=60)[0])["particles"], 32)
        self.assertTrue((self.folder / "pipe").is_fifo())

        (self.folder / "deep").mkdir()
        for name, target in (("link.json", "deep/file.json"), ("dangling.json", "deep/new.json")):
            (self.folder / name).symlink_to(target)
            if name == "link.json":
                (self.folder / target).write_text("old")
            self.assertEqual(self.scarp(*CHECK, name).returncode, 0)
            self.assertTrue((self.folder / name).is_symlink())
            self.assertEqual(json.loads((self.folder / target).read_text())["particles"], 32)

    def test_a_planted_link_is_not_followed(self):
        (self.folder / "secret").write_text("mine")
        (self.folder / "check.json.part").symlink_to("secret")
        self.assertEqual(self.scarp(*CHECK, "check.json").returncode, 0)
        self.assertEqual((self.folder / "secret").read_text(), "mine")
        self.assertFalse((self.folder / "check.json.part").is_symlink())

    def test_targets_that_cannot_be_are_refused_before_the_work(self):
        scene = (self.folder / "block.toml").read_text()
        (self.folder / "alias.json").symlink_to("block.toml")
        os.link(self.folder / "block.toml", self.folder / "other.json")
        for target, word in (("block.toml", "is the scene itself"), ("alias.json", "is the scene itself"),
                             ("other.json", "is the scene itself"), (".", "is a folder"),
                             ("missing/check.json", "a folder that is not there")):
            for command in (["run", "block.toml"], ["check", "block.toml"], ["fos", "block.toml"],
                            ["converge", "block.toml"], ["element", "block.toml", "--path", "triaxial"]):
                done = self.scarp(*command, "--json", target)
                self.assertEqual((done.returncode, done.stdout), (2, ""), (command, target))
                self.assertIn(word, done.stderr)
        done = self.scarp("element", "block.toml", "--path", "triaxial", "-o", "block.toml")
        self.assertEqual(done.returncode, 2)
        self.assertEqual((self.folder / "block.toml").read_text(), scene)
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    unittest.main()
