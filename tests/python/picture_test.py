# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of simulations and of folders hold what these do.

usage: picture_test.py PROGRAM
"""
import json
import os
import re
import unittest

import common
import numpy as np
import scarp
from common import column


class PictureTest(common.TestCase):
    def setUp(self):
        super().setUp()
        self.viewer = self.folder / "viewer.js"
        self.viewer.write_text("/* the viewer */")
        os.environ["SCARP_VIEWER"] = str(self.viewer)
        self.addCleanup(os.environ.pop, "SCARP_VIEWER")

    def index(self, page):
        return json.loads(re.search(r"data-index>(.*?)</script>", page).group(1))

    def test_each_moment_that_was_added(self):
        simulation = scarp.Simulation(column(), threads=1)
        picture = scarp.Picture(simulation)
        for _ in range(3):
            simulation.step()
        picture.add(simulation)
        index = self.index(picture.html())
        self.assertEqual(len(picture), 2)
        self.assertEqual([frame["step"] for frame in index["frames"]], [0, 3])
        self.assertEqual(index["frames"][1]["time"], simulation.time)
        position = simulation.field("position")[:, :2]
        np.testing.assert_allclose(index["frames"][1]["box"], [position.min(axis=0), position.max(axis=0)])
        self.assertEqual([material["name"] for material in index["materials"]], simulation.scene.materials)
        self.assertEqual(index["walls"][0]["names"], simulation.scene.walls)
        corners, walls = simulation.wall_faces()
        self.assertEqual(index["walls"][0]["wall"], walls.tolist())
        np.testing.assert_allclose(np.array(index["walls"][0]["corners"]).reshape(corners.shape), corners, atol=1e-9)

    def test_a_folder_has_the_moments_of_its_frames(self):
        scarp.Simulation(column(), threads=1).run(folder=self.folder / "run")
        picture = scarp.Picture(self.folder / "run")
        index = self.index(picture.html())
        self.assertEqual([frame["time"] for frame in index["frames"]], scarp.read_frames(self.folder / "run").times.tolist())
        picture.save(self.folder / "page.html")
        self.assertEqual((self.folder / "page.html").read_text(encoding="utf-8"), picture.html())

    def test_a_notebook_shows_it_in_a_frame(self):
        shown = scarp.Picture(scarp.Simulation(column(), threads=1))._repr_html_()
        self.assertTrue(shown.startswith('<iframe srcdoc="&lt;!doctype html&gt;'))
        self.assertEqual(shown.count('"'), 4)

    def test_without_the_viewer_it_says_how_to_get_it(self):
        self.viewer.unlink()
        picture = scarp.Picture(scarp.Simulation(column(), threads=1))
        self.assertIn("scarp was built without it", picture._repr_html_())
        with self.assertRaisesRegex(scarp.Error, "scarp was built without it"):
            picture.save(self.folder / "page.html")

    def test_a_folder_without_frames_is_an_error(self):
        with self.assertRaisesRegex(scarp.FileError, "there are no frames in it"):
            scarp.Picture(self.folder)

    def test_where_it_cannot_be_written(self):
        with self.assertRaisesRegex(scarp.FileError, "cannot be written"):
            scarp.Picture(scarp.Simulation(column(), threads=1)).save(self.folder / "none" / "page.html")


if __name__ == "__main__":
    unittest.main()
