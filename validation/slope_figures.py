# SPDX-License-Identifier: BSD-3-Clause
"""What the figures of the 3D slopes share: their runs, views, sections and histories."""

import json

import numpy as np
import scarp_report as scarp

plt = scarp.plt
ZOOM = 1.12  # 3D axes leave wide margins
STYLES = {"concave": ("#0072b2", "-"), "straight": ("#009e73", "-"), "convex": ("#d55e00", "-"),
          "2D": ("#000000", "--"), "2D by Eq. 11": ("#777777", ":")}


class Runs:
    """The runs of one reading: frames and probes by shape ("convex corner")."""

    def __init__(self, folder, reading):
        self.folder, self.reading = folder, reading

    def path(self, shape):
        return self.folder / self.reading["runs"][shape]

    def initial(self, shape):
        return scarp.load_frame(scarp.read_series(self.path(shape))[0][0])

    def last(self, shape):
        return scarp.load_frame(scarp.read_series(self.path(shape))[-1][0])

    def history(self, shape, probe, kind):
        """Time since the strength was cut [s] and settlement or advance of a probe [m]."""
        columns, _ = scarp.read_table(self.path(shape) / "probes.csv")
        slide = np.array([stage == "slide" for stage in columns["stage"]])
        part = {c: columns[f"{probe}.displacement_{c}"][slide] for c in "xyz" if f"{probe}.displacement_{c}" in columns}
        up = "z" if "z" in part else "y"
        diagonal = probe.startswith("P")  # section P of the corners; the others lie along x
        forward = (part["x"] + part["y"]) / np.sqrt(2) if diagonal else part["x"]
        moved = -part[up] if kind == "settlement" else forward
        time = columns["time"][slide]
        return time - time[0], moved - moved[0]


def load(folder):
    """Runs of the finest spacing with the first reading's choices, those of every reading by name, slide share."""
    path = folder / "readings.json"
    if not path.exists():
        return None, {}, 0.0
    data = json.loads(path.read_text(encoding="utf-8"))
    readings = {one["name"]: Runs(folder, one) for one in data["readings"]}
    plain = [r for r in readings.values() if r.reading["name"] == "base" or r.reading["name"].startswith("dx ")]
    return min(plain, key=lambda r: r.reading["spacing"]), readings, data["slide_share"]


def draw(page, folder, figures, parts):
    """The page of a case of the slopes: each part draws from runs, readings and the share of the height that a
    slide body has moved over at least."""
    runs, readings, share = load(folder)
    if runs is None:
        return
    page.text(f"Figures of the reading “{runs.reading['name']}”, dx = {runs.reading['spacing']:.3g} m.")
    for each in parts:
        each(page, runs, readings, share, figures)


def part(frame, mask):
    return dict(frame, position=frame["position"][mask],
                fields={name: values[mask] for name, values in frame["fields"].items()})


def mirrored(frame):
    """Both sides of the symmetry plane y = 0."""
    other = frame["position"] * [1, -1, 1]
    return dict(frame, position=np.concatenate([frame["position"], other]),
                fields={name: np.concatenate([values, values]) for name, values in frame["fields"].items()})


def slide_body(frame, least):
    """Soil that has moved more than `least` [m]."""
    return part(frame, np.linalg.norm(frame["fields"]["displacement"], axis=1) > least)


def settled_place(frame):
    return frame["position"] - frame["fields"]["displacement"]


def common_limits(frames, field):
    values = [scarp.colour_limits(scarp.scalar(frame, field)) for frame in frames]
    return min(low for low, _ in values), max(high for _, high in values)


def views(page, rows, file, caption):
    """Rows of 3D views: (title, [(frame, field, words)], view); one colour scale for each field."""
    fields = {field for _, cells, _ in rows for _, field, _ in cells}
    limits = {field: common_limits([f for _, cells, _ in rows for f, one, _ in cells if one == field], field)
              for field in fields}
    wide = max(len(cells) for _, cells, _ in rows)
    figure = plt.figure(figsize=(4.1 * wide, 3.8 * len(rows)))
    last = {}
    for r, (title, cells, view) in enumerate(rows):
        for c, (frame, field, words) in enumerate(cells):
            ax = figure.add_subplot(len(rows), wide, r * wide + c + 1, projection="3d")
            scarp.draw_particles_3d(ax, frame, field, limits[field], bar=False, view=view,
                                    title=f"({chr(97 + r * wide + c)}) {title}: {words}")
            ax.tick_params(labelsize=7, pad=-2)
            ax.set_box_aspect(np.maximum(np.ptp(frame["position"], axis=0), frame["spacing"]), zoom=ZOOM)
            ax.collections[-1].set_sizes(ax.collections[-1].get_sizes() * ZOOM**2)
            last.setdefault(field, (frame, ax.collections[-1]))
    for field, (frame, mappable) in sorted(last.items()):
        figure.colorbar(mappable, ax=figure.axes[:wide * len(rows)], location="bottom", shrink=0.4, aspect=40,
                        pad=0.02 if len(rows) > 1 else 0.1,  # one row is low: the axes' labels need more of it
                        label=scarp.label_of(field, "m" if field in "xyz" else frame["units"].get(field, "")))
    page.figure(figure, caption, file)


def sections(page, panels, columns, file, caption):
    """Panels (title, frame of the section, coordinates along it, outline frame or None), shaded by plastic strain."""
    limits = common_limits([frame for _, frame, _ in panels], "accumulated_plastic_strain")
    rows = -(-len(panels) // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(4.4 * columns, 2.3 * rows), squeeze=False)
    for ax, (title, frame, initial) in zip(axes.flat, panels):
        discs = scarp.draw_particles_2d(ax, frame, "accumulated_plastic_strain", limits, initial=initial, bar=False,
                                        title=title)
        ax.set_xlabel("along the section [m]")
        ax.set_ylabel("elevation [m]")
    for ax in list(axes.flat)[len(panels):]:
        ax.axis("off")
    figure.colorbar(discs, ax=axes, location="bottom", shrink=0.5, aspect=40, label="accumulated plastic strain [-]")
    page.figure(figure, caption, file)


def cut(frame, along, across, at, between=1.0):
    """A vertical section as a plane frame: coordinates (along, z) of the soil whose settled place lies within half a
    spacing of `at` on `across`; both are functions of places (n, 3). `between`: distance of the particles along the
    section, in spacings."""
    near = np.abs(across(settled_place(frame)) - at) < 0.51 * frame["spacing"]
    found = part(frame, near)
    place = found["position"]
    return dict(found, dimension=2, spacing=between * frame["spacing"], position=np.stack([along(place), place[:, 2], 0 * place[:, 2]], axis=1))


def histories(page, panels, file, caption):
    """Panels (title, [(label, (time, values), colour, style)])."""
    figure, axes = plt.subplots(1, len(panels), figsize=(5.0 * len(panels), 3.2), squeeze=False)
    for ax, (title, lines) in zip(axes.flat, panels):
        for label, (time, values), colour, style in lines:
            ax.plot(time, values, color=colour, linestyle=style, label=label)
        ax.set_title(title)
        ax.set_xlabel("time since the strength was cut [s]")
        ax.set_ylabel("displacement [m]")
        ax.grid(alpha=0.25, linewidth=0.5)
    many = max(len(lines) for _, lines in panels) > 5
    axes.flat[-1].legend(fontsize=8, **(dict(loc="upper left", bbox_to_anchor=(1.01, 1.0)) if many else {}))
    page.figure(figure, caption, file)
