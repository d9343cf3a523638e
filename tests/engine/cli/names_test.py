# SPDX-License-Identifier: BSD-3-Clause
"""Names, titles and paths with every byte that a person or a script may put there: terminals, pages, tables and JSON
show them and run none.

Usage: names_test.py PATH_OF_SCARP [TEST...]"""

import csv
import html.parser
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCENE = """title = %(title)s
dimension = 2
spacing = 0.5
[[material]]
name = %(name)s
density = 2000
youngs_modulus = "10 MPa"
poisson_ratio = 0.3
cohesion = "10 kPa"
friction_angle = "20 deg"
[[body]]
material = %(name)s
polygon = [[0, 0], [6, 0], [6, 1], [4, 1], [2, 3], [0, 3]]
[[wall]]
name = %(name)s
kind = "no_slip"
line = [[0, 0], [6, 0]]
[[wall]]
name = %(second)s
kind = "free_slip"
box = {min = [0, 0], max = [6, 4], open = ["-y", "+y"]}
[[stage]]
name = %(name)s
duration = "10 ms"
[[probe]]
name = %(name)s
at = [2, 3]
[[probe]]
name = %(second)s
at = [6, 1]
[output]
energy = true
"""

# Shown as they are.
GOOD = ["<b>&'<b>", "<script>alert(1)<script>", "&lt;", "$x^$", "$", "_hidden", "%s%n%x", "{0}",
        "{}", "a;b", "a|b", "`id`", "$(id)", "測試", "Böschung", "😀", "a b", "'", "nan", "inf", "1", "true", "time",
        "stage", "a=b", "a\u200db"]
# No name, and told so: what begins a formula, separates or acts.
BAD = ["=1+1", "=cmd|' C'!A0", "+1", "-1", "@SUM(A1)", " a", "a.b", "a/b", "a\\b", 'a"b', "a,b", "[a]", "a\tb", "a\nb",
       "a\rb", "\x1b[31ma", "a\x07", "a\x7f", "a\x9bb", "\u202egnp", "a\u2028b", "\ufeffa", "", "x" * 65]
BAD_TITLES = ["\x1b[31ma", "a\nb", "a\x07", "a\x9bb", "\u202egnp", ""]
PATHS = [b"a\xff.toml", b"a\x1b[31m.toml", b"a\nb.toml", b"=a.toml", b"<img src=x onerror=a>.toml", "ü.toml".encode(),
         b"-x.toml", b"a b.toml", b"$(id).toml", b"%s.toml", b"{}.toml", b"a'\".toml", b"a.b.toml", b".toml"]


def quoted(text):
    return '"' + "".join("\\u%04x" % ord(c) if ord(c) < 32 or c in '"\\\x7f' else c for c in text) + '"'


class Tags(html.parser.HTMLParser):
    """Everything in a page that is markup: tags with the attributes that could act, and texts; scripts apart."""

    def __init__(self):
        super().__init__()
        self.tags, self.texts, self.scripts = set(), [], []
        self.in_script = False

    def handle_starttag(self, tag, attrs):
        self.in_script = tag == "script"
        if self.in_script:
            self.scripts.append("")
        else:
            self.tags.add(tag)
        self.tags.update(name for name, _ in attrs if name.startswith("on"))

    def handle_endtag(self, tag):
        self.in_script = False

    def handle_data(self, data):
        if self.in_script:
            self.scripts[-1] += data
        else:
            self.texts.append(data)


