# SPDX-License-Identifier: BSD-3-Clause
"""Scenes by keywords and from TOML; errors; what the package says of itself. usage: scene_test.py PROGRAM"""
import ast
import contextlib
import inspect
import io
import os
import pathlib
import re
import subprocess
import unittest
from unittest import mock

import common
import numpy as np
import scarp
from common import CLAY, column


class SceneTest(common.TestCase):
    def test_keywords_are_the_keys_of_a_scene_file(self):
        scene = column()
        again = scarp.Scene.from_toml(scene.text)
        self.assertEqual((again.title, again.dimension, again.spacing), ("Column", 2, 0.1))
        self.assertEqual(again.probes, ["crest"])
        self.assertEqual(again.walls, ["base", "side"])
        both = [scarp.Simulation(one, threads=1).field("stress") for one in (scene, again)]
        self.assert_same(*both)

    def test_numpy_values_and_every_kind_of_text_survive(self):
        corners = np.array([[0, 0], [1, 0], [1, 1.0]])
        scene = column(title='a "title" \\ with é', body=dict(material="clay", polygon=corners), spacing=np.float64(0.1))
        self.assertEqual(scene.title, 'a "title" \\ with é')
        self.assertEqual(scarp.Scene.from_toml(scene.text).title, scene.title)

    def test_a_template_is_the_scene_that_scarp_new_writes(self):
        scene = scarp.Scene.from_template("slope", spacing="1 m")
        written = subprocess.run([common.PROGRAM, "new", "slope", "-"], capture_output=True, text=True, check=True).stdout
        self.assertEqual(scene.text, written)
        self.assertEqual((scene.title, scene.spacing), ("Slope", 1.0))
        with self.assertRaisesRegex(ValueError, "there is no 'slop'.*slope"):
            scarp.Scene.from_template("slop")

    def test_a_file_is_read_and_overridden(self):
        file = self.folder / "column.toml"
        column().save(file)
        self.assertEqual(scarp.Scene.from_toml(file).file, str(file))
        other = scarp.Scene.from_toml(str(file), spacing="20 cm", preset="paper")
        self.assertEqual((other.spacing, other.preset), (0.2, "paper"))
        finer = other.at(spacing="5 cm")
        self.assertEqual((finer.spacing, finer.preset), (0.05, "paper"))

    def test_errors_are_in_the_words_of_the_program(self):
        file = self.folder / "bad.toml"
        file.write_text(column().text.replace("friction_angle", "frictoin_angle"))
        with self.assertRaises(scarp.SceneError) as caught:
            scarp.Scene.from_toml(file)
        done = subprocess.run([common.PROGRAM, "check", str(file)], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn(str(caught.exception), done.stderr)
        self.assertIn("friction_angle", str(caught.exception))
        with self.assertRaises(scarp.FileError) as caught:
            scarp.Scene.from_toml(self.folder / "none.toml")
        self.assertIsInstance(caught.exception, OSError)

    def test_what_a_scene_cannot_hold_is_named(self):
        with self.assertRaisesRegex(TypeError, r"body\[0\]\.box"):
            column(body=[dict(material="clay", box={1, 2})])
        with self.assertRaisesRegex(scarp.SceneError, "Did you mean 'spacing'|gravty"):
            column(gravty=[0, -1])
        with self.assertRaisesRegex(ValueError, "pressure"):
            scarp.element(column(), "triaxial", confining="3 m")

    def test_doubts_are_warnings(self):
        scene = column(material={**CLAY, "density": 20.0})
        with self.assertWarnsRegex(RuntimeWarning, "density"):
            scarp.Simulation(scene, threads=1)


class PagesTest(common.TestCase):
    """The Python of both pages runs, with README's scene made coarse."""

    root = pathlib.Path(__file__).resolve().parents[2]

    def blocks(self, page, language):
        return re.findall(rf"```{language}\n(.*?)```", (self.root / page).read_text("utf-8"), re.S)

    def setUp(self):
        super().setUp()
        bank = next(block for block in self.blocks("README.md", "toml") if "Clay bank" in block)
        coarse = re.sub(r'duration = "5 s"', 'duration = "0.5 s"', bank.replace('spacing = "0.25 m"', 'spacing = "1.25 m"'))
        self.assertNotEqual(coarse, bank)
        (self.folder / "bank.toml").write_text(coarse)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)

    def run_blocks(self, blocks, names):
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            for block in blocks:
                exec(compile(block, "page", "exec"), names)
        return printed.getvalue()

    def test_of_the_project(self):
        blocks = self.blocks("README.md", "python")
        self.assertEqual(len(blocks), 1)
        with mock.patch("scarp.fos", wraps=lambda scene: scarp.studies.fos(scene, tolerance=0.5, window="0.5 s")):
            self.assertRegex(self.run_blocks(blocks, {}), r"\d")

    def test_of_the_module(self):
        *blocks, model = self.blocks("engine/python/README.md", "python")
        self.assertEqual(len(blocks), 4)
        names = {}
        self.run_blocks(blocks, names)
        self.assertEqual(scarp.Scene.from_toml("bank.toml").spacing, 0.25)  # saved by the page
        self.assertGreater(names["fastest"], 0.0)
        names["simulation"] = scarp.Simulation(column(material=dict(
            name="clay", model="linear_elastic", density=2000, youngs_modulus="10 MPa", poisson_ratio=0.3)))
        self.run_blocks([model], names)
        names["simulation"].run(until=0.02)
        self.assertIn("shrunk", names["simulation"].model_history())


class PackageTest(unittest.TestCase):
    def test_the_stub_names_what_is_there(self):
        from scarp import _core
        stub = ast.parse((pathlib.Path(scarp.__file__).parent / "_core.pyi").read_text())
        said = {}
        for node in stub.body:
            if isinstance(node, ast.ClassDef):
                said[node.name] = {item.name if isinstance(item, ast.FunctionDef) else item.target.id
                                   for item in node.body if isinstance(item, (ast.FunctionDef, ast.AnnAssign))}
            elif isinstance(node, ast.FunctionDef):
                said[node.name] = None
            elif isinstance(node, ast.AnnAssign):
                said[node.target.id] = None
        there = {name for name in vars(_core) if not name.startswith("__")}
        self.assertEqual(set(said), there)
        for name, members in said.items():
            kind = getattr(_core, name)
            if inspect.isclass(kind) and not issubclass(kind, Exception):
                public = {member for member in vars(kind) if not member.startswith("_")}
                self.assertEqual(members - {"__init__"}, public, name)

    def test_everything_public_is_described(self):
        for name in scarp.__all__:
            thing = getattr(scarp, name)
            self.assertTrue(inspect.getdoc(thing), name)
            if not inspect.isclass(thing) or issubclass(thing, Exception):
                continue
            for member, value in vars(thing).items():
                if member.startswith("_") or not (callable(value) or isinstance(value, (property, classmethod))):
                    continue
                self.assertTrue(inspect.getdoc(getattr(thing, member)), f"{name}.{member}")


if __name__ == "__main__":
    unittest.main()
