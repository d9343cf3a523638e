# SPDX-License-Identifier: BSD-3-Clause
"""Reads what a run leaves behind: frames, tables, results.json."""

import csv
import json
import pathlib
import re

import h5py
import numpy as np


def _text(value):
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


def frame_info(path):
    """The moment of a frame without its particles: time [s], step, stage, stage_index, event, title,
    dimension, spacing [m], and its path."""
    with h5py.File(path, "r") as file:
        return _info(file, path)


def _info(file, path):
    info = {"path": pathlib.Path(path)}
    for name, value in file.attrs.items():
        value = value[0] if isinstance(value, np.ndarray) else value
        info[name] = _text(value) if isinstance(value, (bytes, str)) else value.item()
    for name, fallback in (("time", 0.0), ("stage", ""), ("event", ""), ("dimension", 3)):
        info.setdefault(name, fallback)
    return info


def load_frame(path):
    """frame_info plus `position` (n, 3) [m], `fields` {name: array} and `units` {name: unit}. Particles
    with a position that is not finite (a run that failed) are left out."""
    with h5py.File(path, "r") as file:
        frame = _info(file, path)
        grid = file["VTKHDF"]
        position = np.asarray(grid["Points"], dtype=float)
        good = np.isfinite(position).all(axis=1)
        frame["position"] = position[good]
        frame["fields"], frame["units"] = {}, {}
        for name, data in grid["PointData"].items():
            frame["fields"][name] = np.asarray(data)[good]
            frame["units"][name] = _text(data.attrs.get("unit", ""))
    return frame


def scalar(frame, field):
    """A field as one number per particle: itself, the length of a vector; "stress_yy" and
    "displacement_x" name components; "x", "y", "z" coordinates."""
    if field in ("x", "y", "z"):
        return frame["position"][:, "xyz".index(field)]
    fields = frame["fields"]
    if field in fields:
        values = np.asarray(fields[field], dtype=float)
        return np.linalg.norm(values, axis=1) if values.ndim == 2 else values
    name, _, component = field.rpartition("_")
    components = {3: ["x", "y", "z"], 6: ["xx", "yy", "zz", "xy", "yz", "zx"]}
    if name in fields and fields[name].ndim == 2:
        names = components[fields[name].shape[1]]
        if component in names:
            return np.asarray(fields[name][:, names.index(component)], dtype=float)
    raise KeyError(f"the frame has no field '{field}'; it has {', '.join(sorted(fields))}")


def read_series(folder, name="soil"):
    """Paths and times of the frames of a run folder, in order: [(path, time)]; empty without frames."""
    folder = pathlib.Path(folder)
    for frames in (folder / "frames", folder):
        series = frames / f"{name}.hdf.series"
        if series.exists():
            with open(series, encoding="utf-8") as file:
                return [(frames / entry["name"], entry["time"]) for entry in json.load(file)["files"]]
    return []


def load_walls(folder, number=0):
    """Positions of the wall dummies [m] at frame `number`, or None."""
    frames = pathlib.Path(folder) / "frames"
    for path in (frames / f"walls_{number:05}.hdf", frames / "walls.hdf"):
        if path.exists():
            with h5py.File(path, "r") as file:
                return np.asarray(file["VTKHDF/Points"], dtype=float)
    return None


def read_table(path):
    """A CSV table of a run: ({column: numbers or list of texts}, {column: unit}), the units cut from the
    titles. None if there is no such file or no row."""
    path = pathlib.Path(path)
    if not path.exists():
        return None
    with open(path, newline="", encoding="utf-8") as file:
        rows = [row for row in csv.reader(file) if row]
    if len(rows) < 2:
        return None
    rows = [row for row in rows if len(row) == len(rows[0])]  # a killed run may leave half a row
    columns, units = {}, {}
    for number, title in enumerate(rows[0]):
        match = re.fullmatch(r"(.*?) \[(.*)\]", title)
        name = match.group(1) if match else title
        units[name] = match.group(2) if match else ""
        texts = [row[number] for row in rows[1:]]
        try:
            columns[name] = np.array([float(text) for text in texts])
        except ValueError:
            columns[name] = texts
    return columns, units


def read_results(folder):
    """results.json of a run folder, {} if there is none."""
    path = pathlib.Path(folder) / "results.json"
    if not path.exists():
        return {}
    with open(path, encoding="utf-8") as file:
        return json.load(file)
