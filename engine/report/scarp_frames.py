# SPDX-License-Identifier: BSD-3-Clause
"""Reads what a run leaves behind: frames, tables, results.json."""

import contextlib
import csv
import json
import math
import pathlib
import re

import h5py
import numpy as np


class Damaged(Exception):
    """A file that is not what a run writes. The message is a sentence that names it."""

    def __init__(self, path, why):
        super().__init__(f"'{path}': {why}; it is damaged or of another version.")


@contextlib.contextmanager
def _reading(path):
    """Whatever a reader says of a file becomes Damaged."""
    try:
        yield
    except (Damaged, FileNotFoundError):
        raise
    except Exception as error:  # every library has its own kinds, and a bad file brings out any of them
        words = " ".join(str(error).split())[:200]
        raise Damaged(path, f"cannot be read ({type(error).__name__}{': ' + words if words else ''})") from error


def read_json(path):
    """The object in a JSON file."""
    with _reading(path), open(path, encoding="utf-8") as file:
        value = json.load(file)
    if not isinstance(value, dict):
        raise Damaged(path, "is no JSON object")
    return value


def _stored(data, path):
    """The numbers of a dataset. One that claims more of them than its file holds is not believed."""
    if data.nbytes > pathlib.Path(path).stat().st_size:
        raise Damaged(path, f"claims {data.nbytes:.3g} bytes in '{data.name}', more than it has")
    values = np.asarray(data)
    if values.dtype.kind not in "fiu":
        raise Damaged(path, f"has no numbers in '{data.name}'")
    return values


def _text(value):
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


def frame_info(path):
    """The moment of a frame without its particles: time [s], step, stage, stage_index, event, title,
    dimension, spacing [m], and its path."""
    with _reading(path), h5py.File(path, "r") as file:
        return _info(file, path)


def _info(file, path):
    info = {"path": pathlib.Path(path)}
    for name, value in file.attrs.items():
        value = value[0] if isinstance(value, np.ndarray) else value
        info[name] = _text(value) if isinstance(value, (bytes, str)) else value.item()
    for name, fallback in (("time", 0.0), ("stage", ""), ("event", ""), ("dimension", 3)):
        info.setdefault(name, fallback)
    for name, good in (("dimension", info["dimension"] in (2, 3)), ("time", _is_number(info["time"])),
                       ("spacing", _is_number(info.get("spacing")) and info["spacing"] > 0.0),
                       ("stage", isinstance(info["stage"], str)), ("event", isinstance(info["event"], str))):
        if not good:
            raise Damaged(path, f"its {name} is {info.get(name)!r}")
    return info


def _is_number(value):
    return isinstance(value, (int, float)) and math.isfinite(value)


def load_frame(path):
    """frame_info plus `position` (n, 3) [m], `fields` {name: array}, and by name `units` and `descriptions`. Particles
    with a position that is not finite (a run that failed) are left out."""
    with _reading(path), h5py.File(path, "r") as file:
        frame = _info(file, path)
        grid = file["VTKHDF"]
        position = _positions(grid["Points"], path)
        good = np.isfinite(position).all(axis=1)
        frame["position"] = position[good]
        frame["fields"], frame["units"], frame["descriptions"] = {}, {}, {}
        for name, data in grid["PointData"].items():
            values = _stored(data, path)
            if values.ndim not in (1, 2) or len(values) != len(position) or (
                    values.ndim == 2 and values.shape[1] not in (3, 6)):
                raise Damaged(path, f"'{name}' has the shape {values.shape} for {len(position)} particles")
            frame["fields"][name] = values[good]
            frame["units"][name] = _text(data.attrs.get("unit", ""))
            frame["descriptions"][name] = _text(data.attrs.get("description", ""))
    if len(frame["position"]) == 0:
        raise Damaged(path, "holds no particle that is anywhere")
    return frame


def _positions(data, path):
    position = np.asarray(_stored(data, path), dtype=float)
    if position.ndim != 2 or position.shape[1] != 3:
        raise Damaged(path, f"its points have the shape {position.shape}")
    return position


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


