# SPDX-License-Identifier: BSD-3-Clause
"""Runs with known fields, and the pages of their pictures. usage: make_pages.py REPORT_SCRIPTS FOLDER; $SCARP_VIEWER is the script"""

import json
import pathlib
import sys

import h5py
import numpy as np

sys.path[:0] = [sys.argv[1], str(pathlib.Path(__file__).resolve().parents[1] / "report")]
import scarp_picture  # noqa: E402
import scarp_viewer  # noqa: E402
from run_folder import lattice, write_run  # noqa: E402

FOLDER = pathlib.Path(sys.argv[2])
MATERIALS = '[[material]]\nname = "rock"\nmodel = "linear_elastic"\n[[material]]\nname = "clay"\n'


def made(name, position, dimension, faces, budget=40e6):
    """Displacement grows with x from 0 to 1 m, and from the first frame to the second nothing else changes but the shear of
    write_run; what is in the lower half is rock."""
    folder = FOLDER / name
    write_run(folder, position, dimension)
    (folder / "run.json").write_text(json.dumps({"text": MATERIALS}))
    along, up = position[:, 0], position[:, dimension - 1]
    for frame in (folder / "frames").glob("soil_*.hdf"):
        with h5py.File(frame, "r+") as file:
            data = file["VTKHDF/PointData"]
            data["displacement"][...] = np.outer((along - along.min()) / np.ptp(along), [1.0, 0.0, 0.0])
            data["stress"].attrs["unit"] = np.bytes_("Pa")
            data["material"] = (up > 0.5 * (up.min() + up.max())).astype("i4")
    with h5py.File(folder / "frames" / "walls.hdf", "w") as file:
        file["VTKHDF/Points"] = np.zeros((0, 3))
        file["faces/corners"] = np.array(faces, dtype=float)
        file["faces/wall"] = np.zeros(len(faces), dtype="i4")
        file["faces/wall"].attrs["names"] = "base\n"
    index, blocks = scarp_picture.run_picture(folder, budget)
    element = scarp_viewer.picture_element(index, blocks, " alone")
    (FOLDER / f"{name}.html").write_text(scarp_viewer.picture_page(index["title"], element), encoding="utf-8")


base = [[[-1, -1, 0], [9, -1, 0], [9, 6, 0], [-1, 6, 0]]]
made("plane", lattice(40, 20), 2, [[[-1, 0, 0], [11, 0, 0]]])
made("space", lattice(32, 20, 16), 3, base)
made("thinned", lattice(48, 40, 30) + 0.01 * np.random.default_rng(1).normal(size=(57_600, 3)), 3, base, 4e5)
