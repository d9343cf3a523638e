# SPDX-License-Identifier: BSD-3-Clause
"""The .tar.gz, unpacked where nobody expects it, is complete and runs.

usage: archive_test.py CPACK BUILD_FOLDER VERSION PYTHON_FOLDER; PYTHON_FOLDER is where the module is in the archive, - for none"""
import glob
import os
import subprocess
import sys
import tarfile
import tempfile
import unittest

CPACK, BUILD, VERSION, PYTHON_FOLDER = sys.argv[1:5]


class Archive(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = tempfile.TemporaryDirectory()
        made = os.path.join(cls.work.name, "made")
        subprocess.run([CPACK, "-G", "TGZ", "-B", made, "--config", os.path.join(BUILD, "CPackConfig.cmake")],
                       check=True, stdout=subprocess.DEVNULL)
        (archive,) = glob.glob(os.path.join(made, "*.tar.gz"))
        assert f"scarp-{VERSION}-" in archive, archive
        elsewhere = os.path.join(cls.work.name, "a place with spaces")
        with tarfile.open(archive) as file:
            file.extractall(elsewhere)
        (cls.root,) = glob.glob(os.path.join(elsewhere, "*"))

    @classmethod
    def tearDownClass(cls):
        cls.work.cleanup()

    def run_there(self, *command, **environment):
        """What a program of the archive prints, in a folder beside the archive."""
        return subprocess.run(command, check=True, capture_output=True, text=True, cwd=self.work.name,
                              env={"PATH": os.environ["PATH"], "OMP_NUM_THREADS": "1", **environment}).stdout

    def path(self, *parts):
        return os.path.join(self.root, *parts)

    def test_program_makes_and_checks_a_scene(self):
        self.assertEqual(self.run_there(self.path("bin/scarp"), "--version").strip(), f"scarp {VERSION}")
        self.run_there(self.path("bin/scarp"), "new", "slope", "slope.toml")
        self.assertIn("1780 soil", self.run_there(self.path("bin/scarp"), "check", "slope.toml"))

    @unittest.skipIf(PYTHON_FOLDER == "-", "the Python module was not built")
    def test_python_module_is_the_one_of_the_archive(self):
        said = self.run_there(sys.executable, "-c", "import scarp, scarp.run_files; print(scarp.__version__, scarp.__file__)",
                              PYTHONPATH=self.path(PYTHON_FOLDER))
        self.assertEqual(said.strip(), f"{VERSION} {self.path(PYTHON_FOLDER, 'scarp/__init__.py')}")

    def test_holds_what_a_user_needs(self):
        for file in ("include/scarp/scarp.hpp", "share/scarp/report/scarp_report.py", "share/man/man1/scarp.1",
                     "share/bash-completion/completions/scarp", "share/doc/scarp/LICENSE", "share/doc/scarp/README.md",
                     "share/doc/scarp/engine/MANUAL.md"):
            self.assertTrue(os.path.isfile(self.path(file)), file)
        for pattern in ("lib*/libscarp_engine.a", "lib*/cmake/scarp/scarpConfig.cmake"):
            self.assertTrue(glob.glob(self.path(pattern)) or glob.glob(self.path("lib", "*", pattern[5:])), pattern)
        with open(self.path("share/doc/scarp/CITATION.cff"), encoding="utf-8") as file:
            self.assertIn(f"\nversion: {VERSION}\n", file.read())

    def test_leaves_out_the_program_under_another_licence(self):
        self.assertFalse(os.path.exists(self.path("bin/scarp-lammps")))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