def in_view(frame):
    """The frame without grains that lie so far out that the others would vanish beside them, and a sentence about
    these; the frame itself and "" where there are none. Far out: the box of all is more than four times as long as
    that of all but the outermost 0.05 % (three at least) at each end of an axis."""
    position = frame["position"]
    count = len(position)
    trim = max(-(-count // 2000), 3) if count >= 40 else count // 10
    if trim == 0:
        return frame, ""
    ordered = np.partition(position, [trim, count - 1 - trim], axis=0)
    low, high = ordered[trim], ordered[count - 1 - trim]
    room = 1.5 * np.maximum(high - low, 20 * frame["spacing"])
    near = ((position >= low - room) & (position <= high + room)).all(axis=1)
    if near.all():
        return frame, ""
    away = np.maximum(low - position, position - high).max(axis=1)
    seen = dict(frame, position=position[near], fields={n: v[near] for n, v in frame["fields"].items()})
    left = count - int(near.sum())
    return seen, (f"{left} grain{'s lie' if left > 1 else ' lies'} outside this picture, the farthest "
                  f"{away.max():.3g} m away.")


def read_series(folder, name="soil"):
    """Paths and times of the frames of a run folder, in order: [(path, time)]; empty without frames."""
    folder = pathlib.Path(folder)
    for frames in (folder / "frames", folder):
        series = frames / f"{name}.hdf.series"
        if series.exists():
            listed = read_json(series)
            with _reading(series):
                return [(frames / entry["name"], entry["time"]) for entry in listed["files"]]
    return []


def _walls_file(folder, number):
    frames = pathlib.Path(folder) / "frames"
    return next((path for path in (frames / f"walls_{number:05}.hdf", frames / "walls.hdf") if path.exists()), None)


def load_walls(folder, number=0):
    """Positions of the wall dummies [m] at frame `number`, or None."""
    path = _walls_file(folder, number)
    if path is None:
        return None
    with _reading(path), h5py.File(path, "r") as file:
        position = _positions(file["VTKHDF/Points"], path)
        return position[np.isfinite(position).all(axis=1)]


def load_faces(folder, number=0):
    """The faces of the walls that stand at frame `number`: `corners` (n, 2 or 4, 3) [m], `wall` (n), the number of the wall
    that each is a part of, and `names` of all walls. None where the run left none."""
    path = _walls_file(folder, number)
    if path is None:
        return None
    with _reading(path), h5py.File(path, "r") as file:
        if "faces" not in file:  # of an earlier version
            return None
        corners, wall = (_stored(file[f"faces/{name}"], path) for name in ("corners", "wall"))
        names = _text(file["faces/wall"].attrs["names"]).splitlines()
        if corners.ndim != 3 or corners.shape[1:] not in ((2, 3), (4, 3)) or wall.shape != corners.shape[:1] or (
                wall.size and not 0 <= wall.min() <= wall.max() < len(names)) or not np.isfinite(corners).all():
            raise Damaged(path, "its faces are none")
        return {"corners": corners, "wall": wall, "names": names}


def read_table(path):
    """A CSV table of a run: ({column: numbers or list of texts}, {column: unit}), the units cut from the
    titles. What is not finite is NaN. None if there is no such file or no row."""
    path = pathlib.Path(path)
    if not path.exists():
        return None
    with _reading(path), open(path, newline="", encoding="utf-8") as file:
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
            values = np.array([float(text) for text in texts])
            columns[name] = np.where(np.isfinite(values), values, np.nan)
        except ValueError:
            columns[name] = texts
    if len(rows) < 2:
        raise Damaged(path, "has no row as long as its head")
    return columns, units


def read_history(path):
    """A table over time, as `read_table` gives it."""
    table = read_table(path)
    if table and not isinstance(table[0].get("time"), np.ndarray):
        raise Damaged(path, "has no column of times")
    return table


def read_results(folder):
    """results.json of a run folder, {} if there is none."""
    path = pathlib.Path(folder) / "results.json"
    if not path.exists():
        return {}
    return read_json(path)


def frames_of(folder, event):
    """The frames written at the end of a stage, in order; `event` as in the frames' attribute."""
    infos = [frame_info(path) for path, _ in read_series(folder) if path.exists()]
    return [info for info in infos if info["event"] == event]
