# SPDX-License-Identifier: BSD-3-Clause
"""Folders as the program leaves them, made without it."""

import json

import h5py
import numpy as np


def lattice(*sizes, spacing=0.25):
    axes = [spacing * (np.arange(n) + 0.5) for n in sizes]
    points = np.stack([a.ravel() for a in np.meshgrid(*axes, indexing="ij")], axis=1)
    return np.pad(points, ((0, 0), (0, 3 - points.shape[1])))


def write_frame(path, position, dimension=2, time=0.0, event="interval", stage="fail", spacing=0.25):
    count = len(position)
    with h5py.File(path, "w") as file:
        file.attrs.update(time=time, step=[7], stage_index=[0], stage=np.bytes_(stage),
                          event=np.bytes_(event), title=np.bytes_("T"), dimension=[dimension],
                          spacing=spacing)
        grid = file.create_group("VTKHDF")
        grid["Points"] = position.astype("f4")
        data = grid.create_group("PointData")
        data["displacement"] = np.outer(np.arange(count), [3.0, 4.0, 0.0]).astype("f4")
        data["displacement"].attrs["unit"] = np.bytes_("m")
        data["stress"] = np.outer(np.ones(count), [1.0, 2, 3, 4, 5, 6]).astype("f4")
        data["accumulated_plastic_strain"] = np.linspace(0, 1, count).astype("f4")
        data["id"] = np.arange(count)


def write_run(folder, position, dimension=2, **results):
    """A run of two frames, the second sheared, with tables and results."""
    frames = folder / "frames"
    frames.mkdir(parents=True)
    write_frame(frames / "soil_00000.hdf", position, dimension, 0.0, "start")
    moved = position + 0.2 * position[:, [dimension - 1]] * [1.0, 0.0, 0.0]
    write_frame(frames / "soil_00001.hdf", moved, dimension, 2.0, "stage_end")
    (frames / "soil.hdf.series").write_text(json.dumps({"file-series-version": "1.0", "files": [
        {"name": "soil_00000.hdf", "time": 0.0}, {"name": "soil_00001.hdf", "time": 2.0}]}))
    (folder / "probes.csv").write_text(
        "time [s],stage,toe.displacement_x [m],toe.displacement_y [m],toe.velocity_x [m/s],"
        "toe.velocity_y [m/s]\n0,settle,0,0,0,0\n1,fail,3,4,0,1\n2,fail,3,4")
    (folder / "walls.csv").write_text("time [s],stage,base.force_x [N/m]\n0,settle,0\n2,fail,5\n")
    (folder / "energy.csv").write_text("time [s],stage,kinetic [J/m],wall [J/m]\n0,s,0,0\n2,s,5,0\n")
    (folder / "history.csv").write_text("time [s],stage,step,time_step [s],limit,max_velocity [m/s]\n"
                                        "0,s,0,0,acoustic,0\n2,s,9,0.1,acoustic,1\n")
    (folder / "results.json").write_text(json.dumps({"case": folder.name, "title": "Slope <1>", **results}))


def write_fos(folder, position):
    """What `scarp fos` leaves: two trials and the run of the failure."""
    trial = {"displacement": 0.02, "speed": 0.1, "time": 2.0, "end": "window over", "steps": 9, "wall_s": 0.5}
    write_run(folder / "failure", position)
    (folder / "fos.json").write_text(json.dumps({
        "title": "Slope", "spacing": 0.25, "preset": "modern", "factor_of_safety": 1.3, "stands": 1.2, "fails": 1.4,
        "failure": None, "resolution": "coarse", "notes": ["a note"], "particles": len(position), "wall_s": 3.0,
        "isa": "sse2", "threads": 1, "settle": {"time": 1.0, "wall_s": 1.0}, "elastic": {"wall_s": 0.5},
        "criterion": {"sentence": "moved", "limit": 0.1, "elastic": 0.01, "spacings_in_height": 8.0},
        "trials": [dict(trial, reduction=1.2, fails=False), dict(trial, reduction=1.4, fails=True)]}))


def write_converge(folder):
    """What `scarp converge` leaves."""
    runs = [{"spacing": dx, "particles": 9, "steps": 9, "wall_s": 1.0 / dx, "mass": 2.0, "reused": False}
            for dx in (1.0, 0.5, 0.25)]
    quantity = {"name": "top.displacement", "unit": "m", "component": False, "values": [1.0, 1.1, 1.12],
                "errors": [0.1, 0.02, 0.005], "observed_order": 2.0, "order": 2.0, "trend": "converging",
                "extrapolated": 1.13, "remark": ""}
    (folder / "converge.json").write_text(json.dumps({
        "title": "Column", "preset": "modern", "isa": "sse2", "threads": 1, "runs": runs, "quantities": [quantity],
        "advice": [{"sentence": "Take 0.5 m."}], "notes": ["a note"]}))