class NamesTest(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def scarp(self, *arguments):
        done = subprocess.run([SCARP, *arguments], cwd=self.folder, capture_output=True, check=False, timeout=300)
        for stream in (done.stdout, done.stderr):
            for byte in set(stream.decode("utf-8", "strict")):  # UTF-8, and nothing that acts on a terminal
                self.assertTrue(byte == "\n" or (byte.isprintable() or byte == "\u200d"), (arguments, ascii(byte)))
        return done

    def write(self, file, title, name):
        text = SCENE % {"title": quoted(title), "name": quoted(name), "second": quoted("the other")}
        pathlib.Path(os.fsdecode(os.path.join(os.fsencode(self.folder), file))).write_text(text, "utf-8")

    def expect_good_files(self, out):
        for path in out.rglob("*.json"):
            json.loads(path.read_bytes().decode("utf-8", "strict"))
        for path in out.rglob("*.csv"):
            with path.open(newline="", encoding="utf-8") as stream:
                rows = list(csv.reader(stream))
            self.assertEqual({len(row) for row in rows}, {len(rows[0])}, path)
            for cell in (cell for row in rows for cell in row):
                number = cell.lstrip("-")[:1].isdigit() or cell == "-"
                self.assertTrue(number or cell[:1] not in ("=", "+", "-", "@", "\t", "\r"), (path, cell))

    def test_names_that_are_shown_are_shown_everywhere(self):
        for name in GOOD:
            self.write(b"scene.toml", name, name)
            out = self.folder / "out"
            done = self.scarp("run", "scene.toml", "-o", "out", "--overwrite", "--threads", "1")
            self.assertEqual(done.returncode, 0, (name, done.stderr))
            self.expect_good_files(out)
            results = json.loads((out / "results.json").read_text("utf-8"))
            self.assertEqual((results["title"], results["stages"][0]["name"]), (name, name))
            with (out / "probes.csv").open(newline="", encoding="utf-8") as stream:
                self.assertEqual(next(csv.reader(stream))[2], f"{name}.position_x [m]")
            done = self.scarp("check", "scene.toml", "--json", "check.json", "--threads", "1")
            self.assertEqual(done.returncode, 0, (name, done.stderr))
            self.assertIn(name, done.stdout.decode())
            self.assertEqual(json.loads((self.folder / "check.json").read_text("utf-8"))["title"], name)

    def expect_harmless_page(self, path, name, title):
        """Returns how many scripts it has: the particles of the moving picture, and what draws them."""
        page = Tags()
        page.feed(path.read_text("utf-8"))
        self.assertLessEqual(page.tags, {"html", "head", "meta", "title", "style", "body", "h1", "h2", "h3", "p", "div",
                                         "table", "thead", "tbody", "tr", "th", "td", "figure", "img", "figcaption",
                                         "span", "br", "a"})
        self.assertIn(title, page.texts)
        if "<" in name:
            self.assertFalse([text for text in page.scripts if name in text])
        return len(page.scripts)

    def test_pages_show_names_and_run_none(self):
        scripts = set()
        for name in ("<script>alert(1)<script>", "<img src=x onerror=alert(1)>", "$x^$", "_hidden", "time", "nan"):
            self.write(b"scene.toml", name + "</h1>", name)
            done = self.scarp("run", "scene.toml", "-o", "out", "--overwrite", "--quiet", "--threads", "1")
            self.assertEqual(done.returncode, 0, (name, done.stderr))
            done = self.scarp("report", "out", "--quiet")  # progress is told where figures take long
            # A label that a figure leaves out is told in a warning.
            self.assertEqual((done.returncode, done.stderr), (0, b""), name)
            scripts.add(self.expect_harmless_page(self.folder / "out" / "report.html", name, name + "</h1>"))
        self.assertEqual(len(scripts), 1)  # a name adds none

    def test_names_that_act_are_refused_with_their_line(self):
        for name in BAD:
            self.write(b"scene.toml", "a", name)
            done = self.scarp("check", "scene.toml")
            self.assertEqual(done.returncode, 1, ascii(name))
            self.assertRegex(done.stderr.decode(), r"^scarp: scene.toml:5: key 'material\[0\].name' = .*Try ", ascii(name))
        for title in BAD_TITLES:
            self.write(b"scene.toml", title, "a")
            done = self.scarp("check", "scene.toml")
            self.assertEqual(done.returncode, 1, ascii(title))
            self.assertRegex(done.stderr.decode(), r"^scarp: scene.toml:1: key 'title' = .*Try ", ascii(title))

    def test_paths_of_any_bytes_can_be_read_and_written(self):
        for path in PATHS:
            self.write(path, "a", "b")
            out = os.fsdecode(b"out of " + path)
            for arguments in (["check", "--json", os.fsdecode(path + b".json")], ["run", "-o", out],
                              ["element", "--path", "isotropic", "-o", os.fsdecode(path + b".csv"), "--json", "-"]):
                threads = [] if arguments[0] == "element" else ["--threads", "1"]
                done = self.scarp(*arguments, *threads, "--", os.fsdecode(path))
                self.assertEqual(done.returncode, 0, (path, arguments, done.stderr))
            self.expect_good_files(self.folder / out)
            json.loads(pathlib.Path(self.folder / os.fsdecode(path + b".json")).read_bytes().decode("utf-8", "strict"))
        for path in PATHS:  # complaints name them
            with open(os.path.join(os.fsencode(self.folder), path), "ab") as scene:
                scene.write(b"water = 1\n")
            done = self.scarp("check", "--", os.fsdecode(path))
            self.assertEqual(done.returncode, 1, path)
            self.assertEqual(done.stderr.count(b"\n"), 1, path)
            self.assertRegex(done.stderr.decode(), r"^scarp: .*toml:33: key 'output\.water'", path)


if __name__ == "__main__":
    SCARP = sys.argv.pop(1)
    unittest.main()
