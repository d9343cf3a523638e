# SPDX-License-Identifier: BSD-3-Clause
"""Runs the commands of the pages: all blocks of shell commands, but for those that begin with the line "# not run by the
tests: WHY". Scenes are made coarser, so that they take seconds.

Usage: commands_test.py ROOT_OF_THE_REPOSITORY BUILD_FOLDER [PAGE ...]"""

import os
import pathlib
import re
import stat
import subprocess
import sys
import tempfile
import unittest

ROOT, BUILD = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
PAGES = sys.argv[3:] or [str(path.relative_to(ROOT)) for folder in ("", "engine", "kernels", "validation", "bench")
                         for path in sorted((ROOT / folder).glob("**/*.md" if folder else "*.md"))]
del sys.argv[1:]

NOT_RUN = "# not run by the tests: "
COARSE = '"1.25 m"'
# Scenes that `scarp new` writes are made coarser as well.
PROGRAM = """#!/bin/bash
"{program}" "$@" || exit
if [[ $1 == new && -f $3 ]]; then sed -i 's/^spacing = "[^"]*"/spacing = {coarse}/' "$3"; fi
"""


def blocks(text, language):
    return re.findall(rf"^```{language}\n(.*?)^```$", text, re.M | re.S)


def saved_scenes(text):
    """{file name: text} of the scenes that a page tells to save."""
    found = re.findall(r"^Save this as `([^`]+)`:\n```toml\n(.*?)^```$", text, re.M | re.S)
    return {name: re.sub(r'(?m)^spacing = "[^"]*"', f"spacing = {COARSE}", scene) for name, scene in found}


SCENES = saved_scenes((ROOT / "README.md").read_text("utf-8"))


class CommandsTest(unittest.TestCase):
    def folder(self):
        """A folder with what a checkout has: the cases, the programs of the build, and the scenes of the start page."""
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        folder = pathlib.Path(temporary.name)
        programs = folder / "build/release/bin"
        programs.mkdir(parents=True)
        (folder / "validation").symlink_to(ROOT / "validation")
        for program in (BUILD / "bin").iterdir():
            place = programs / program.name
            if program.name == "scarp":
                place.write_text(PROGRAM.format(program=program, coarse=COARSE))
                place.chmod(place.stat().st_mode | stat.S_IXUSR)
            else:
                place.symlink_to(program)
        for name, scene in SCENES.items():
            (folder / name).write_text(scene)
        return folder

    def run_page(self, page):
        text, folder = (ROOT / page).read_text("utf-8"), None
        for block in blocks(text, "sh"):
            if block.startswith(NOT_RUN):
                self.assertGreater(len(block.splitlines()[0]), len(NOT_RUN), f"{page}: no reason is given")
                continue
            folder = folder or self.folder()
            environment = {**os.environ, "PATH": f"{folder}/build/release/bin:{os.environ['PATH']}"}
            for command in block.splitlines():
                done = subprocess.run(["bash", "-ec", command], cwd=folder, env=environment, capture_output=True,
                                      text=True, timeout=600, check=False)
                with self.subTest(f"{page}: {command}"):
                    self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_the_commands_of_the_pages(self):
        self.assertIn("bank.toml", SCENES)
        for page in PAGES:
            self.run_page(page)


if __name__ == "__main__":
    unittest.main()
