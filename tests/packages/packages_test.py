# SPDX-License-Identifier: BSD-3-Clause
"""The .tar.gz, unpacked where nobody expects it, is complete and runs; the .deb names what it depends on and follows Debian.

usage: packages_test.py CPACK BUILD_FOLDER VERSION PYTHON_FOLDER; PYTHON_FOLDER is where the module is in the archive, - for none"""
import glob
import os
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest

CPACK, BUILD, VERSION, PYTHON_FOLDER = sys.argv[1:5]
VIEWER = os.path.exists(os.path.join(BUILD, "viewer", "scarp_viewer.js"))


def package(folder, generator, pattern):
    """The package that CPack makes in `folder`."""
    subprocess.run([CPACK, "-G", generator, "-B", folder, "--config", os.path.join(BUILD, "CPackConfig.cmake")],
                   check=True, stdout=subprocess.DEVNULL)
    (made,) = glob.glob(os.path.join(folder, pattern))
    return made


class Archive(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = tempfile.TemporaryDirectory()
        archive = package(os.path.join(cls.work.name, "made"), "TGZ", "*.tar.gz")
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

    @unittest.skipUnless(VIEWER, "the moving picture was not built")
    def test_holds_the_moving_picture_and_its_licence(self):
        for file in ("share/scarp/report/scarp_viewer.js", "share/doc/scarp/three.js.LICENSE"):
            self.assertTrue(os.path.isfile(self.path(file)), file)
        if PYTHON_FOLDER != "-":
            self.assertTrue(os.path.isfile(self.path(PYTHON_FOLDER, "scarp", "scarp_viewer.js")))
        with open(self.path("share/scarp/report/scarp_viewer.js"), encoding="utf-8") as file:
            self.assertIn("Permission is hereby granted", file.read(2000))

    def test_leaves_out_the_program_under_another_licence(self):
        self.assertFalse(os.path.exists(self.path("bin/scarp-lammps")))


@unittest.skipUnless(shutil.which("dpkg-shlibdeps") and shutil.which("file"), "a .deb needs dpkg-dev and file")
class DebianPackage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            made = package(folder, "DEB", "*.deb")
            cls.fields = subprocess.run(["dpkg-deb", "--field", made, "Package", "Version", "Depends"], check=True,
                                        capture_output=True, text=True).stdout
            cls.contents = subprocess.run(["dpkg-deb", "--contents", made], check=True, capture_output=True, text=True).stdout

    def test_depends_on_what_the_programs_link(self):
        self.assertIn(f"Package: scarp\nVersion: {VERSION}\n", self.fields)
        libraries = ["libc6", "libhdf5", "libfmt", "libmuparser", "libgomp1"]
        for name in libraries + ([] if PYTHON_FOLDER == "-" else ["python3 (<<", "python3-numpy"]):
            self.assertIn(f" {name}", self.fields.split("Depends:")[1])

    def test_puts_files_where_debian_looks(self):
        places = ["bin/scarp", "share/man/man1/scarp.1.gz", "share/doc/scarp/copyright", "share/bash-completion/completions/scarp"]
        if VIEWER:
            places.append("share/scarp/report/scarp_viewer.js")
        for place in places + ([] if PYTHON_FOLDER == "-" else ["lib/python3/dist-packages/scarp/__init__.py"]):
            self.assertIn(f" ./usr/{place}\n", self.contents)
        self.assertNotIn("scarp-lammps", self.contents)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
