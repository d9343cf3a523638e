# SPDX-License-Identifier: BSD-3-Clause
"""The particles of a run for the picture that moves: packed so that a page can hold them, or a server send them.

A picture has an index (a dict for JSON) and blocks of bytes: one for the positions of a frame and one for each field.
engine/viewer/src/decode.js reads them:

"box16"   whole numbers of 16 bits, from the low to the high corner of the frame's box; of each axis the steps from
          particle to particle
"half"    (value - offset) / scale as floats of 16 bits, which are true to 0.05 %
"steps32" whole numbers, the steps from particle to particle
"bytes"   whole numbers up to 255
"doubles" numbers as they are

Components follow one another. Of numbers with several bytes all first bytes come first, because like bytes compress better.
"""

import tomllib
import zlib

import numpy as np

from scarp_frames import Damaged, frame_info, in_view, load_faces, load_frame, read_json, read_series

MOST_POINTS = 2_000_000  # what an ordinary laptop turns at 20 pictures a second
PLANE = {1: [0], 3: [0, 1], 6: [0, 1, 2, 3]}  # components that plane strain has


def _packed(values):
    """Bytes of the numbers, the first of each, then the second of each, compressed."""
    columns = np.ascontiguousarray(values).view(np.uint8).reshape(-1, values.dtype.itemsize).T
    return zlib.compress(np.ascontiguousarray(columns).tobytes(), 4)


def _steps(numbers, kind):
    """Each number less the one before, along the last axis; what leaves the range comes in again at its other end."""
    return np.diff(numbers.astype(kind), axis=-1, prepend=kind(0)).astype(kind)


def _half(values):
    """(floats of 16 bits, offset, scale) of numbers; what is not finite becomes NaN. Numbers far from 0 are counted from the
    one nearest to 0, so that small differences between them stay."""
    finite = values[np.isfinite(values)]
    low, high = (float(finite.min()), float(finite.max())) if finite.size else (0.0, 0.0)
    offset = low if low > 0.5 * high > 0.0 else high if high < 0.5 * low < 0.0 else 0.0
    scale = max(high - offset, offset - low) / 2.0**15 or 1.0  # the largest numbers that 16 bits hold are twice as large
    numbers = np.where(np.isfinite(values), (values - offset) / scale, np.nan)
    return numbers.astype(np.float16), offset, scale


def limits(values):
    """From the smallest to the largest value without the 0.2 % most extreme; from 0 where most of that is below."""
    values = values[np.isfinite(values)]
    if values.size == 0:
        return [0.0, 0.0]
    low, high = (float(number) for number in np.percentile(values, [0.2, 99.8]))
    return [0.0 if 0.0 <= low < 0.5 * high else low, high]


