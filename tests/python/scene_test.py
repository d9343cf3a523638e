# SPDX-License-Identifier: BSD-3-Clause
"""Scenes by keywords and from TOML; errors; what the package says of itself. usage: scene_test.py PROGRAM"""
import ast
import inspect
import pathlib
import subprocess
import unittest

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
