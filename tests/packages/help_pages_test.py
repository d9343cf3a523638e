# SPDX-License-Identifier: BSD-3-Clause
"""Man page and bash completion know all that a program says to --help.

usage: help_pages_test.py FOLDER_OF_PROGRAMS FOLDER_OF_PAGES"""
import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAMS, PAGES = sys.argv[1:3]
NAMES = [name for name in ("scarp", "scarp-validate") if os.path.exists(os.path.join(PROGRAMS, name))]


def help_of(name, *command):
    return subprocess.run([os.path.join(PROGRAMS, name), *command, "--help"], check=True, capture_output=True,
                          text=True).stdout


def commands_of(name):
    table = help_of(name).split("Subcommands:\n")[1].split("\n\n")[0]
    return re.findall(r"^  (\S+)", table, re.MULTILINE)


def options_in(text):
    """Long options of a help text: what begins with -- in the left column."""
    return {option for line in text.splitlines() if line.startswith("  -")
            for option in re.findall(r"--[a-z-]+", line[:29].split()[0])}


def completed(name, *words, folder="."):
    """What bash offers for the last of `words`."""
    line = " ".join(f"'{word}'" for word in (name, *words))
    script = f"""source "$1"; COMP_WORDS=({line}); COMP_CWORD={len(words)}
        $(complete -p {name} | sed -E 's/.*-F ([^ ]+).*/\\1/'); printf '%s\\n' "${{COMPREPLY[@]}}" """
    output = subprocess.run(["bash", "--norc", "-c", script, "bash", os.path.join(PAGES, "completions", name)],
                            cwd=folder, check=True, capture_output=True, text=True)
    return set(output.stdout.split())


class Completion(unittest.TestCase):
    def test_offers_every_command_and_option(self):
        for name in NAMES:
            commands = commands_of(name)
            self.assertGreater(len(commands), 3)
            self.assertEqual(completed(name, ""), {*commands, "-h"} | options_in(help_of(name)))
            for command in commands:
                with self.subTest(program=name, command=command):
                    self.assertEqual(completed(name, command, "--"), options_in(help_of(name, command)))

    def test_offers_values(self):
        self.assertEqual(completed("scarp", "run", "--isa", ""), {"neon"} if platform.machine() == "aarch64" else {"sse2", "avx2", "avx512"})
        self.assertEqual(completed("scarp", "element", "--path", "t"), {"triaxial"})
        self.assertEqual(completed("scarp", "new", "sl"), {"slope"})
        self.assertEqual(completed("scarp", "run", "--threads", ""), set())

    def test_offers_files(self):
        with tempfile.TemporaryDirectory() as folder:
            os.mkdir(os.path.join(folder, "out"))
            for file in ("bank.toml", "notes.txt"):
                open(os.path.join(folder, file), "w").close()
            self.assertEqual(completed("scarp", "check", "", folder=folder), {"bank.toml", "out"})
            self.assertEqual(completed("scarp", "resume", "--scene", "b", folder=folder), {"bank.toml"})
            self.assertEqual(completed("scarp", "report", "", folder=folder), {"out"})
            self.assertEqual(completed("scarp", "run", "--json", "n", folder=folder), {"notes.txt"})


class ManPage(unittest.TestCase):
    def test_holds_every_command_and_option(self):
        for name in NAMES:
            with open(os.path.join(PAGES, "man1", f"{name}.1"), encoding="utf-8") as file:
                page = file.read().replace("\\-", "-")
            for command in commands_of(name):
                section = page.split(f".SS {name} {command} ")[1].split("\n.S")[0]
                for option in options_in(help_of(name, command)) - {"--help"}:
                    self.assertIn(option, re.split(r"[\s,]", section), f"{name} {command}")

    @unittest.skipUnless(shutil.which("man"), "needs man")
    def test_is_troff_without_warnings(self):
        for name in NAMES:
            shown = subprocess.run(["man", "--warnings", "-l", os.path.join(PAGES, "man1", f"{name}.1")],
                                   capture_output=True, text=True, env={**os.environ, "MANPAGER": "cat"})
            self.assertEqual((shown.returncode, shown.stderr), (0, ""))
            self.assertIn("EXIT STATUS", shown.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