def _drawn(ids, share):
    """Which particles are taken where not all are: drawn by their ids, so that they are the same in every frame."""
    number = ids.astype(np.uint64) + np.uint64(0x9E3779B97F4A7C15)
    with np.errstate(over="ignore"):  # splitmix64, whose numbers are as good as drawn
        number = (number ^ (number >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
        number = (number ^ (number >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return (number ^ (number >> np.uint64(31))) < np.uint64(min(share, 1.0) * (2**64 - 2048))


def _kind_of_whole_numbers(columns):
    low, high = columns.min(), columns.max()
    return "bytes" if low >= 0 and high < 256 else "steps32" if -2**31 <= low and high < 2**31 else "doubles"


INVARIANTS = {
    "mean_stress": (lambda s: s[:, :3].mean(axis=1), "mean of the normal stresses, tension positive"),
    "deviatoric_stress": (lambda s: np.sqrt(0.5 * ((s[:, 0] - s[:, 1])**2 + (s[:, 1] - s[:, 2])**2 + (s[:, 2] - s[:, 0])**2)
                                            + 3.0 * (s[:, 3:]**2).sum(axis=1)), "q = sqrt(3 J2)"),
}


def with_invariants(frame):
    """The frame with the invariants of its stress as fields of their own."""
    frame = {**frame, "fields": dict(frame["fields"]), "units": dict(frame["units"]),
             "descriptions": dict(frame["descriptions"])}
    stress = frame["fields"].get("stress")
    if stress is not None and stress.ndim == 2:
        for name, (value, description) in INVARIANTS.items():
            frame["fields"][name] = value(stress.astype(float))
            frame["units"][name], frame["descriptions"][name] = frame["units"]["stress"], description
    return frame


class PackedFrame:
    """One moment: `entry` for the index, `blocks` by name. `frame` as load_frame gives it; of its particles a share is taken."""

    def __init__(self, frame, share=1.0):
        frame, self.outside = in_view(with_invariants(frame))
        self.blocks, ids = {}, frame["fields"].get("id", np.arange(len(frame["position"])))
        taken = _drawn(ids, share) if share < 1.0 else slice(None)
        position = frame["position"][taken]
        axes = [0, 1] if frame["dimension"] == 2 else [0, 1, 2]
        self.entry = {name: frame.get(name) for name in ("time", "step", "stage", "event")}
        self.entry.update(count=len(position), fields={})
        self._put_position(position[:, axes].T)
        for name, values in {"id": ids, **frame["fields"]}.items():
            values = np.asarray(values)[taken]
            columns = values.reshape(len(values), -1).T
            if frame["dimension"] == 2:
                columns = columns[PLANE[len(columns)]]
            self._put(name, columns)

    def _put_position(self, columns):
        low, high = columns.min(axis=1), columns.max(axis=1)
        step = np.maximum(high - low, 1e-12) / 65535.0
        places = np.rint((columns - low[:, None]) / step[:, None]).astype(np.uint16)
        self.entry["box"] = [low.tolist(), high.tolist()]
        self.blocks["position"] = _packed(_steps(places, np.uint16))

    def _put(self, name, columns):
        if columns.dtype.kind in "iu":
            kind = _kind_of_whole_numbers(columns)
            packed = _packed({"bytes": lambda: columns.astype(np.uint8), "steps32": lambda: _steps(columns, np.int32),
                              "doubles": lambda: columns.astype(np.float64)}[kind]())
            self.entry["fields"][name] = {"kind": kind, "components": len(columns)}
        else:
            numbers, offset, scale = _half(columns.astype(float))
            packed = _packed(numbers)
            self.entry["fields"][name] = {"kind": "half", "components": len(columns), "offset": offset, "scale": scale}
        shown = [limits(column) for column in columns.astype(float)]
        if len(columns) in (2, 3):  # a vector; its length comes first
            shown = [limits(np.linalg.norm(columns.astype(float), axis=0))] + shown
        self.entry["fields"][name]["limits"] = shown
        self.blocks[name] = packed

    def size(self):
        return sum(len(block) for block in self.blocks.values())


def head(title, frame, materials):
    """What all moments have in common. `materials`: name and model of each, as materials_of gives them."""
    frame = with_invariants(frame)
    fields = [{"name": name, "unit": frame["units"].get(name, ""), "description": frame["descriptions"].get(name, "")}
              for name in frame["fields"]]
    return {"format": "scarp picture", "version": 1, "title": title, "dimension": frame["dimension"], "spacing": frame["spacing"],
            "disc": frame["spacing"], "fields": fields, "materials": materials, "notes": [], "walls": []}


def materials_of(folder):
    """Name and model of each material, in the order of the field `material`; none of a run that keeps no scene."""
    path = folder / "run.json"
    try:
        text = read_json(path)["text"] if path.exists() else (folder / "scene.toml").read_text(encoding="utf-8")
        return materials_in(text)
    except (OSError, KeyError):
        return []


def materials_in(scene_text):
    """The same from the text of a scene."""
    try:
        return [{"name": str(m["name"]), "model": m.get("model", "drucker_prager")} for m in tomllib.loads(scene_text)["material"]]
    except (KeyError, TypeError, AttributeError, ValueError):
        return []


def chosen(moments, most):
    """At most `most` moments: the first, the last, ends of stages, then those in between at equal distances."""
    if len(moments) <= most:
        return moments
    ends = [0, len(moments) - 1] + [k for k, moment in enumerate(moments) if moment.info["event"] in ("stage_end", "stopped")]
    kept = set(list(dict.fromkeys(ends))[:most])
    for k in np.linspace(0, len(moments) - 1, most).round().astype(int):
        if len(kept) < most:
            kept.add(int(k))
    return [moments[k] for k in sorted(kept)]


LEAST_FRAMES = 12  # before particles are left out


def plan(frame_count, particles, bytes_per_particle, budget):
    """(frames, particles) of a page of `budget` bytes: all that fits; else fewer frames, but at least 12; then fewer
    particles."""
    points = budget / bytes_per_particle  # of all frames together
    shown = min(particles, MOST_POINTS)
    frames = min(frame_count, max(int(points // shown), min(LEAST_FRAMES, frame_count)))
    return frames, int(min(shown, max(points // frames, 1000)))


def walls_of(faces):
    """Faces as the index holds them."""
    return {"names": faces["names"], "wall": faces["wall"].tolist(),
            "corners": [[round(float(x), 9) for x in face.ravel()] for face in faces["corners"]]}


SAMPLE = slice(0, 100_000)  # of the particles, whose size stands for that of all


def bytes_per_particle(frames, share):
    """Of the text in base64 of a share of the particles, over several frames."""
    packed = [PackedFrame({**frame, "position": frame["position"][SAMPLE],
                           "fields": {name: values[SAMPLE] for name, values in frame["fields"].items()}}, share) for frame in frames]
    return sum(each.size() for each in packed) * 4 / 3 / sum(each.entry["count"] for each in packed)


class StoredMoment:
    """A frame of a run's folder; other moments have the same members."""

    def __init__(self, folder, number, path):
        self.folder, self.number, self.path = folder, number, path
        self.info = frame_info(path)

    def load(self):
        return load_frame(self.path)

    def faces(self):
        return load_faces(self.folder, self.number)


def stored_moments(folder, left_out):
    """Those of a run's folder; `left_out` takes a sentence about each that is damaged."""
    moments = []
    for number, (path, _) in enumerate(read_series(folder)):
        try:
            if path.exists():
                moments.append(StoredMoment(folder, number, path))
        except Damaged as error:
            left_out.append(str(error))
    return moments


def run_picture(folder, budget):
    """The picture of the run in a folder; None if it left no frame."""
    left_out = []
    moments = stored_moments(folder, left_out)
    if not moments:
        return None
    return picture_of(moments, moments[0].info.get("title") or folder.name, materials_of(folder), budget, left_out)


def _first_sound(moments, left_out):
    for moment in moments:
        try:
            return moment.load()
        except Damaged as error:
            left_out.append(str(error))
    raise Damaged(moments[0].path, "holds no particles, as no other frame does")


def picture_of(moments, title, materials, budget, left_out=()):
    """(index, blocks by name) of moments; of text in base64 the blocks have at most about `budget` bytes. What is damaged is
    left out, and said to the reader after the sentences in `left_out`."""
    left_out = list(left_out)
    first, last = _first_sound(moments, left_out), _first_sound(moments[::-1], left_out)
    total = len(first["position"])
    share = 1.0
    for _ in range(3):  # the fewer they are the less well they compress
        count, particles = plan(len(moments), total, bytes_per_particle((first, last), share), budget)
        share = particles / total
        if share == 1.0:
            break
    index, blocks, walls = head(title, first, materials), {}, []
    index["frames"] = []
    index["disc"] *= share ** (-1.0 / index["dimension"])  # discs in place of more particles cover as much
    for moment in chosen(moments, count):
        try:
            packed, faces = PackedFrame(moment.load(), share), moment.faces()
        except Damaged as error:
            left_out.append(str(error))
            continue
        entry = dict(packed.entry, number=moment.number, outside=packed.outside)
        if faces is not None:
            shown = walls_of(faces)
            if shown not in walls:
                walls.append(shown)
            entry["walls"] = walls.index(shown)
        blocks.update((f"{len(index['frames'])}/{name}", block) for name, block in packed.blocks.items())
        index["frames"].append(entry)
    index["walls"] = walls
    index["notes"] = notes(len(moments), count, total, share, budget) + [f"Left out: {why}" for why in dict.fromkeys(left_out)]
    return index, blocks


def _grouped(count):
    return f"{round(count):,}".replace(",", "\u202f")


def notes(frame_count, shown, total, share, budget):
    """What the picture leaves out, in words for its reader."""
    told = []
    if shown < frame_count:
        told.append(f"{shown} of the run's {frame_count} moments are in this page, whose picture may take {budget / 1e6:.0f} MB: "
                    "the first, the last, the ends of stages, and others at equal distances between them.")
    if share < 1.0:
        told.append(f"{_grouped(share * total)} of {_grouped(total)} particles are drawn, chosen at random, the same at every "
                    "moment; their discs are larger to fill the gaps.")
    return told
