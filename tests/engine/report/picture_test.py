# SPDX-License-Identifier: BSD-3-Clause
"""What a page holds of a run's particles is what the frames hold, within stated bounds, and no more than it may.

Usage: picture_test.py FOLDER_OF_THE_REPORT_SCRIPTS"""

import json
import os
import pathlib
import re
import sys
import tempfile
import unittest
import zlib

import h5py
import numpy as np

from run_folder import lattice, write_fos, write_frame, write_run

sys.path.insert(0, sys.argv.pop(1))
import scarp_frames  # noqa: E402
import scarp_picture  # noqa: E402
import scarp_report  # noqa: E402


def joined(block, kind):
    """What scarp_picture packs, unpacked: the bytes of each number together again."""
    data = np.frombuffer(zlib.decompress(block), dtype=np.uint8)
    return np.ascontiguousarray(data.reshape(np.dtype(kind).itemsize, -1).T).view(kind).ravel()


def numbers(block, how, count):
    if how["kind"] == "half":
        values = joined(block, np.float16).astype(float) * how["scale"] + how["offset"]
    elif how["kind"] == "steps32":
        values = np.cumsum(joined(block, np.int32).reshape(-1, count).astype(np.int64), axis=1)
    else:
        values = joined(block, {"bytes": np.uint8, "doubles": float}[how["kind"]])
    return np.asarray(values).reshape(-1, count).T


class PictureTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def frame(self, position, **values):
        path = self.folder / "frame.hdf"
        write_frame(path, position, **values)
        return scarp_frames.load_frame(path)

    def test_positions_are_true_to_half_a_step_of_their_box(self):
        frame = self.frame(np.random.default_rng(1).uniform(-3.0, 40.0, (500, 3)), dimension=3)
        packed = scarp_picture.PackedFrame(frame)
        low, high = np.array(packed.entry["box"])
        places = np.cumsum(joined(packed.blocks["position"], np.uint16).reshape(3, -1), axis=1) % 65536
        step = (high - low) / 65535
        found = low + places.T * step
        np.testing.assert_array_less(np.abs(found - frame["position"]) / step, 0.501)

    def test_fields_are_true_to_a_twothousandth(self):
        frame = self.frame(lattice(20, 10, 5), dimension=3)
        packed = scarp_picture.PackedFrame(frame)
        for name, values in frame["fields"].items():
            found = numbers(packed.blocks[name], packed.entry["fields"][name], len(frame["position"]))
            np.testing.assert_allclose(found, values.reshape(len(values), -1), rtol=2.0**-11, atol=1e-9, err_msg=name)

    def test_small_differences_of_large_numbers_stay(self):
        values = 1900.0 + np.linspace(0.0, 1.0, 400)
        for sign in (1.0, -1.0):
            half, offset, scale = scarp_picture._half(sign * values)
            np.testing.assert_allclose(half.astype(float) * scale + offset, sign * values, rtol=0, atol=2.0**-11)

    def test_numbers_that_are_none_stay_none(self):
        half, _, _ = scarp_picture._half(np.array([0.0, np.nan, np.inf, 3.0]))
        self.assertEqual(list(np.isnan(half)), [False, True, True, False])

    def test_ids_of_any_size(self):
        frame = self.frame(lattice(4, 1))
        for ids in ([0, 1, 2, 3], [7, 300, 301, 900], [0, 2**40, 2**40 + 1, 2**52]):
            frame["fields"]["id"] = np.array(ids, dtype=np.int64)
            packed = scarp_picture.PackedFrame(frame)
            self.assertEqual(numbers(packed.blocks["id"], packed.entry["fields"]["id"], 4)[:, 0].tolist(), ids)

    def test_a_plane_frame_has_no_third_axis(self):
        entry = scarp_picture.PackedFrame(self.frame(lattice(4, 3))).entry
        self.assertEqual(len(entry["box"][0]), 2)
        self.assertEqual(entry["fields"]["displacement"]["components"], 2)
        self.assertEqual(entry["fields"]["stress"]["components"], 4)  # plane strain has stress across

    def test_invariants_of_a_known_stress(self):
        frame = self.frame(lattice(2, 1))
        frame["fields"]["stress"] = np.array([[-100.0, -300.0, -200.0, 0, 0, 0], [0, 0, 0, 10.0, 0, 0]])
        fields = scarp_picture.with_invariants(frame)["fields"]
        np.testing.assert_allclose(fields["mean_stress"], [-200.0, 0.0])
        np.testing.assert_allclose(fields["deviatoric_stress"], [np.sqrt(3.0) * 100.0, np.sqrt(3.0) * 10.0])

    def test_limits_are_those_of_nearly_all(self):
        values = np.concatenate([np.linspace(0.0, 1.0, 9999), [1e9]])
        self.assertLess(scarp_picture.limits(values)[1], 1.01)
        self.assertEqual(scarp_picture.limits(np.full(3, np.nan)), [0.0, 0.0])

    def test_all_that_fits_is_shown(self):
        self.assertEqual(scarp_picture.plan(100, 1000, 30.0, 40e6), (100, 1000))

    def test_fewer_moments_come_before_fewer_particles(self):
        self.assertEqual(scarp_picture.plan(100, 100_000, 20.0, 40e6), (20, 100_000))
        frames, particles = scarp_picture.plan(100, 1_000_000, 20.0, 40e6)
        self.assertEqual(frames, scarp_picture.LEAST_FRAMES)
        self.assertEqual(particles, int(40e6 / 20.0 / frames))

    def test_more_than_two_million_particles_are_never_shown(self):
        self.assertEqual(scarp_picture.plan(1, 5_000_000, 20.0, 1e12), (1, 2_000_000))

    def test_the_moments_chosen_hold_the_first_the_last_and_ends_of_stages(self):
        class Moment:
            def __init__(self, number):
                self.number, self.info = number, {"event": "stage_end" if number == 33 else "interval"}
        numbers = [moment.number for moment in scarp_picture.chosen([Moment(n) for n in range(100)], 10)]
        self.assertEqual(len(numbers), 10)
        self.assertLessEqual({0, 33, 99}, set(numbers))
        self.assertLess(max(np.diff(numbers)), 34)

    def thinned(self):
        moved = 0.01 * np.random.default_rng(2).normal(size=(48_000, 3))
        write_run(self.folder / "run", lattice(60, 40, 20) + moved, dimension=3)
        return scarp_picture.run_picture(self.folder / "run", 3e5)

    def test_thinned_particles_are_the_same_at_each_moment(self):
        index, blocks = self.thinned()
        first, last = (numbers(blocks[f"{k}/id"], index["frames"][k]["fields"]["id"], index["frames"][k]["count"]) for k in (0, 1))
        np.testing.assert_array_equal(first, last)
        self.assertLess(len(first), 0.7 * 48_000)

    def test_thinned_particles_keep_within_the_size_and_say_so(self):
        index, blocks = self.thinned()
        self.assertLess(sum(len(block) for block in blocks.values()) * 4 / 3, 1.05 * 3e5)
        (note,) = index["notes"]
        shown = int(re.match(r"([\d\u202f]+) of 48\u202f000 particles", note).group(1).replace("\u202f", ""))
        self.assertAlmostEqual(shown, index["frames"][0]["count"], delta=0.05 * shown + 50)
        self.assertAlmostEqual(index["disc"], 0.25 * (48_000 / shown)**(1 / 3), delta=0.01)

    def test_a_damaged_frame_is_left_out_and_named(self):
        run = self.folder / "run"
        write_run(run, lattice(8, 4))
        (run / "frames" / "soil_00001.hdf").write_bytes(b"nothing")
        index, _ = scarp_picture.run_picture(run, 1e6)
        self.assertEqual(len(index["frames"]), 1)
        self.assertIn("soil_00001.hdf", index["notes"][0])

    def test_faces_of_walls_and_their_names(self):
        run = self.folder / "run"
        write_run(run, lattice(8, 4))
        with h5py.File(run / "frames" / "walls.hdf", "w") as file:
            file["VTKHDF/Points"] = np.zeros((0, 3))
            file["faces/corners"] = np.array([[[0.0, 0, 0], [2, 0, 0]]])
            file["faces/wall"] = np.array([0], dtype=np.int32)
            file["faces/wall"].attrs["names"] = "base\n"
        index, _ = scarp_picture.run_picture(run, 1e6)
        self.assertEqual(index["walls"], [{"names": ["base"], "wall": [0], "corners": [[0.0, 0, 0, 2, 0, 0]]}])
        self.assertEqual([frame["walls"] for frame in index["frames"]], [0, 0])

    def test_materials_have_the_names_of_the_scene(self):
        (self.folder / "run.json").write_text(json.dumps({"text": '[[material]]\nname = "rock"\nmodel = "linear_elastic"\n'
                                                                  '[[material]]\nname = "clay"\n'}))
        self.assertEqual(scarp_picture.materials_of(self.folder), [{"name": "rock", "model": "linear_elastic"},
                                                                   {"name": "clay", "model": "drucker_prager"}])

    def report(self, run, viewer, **options):
        os.environ["SCARP_VIEWER"] = str(viewer)
        self.addCleanup(os.environ.pop, "SCARP_VIEWER")
        return scarp_report.report(run, **options).read_text(encoding="utf-8")

    def test_a_report_without_the_viewer_says_how_to_get_it(self):
        write_run(self.folder / "run", lattice(8, 4))
        text = self.report(self.folder / "run", self.folder / "none.js")
        self.assertIn("scarp was built without it", text)
        self.assertNotIn("data-block", text)

    def test_a_report_holds_the_picture_once_and_whole(self):
        viewer = self.folder / "viewer.js"
        viewer.write_text("/* the viewer */")
        write_run(self.folder / "run", lattice(8, 4))
        text = self.report(self.folder / "run", viewer)
        self.assertEqual(text.count("/* the viewer */"), 1)
        index = json.loads(re.search(r"data-index>(.*?)</script>", text).group(1))
        self.assertEqual(index["title"], "T")
        wanted = {f"{k}/{name}" for k, frame in enumerate(index["frames"]) for name in ("position", *frame["fields"])}
        self.assertEqual(set(re.findall(r'data-block="(.*?)"', text)), wanted)

    def test_a_report_without_a_picture_is_asked_for(self):
        write_run(self.folder / "run", lattice(8, 4))
        self.assertNotIn("scarp-picture", self.report(self.folder / "run", self.folder / "none.js", budget=0))

    def test_the_page_of_a_search_shows_the_failure(self):
        viewer = self.folder / "viewer.js"
        viewer.write_text("/* the viewer */")
        write_fos(self.folder, lattice(16, 8))
        self.assertIn("data-block", self.report(self.folder, viewer))


if __name__ == "__main__":
    unittest.main()
