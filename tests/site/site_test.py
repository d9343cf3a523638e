# SPDX-License-Identifier: BSD-3-Clause
"""The site of the pages: it is built without a warning, links that lead nowhere are one, and no page asks the network.

Usage: site_test.py ROOT_OF_THE_REPOSITORY PATH_OF_SPHINX_BUILD"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT, SPHINX = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
del sys.argv[1:]
FOLDERS = ("engine", "kernels", "validation", "bench", "cmake")


def built(source, out):
    return subprocess.run([SPHINX, "-q", "-W", "--keep-going", "-c", source / "cmake/site", source, out],
                          capture_output=True, text=True, timeout=280, check=False)


class SiteTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def copy(self):
        """The repository as far as the site needs it."""
        source = self.folder / "source"
        for folder in FOLDERS:
            shutil.copytree(ROOT / folder, source / folder, ignore=shutil.ignore_patterns("__pycache__"))
        for file in [*ROOT.glob("*.md"), ROOT / "CMakeLists.txt", ROOT / "LICENSE", ROOT / "CITATION.cff"]:
            shutil.copy(file, source / file.name)
        return source

    def test_every_page_is_there_and_none_needs_the_network(self):
        done = built(ROOT, self.folder / "site")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        pages = list((self.folder / "site").rglob("*.html"))
        for page in ("index", "README", "engine/TUTORIAL", "engine/CHOOSING", "engine/scene/SCENE", "engine/THEORY",
                     "validation/README", "validation/cases/slope_2d/README", "engine/python/README", "engine/LIBRARY",
                     "engine/DEVELOPERS"):
            self.assertIn(self.folder / f"site/{page}.html", pages)
        for file in pages + list((self.folder / "site/_static").rglob("*.css")):
            text = file.read_text("utf-8")
            loaded = re.findall(r"""(?:src=|<link[^>]*href=|url\(|@import\s)["']?(?:https?:)?//[^"')\s]+""", text)
            self.assertEqual(loaded, [], file)
        start = (self.folder / "site/README.html").read_text("utf-8")
        self.assertIn('href="engine/TUTORIAL.html"', start)

    def test_a_link_that_leads_nowhere_is_an_error(self):
        source = self.copy()
        page = source / "engine/CHOOSING.md"
        for link, message in (("[x](MISSING.md)", "MISSING.md"), ("[x](MANUAL.md#no-such-part)", "no-such-part")):
            page.write_text("# How to choose\n\n" + link + "\n")
            done = built(source, self.folder / "site")
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(message, done.stderr)


if __name__ == "__main__":
    unittest.main()
