# SPDX-License-Identifier: BSD-3-Clause
"""`scarp new` and `scarp explain`. Usage: pages_test.py PATH_OF_SCARP ROOT"""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SCARP = sys.argv.pop(1)
ROOT = pathlib.Path(sys.argv.pop(1))
TEMPLATES = sorted(path.stem for path in (ROOT / "engine/scene/templates").glob("*.toml"))


class Case(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def scarp(self, *arguments):
        return subprocess.run([SCARP, *arguments], cwd=self.folder, capture_output=True, text=True, timeout=250,
                              check=False)


class NewTest(Case):
    def test_every_template_is_listed(self):
        done = self.scarp("new")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(sorted(line.split()[0] for line in done.stdout.splitlines()[:-1]), TEMPLATES)
        self.assertGreaterEqual(set(TEMPLATES), {"slope", "layered_slope", "column", "footing", "terrain", "chute"})

    def test_every_template_passes_the_check_and_runs(self):
        for name in TEMPLATES:
            with self.subTest(name):
                done = self.scarp("new", name)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn(f"scarp run {name}.toml", done.stdout)
                file = self.folder / f"{name}.toml"
                self.assertEqual(file.read_text(), (ROOT / f"engine/scene/templates/{name}.toml").read_text())
                checked = self.scarp("check", file.name)
                self.assertEqual((checked.returncode, checked.stderr), (0, ""))
                self.assertNotIn("warning:", checked.stdout)
                text, stages = re.subn(r'duration = "[^"]*"', 'duration = "3 ms"', file.read_text())
                self.assertGreater(stages, 0)
                file.write_text(text)
                ran = self.scarp("run", "-q", file.name)
                self.assertEqual((ran.returncode, ran.stderr), (0, ""))
                self.assertTrue((self.folder / "out" / name / "results.json").exists())

    def test_a_file_that_is_there_stays(self):
        (self.folder / "slope.toml").write_text("mine")
        done = self.scarp("new", "slope")
        self.assertEqual(done.returncode, 1)
        self.assertIn("'slope.toml': is there already", done.stderr)
        self.assertEqual((self.folder / "slope.toml").read_text(), "mine")
        self.assertEqual(self.scarp("new", "slope", "other.toml").returncode, 0)
        self.assertEqual(self.scarp("new", "slope", "-").stdout, (self.folder / "other.toml").read_text())

    def test_a_template_that_is_not_there(self):
        done = self.scarp("new", "slop")
        self.assertEqual(done.returncode, 2)
        self.assertIn("Did you mean 'slope'?", done.stderr)


def rows():
    """Section, key and last cell of each row of the tables of keys in SCENE.md."""
    section = None
    for line in (ROOT / "engine/scene/SCENE.md").read_text().splitlines():
        if line.startswith("## "):
            heading = line[3:]
            section = "top" if heading == "Top level" else heading.strip("[]") if heading.startswith("[") else None
        match = re.match(r"\| `([^`]*)`", line)
        if section and match:
            yield section, match.group(1), line.rstrip(" |").split(" | ")[-1].replace("`", "")


class ExplainTest(Case):
    def test_every_key_has_its_page(self):
        found = list(rows())
        self.assertGreater(len(found), 60)
        sections = {section for section, _, _ in found}
        for section in sections:
            done = self.scarp("explain", section)
            self.assertEqual(done.returncode, 0, done.stderr)
        for section, key, meaning in found:
            done = self.scarp("explain", f"{section}.{key}")
            self.assertEqual(done.returncode, 0, f"{section}.{key}: {done.stderr}")
            said = " ".join(done.stdout.split())
            self.assertIn(key, said)
            self.assertIn(" ".join(meaning.split()), said, f"{section}.{key}")

    def test_keys_as_messages_name_them(self):
        plain = self.scarp("explain", "material.cohesion").stdout
        self.assertEqual(self.scarp("explain", "material[0].cohesion").stdout, plain)
        self.assertEqual(self.scarp("explain", "cohesion").stdout, plain)
        self.assertIn("[[material]] cohesion", plain)
        self.assertIn("kPa", plain)
        self.assertIn("min = [..], max", self.scarp("explain", "body[0].box.min").stdout)
        self.assertIn("muParser", self.scarp("explain", "velocity_field").stdout)

    def test_a_list_of_all_and_a_key_that_is_not_there(self):
        everything = self.scarp("explain").stdout
        for section, key, _ in rows():
            self.assertIn(key, everything.split(), section)
        done = self.scarp("explain", "cohesoin")
        self.assertEqual(done.returncode, 2)
        self.assertIn("Did you mean 'cohesion'?", done.stderr)


if __name__ == "__main__":
    unittest.main()
