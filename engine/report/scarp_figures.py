# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of particles and histories; every function draws on axes it is given."""

import contourpy
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.collections import EllipseCollection, LineCollection  # noqa: E402

from scarp_frames import in_view, scalar  # noqa: E402

plt.rcParams.update({
    "font.size": 9, "axes.titlesize": 9, "axes.titlelocation": "left", "axes.linewidth": 0.6,
    "axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False,
    "lines.linewidth": 1.2, "figure.dpi": 100, "savefig.dpi": 160, "figure.constrained_layout.use": True,
})

COLOUR_MAPS = {"accumulated_plastic_strain": "magma_r", "displacement": "viridis", "velocity": "viridis"}
INITIAL = dict(colors="#d62728", linewidths=0.9, linestyles=(0, (5, 3)))
# Okabe and Ito's colours, told apart by the colour-blind and in grey.
CYCLE = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000", "#999999"]
plt.rcParams["axes.prop_cycle"] = matplotlib.cycler(color=CYCLE)


def plain_label(text):
    """Text of a scene for a figure: matplotlib takes what is between dollars for a formula, and leaves labels that
    begin with an underscore out of legends."""
    text = text.replace("$", r"\$")
    return f" {text}" if text.startswith("_") else text


def label_of(field, unit):
    name = field.replace("_", " ")
    return f"{name} [{unit if unit not in ('', '1') else '-'}]"


def colour_limits(values):
    """From 0 or the smallest to the largest value, without the 0.2 % most extreme."""
    values = values[np.isfinite(values)]
    if values.size == 0:
        return 0.0, 1.0
    low, high = np.percentile(values, [0.2, 99.8])
    low = 0.0 if low >= 0.0 and low < 0.5 * high else low
    return (low, high) if high > low else (low, low + max(abs(low) * 1e-3, 1e-12))


def _simplified(line, tolerance):
    """Douglas and Peucker: the fewest points within `tolerance` of the line."""
    keep = np.zeros(len(line), dtype=bool)
    keep[[0, -1]] = True
    pending = [(0, len(line) - 1)]
    while pending:
        first, last = pending.pop()
        if last - first < 2:
            continue
        chord, offset = line[last] - line[first], line[first + 1:last] - line[first]
        length = np.hypot(*chord)
        away = (np.abs(chord[0] * offset[:, 1] - chord[1] * offset[:, 0]) / length if length > 0
                else np.hypot(*offset.T))
        if away.max() > tolerance:
            middle = first + 1 + int(away.argmax())
            keep[middle] = True
            pending += [(first, middle), (middle, last)]
    return line[keep]


def _tell(ax, sentence):
    """A line below the title of a picture that does not show all."""
    if sentence:
        (ax.text2D if ax.name == "3d" else ax.text)(1.0, 1.0, sentence, transform=ax.transAxes, ha="right",
                                                    va="bottom", fontsize=7, color="#d62728")


MOST_CELLS = 1 << 27  # of a grid that a picture is made from


def outline(frame, spacing=None, axes=(0, 1)):
    """Closed lines around the soil, [(n, 2)]: where the share of the plane that particles cover falls to
    a half. Details under a spacing and holes under four particles are left out."""
    spacing = spacing or frame["spacing"]
    frame, _ = in_view(frame)
    points = frame["position"][:, list(axes)]
    if len(points) == 0 or np.prod(np.ptp(points, axis=0) / spacing + 8) > MOST_CELLS:
        return []
    origin = points[np.lexsort(points.T)[0]] % spacing - 3 * spacing  # nodes on the initial lattice
    start = np.floor((points.min(axis=0) - origin) / spacing) - 2
    origin = origin + start * spacing
    place = (points - origin) / spacing
    cell = np.floor(place + 1e-6).astype(int)
    part = np.clip(place - cell, 0.0, 1.0)
    cover = np.zeros(cell.max(axis=0) + 4)
    for i in (0, 1):
        for j in (0, 1):
            share = np.where(i, part[:, 0], 1 - part[:, 0]) * np.where(j, part[:, 1], 1 - part[:, 1])
            np.add.at(cover, (cell[:, 0] + i, cell[:, 1] + j), share)
    x, y = (origin[a] + spacing * np.arange(cover.shape[a]) for a in (0, 1))
    cover, tolerance = np.minimum(cover, 1.0), 0.25
    if np.mean(np.abs(cover - np.round(cover)) < 1e-3) > 0.98:
        # An undisturbed lattice: follow the cells' edges, so that corners are exact; the steps of a slope
        # are straightened.
        cover, tolerance = np.repeat(np.repeat(np.round(cover), 2, axis=0), 2, axis=1), 1.0
        x, y = ((c[:, None] + [-0.4999 * spacing, 0.4999 * spacing]).ravel() for c in (x, y))
    lines = contourpy.contour_generator(x, y, cover.T).lines(0.5)
    area = [0.5 * abs(np.sum(l[:-1, 0] * l[1:, 1] - l[1:, 0] * l[:-1, 1])) for l in lines]
    return [_simplified(line, tolerance * spacing) for line, a in zip(lines, area) if a > 4 * spacing**2]


def colour_bar(ax, mappable, label):
    """A bar outside the axes, as high as they are."""
    bar = ax.figure.colorbar(mappable, cax=ax.inset_axes([1.012, 0.0, 0.014, 1.0]))
    bar.set_label(label)
    bar.outline.set_linewidth(0.6)
    return bar


def _discs(ax, points, spacing, **style):
    discs = EllipseCollection(np.full(len(points), spacing), np.full(len(points), spacing),
                              np.zeros(len(points)), units="xy", offsets=points,
                              offset_transform=ax.transData, linewidths=0, rasterized=True, **style)
    ax.add_collection(discs)
    return discs


def draw_particles_2d(ax, frame, field="accumulated_plastic_strain", limits=None, initial=None,
                      walls=None, colour_map=None, bar=True, axes=(0, 1), title=None):
    """Particles as discs of one spacing, shaded by a field (see scarp_frames.scalar). `initial`: a frame
    or outline lines drawn dashed; `walls`: positions of dummies; `axes`: the coordinates shown. Returns
    the collection."""
    spacing = frame["spacing"]
    frame, outside = in_view(frame)
    points = frame["position"][:, list(axes)]
    values = scalar(frame, field)
    low, high = limits or colour_limits(values)
    if walls is not None and len(walls):
        _discs(ax, walls[:, list(axes)], 0.6 * spacing, facecolors="#b8b8b8")
    base = COLOUR_MAPS.get(field, "viridis")
    discs = _discs(ax, points, 1.35 * spacing, cmap=colour_map or base)
    discs.set_array(values)
    discs.set_clim(low, high)
    shown = [points]
    if initial is not None:
        lines = outline(initial, axes=axes) if isinstance(initial, dict) else initial
        ax.add_collection(LineCollection(lines, **INITIAL))
        shown += lines
    shown = np.concatenate(shown)
    margin = 3 * spacing
    ax.set_xlim(shown[:, 0].min() - margin, shown[:, 0].max() + margin)
    ax.set_ylim(shown[:, 1].min() - margin, shown[:, 1].max() + margin)
    ax.set_aspect("equal")
    ax.set_xlabel(f"{'xyz'[axes[0]]} [m]")
    ax.set_ylabel(f"{'xyz'[axes[1]]} [m]")
    ax.set_title(frame_title(frame) if title is None else title)
    _tell(ax, outside)
    if bar:
        colour_bar(ax, discs, label_of(field, frame["units"].get(field, "")))
    return discs


def frame_title(frame):
    stage = plain_label(frame["stage"]) if frame.get("stage") else ""
    return f"t = {frame['time']:.4g} s" + (f", stage “{stage}”" if stage else "")


def surface_particles(frame, layers=2):
    """Mask of the particles in the outermost cells of about one spacing, `layers` deep: what can be seen
    from outside, and what shows through its gaps."""
    place = frame["position"] / (1.05 * frame["spacing"])
    if np.prod(np.ptp(place, axis=0) + 3) > MOST_CELLS:
        return np.ones(len(place), dtype=bool)
    cell = np.floor(place).astype(int)
    cell -= cell.min(axis=0) - 1
    full = np.zeros(cell.max(axis=0) + 2, dtype=bool)
    full[tuple(cell.T)] = True
    inner = full
    for _ in range(layers):
        inner = np.logical_and.reduce([inner] + [np.roll(inner, side, axis) for axis in range(3)
                                                 for side in (-1, 1)])
    return ~inner[tuple(cell.T)]


def draw_particles_3d(ax, frame, field="displacement", limits=None, colour_map=None, bar=True,
                      view=(24, -58), title=None):
    """The visible particles in a 3D view with equal axes, shaded by a field; `view` is elevation and
    azimuth in degrees. Returns the scatter."""
    frame, outside = in_view(frame)
    seen = surface_particles(frame)
    points, values = frame["position"][seen], scalar(frame, field)
    low, high = limits or colour_limits(values)
    lowest, highest = frame["position"].min(axis=0), frame["position"].max(axis=0)
    extent = np.maximum(highest - lowest, frame["spacing"])
    box = ax.get_window_extent()
    points_per_metre = 0.72 * min(box.width, box.height) * 72 / ax.figure.dpi / np.linalg.norm(extent)
    size = max((2.0 * frame["spacing"] * points_per_metre) ** 2, 0.3)
    scatter = ax.scatter(*points.T, c=values[seen], s=size, marker="o", linewidths=0, vmin=low, vmax=high,
                         cmap=colour_map or COLOUR_MAPS.get(field, "viridis"), depthshade=False,
                         rasterized=True, clip_on=False)
    for axis, name, a in ((ax.xaxis, "x", 0), (ax.yaxis, "y", 1), (ax.zaxis, "z", 2)):
        axis.set_label_text(f"{name} [m]")
        axis.set_major_locator(matplotlib.ticker.MaxNLocator(
            max(2, min(6, round(6 * extent[a] / extent.max()))), steps=[1, 2, 5, 10]))
    ax.set_xlim(lowest[0], highest[0])
    ax.set_ylim(lowest[1], highest[1])
    ax.set_zlim(lowest[2], highest[2])
    ax.set_box_aspect(extent)
    ax.view_init(*view)
    ax.set_title(frame_title(frame) if title is None else title)
    _tell(ax, outside)
    if bar:
        ax.figure.colorbar(scatter, ax=ax, shrink=0.6, pad=0.14, fraction=0.04,
                           label=label_of(field, frame["units"].get(field, "")))
    return scatter


def draw_plan(ax, frame, limits=None, colour_map="cividis", bar=True):
    """3D from above: each square of one spacing has the elevation of its highest particle."""
    frame, outside = in_view(frame)
    spacing, points = frame["spacing"], frame["position"]
    spacing = max(spacing, float(np.sqrt(np.prod(np.ptp(points[:, :2], axis=0)) / MOST_CELLS)))
    cell = np.floor(points[:, :2] / spacing + 1e-6).astype(int)
    low = cell.min(axis=0) - 1
    top = np.full(cell.max(axis=0) - low + 2, -np.inf)
    for shift in np.ndindex(3, 3):  # a particle covers the squares whose centre it is near to
        square = cell + np.array(shift) - 1
        near = np.abs((square + 0.5) * spacing - points[:, :2]).max(axis=1) < 0.75 * spacing
        np.maximum.at(top, tuple((square[near] - low).T), points[near, 2])
    x, y = ((low[a] + np.arange(top.shape[a] + 1)) * spacing for a in (0, 1))
    mesh = ax.pcolormesh(x, y, np.ma.masked_invalid(top).T, cmap=colour_map, rasterized=True,
                         vmin=limits and limits[0], vmax=limits and limits[1])
    ax.set_aspect("equal")
    ax.set_xlabel("x [m]")
    ax.set_ylabel("y [m]")
    ax.set_title(f"plan, {frame_title(frame)}")
    _tell(ax, outside)
    if bar:
        colour_bar(ax, mesh, "elevation [m]")
    return mesh


def section(frame, axis=1, at=None):
    """The frame's particles within 0.75 spacings of a plane across `axis`; the middle if `at` is None."""
    along = frame["position"][:, axis]
    inner = in_view(frame)[0]["position"][:, axis]
    at = 0.5 * (inner.min() + inner.max()) if at is None else at
    near = np.abs(along - at) < 0.75 * frame["spacing"]
    cut = dict(frame, position=frame["position"][near])
    cut["fields"] = {name: values[near] for name, values in frame["fields"].items()}
    return cut


def stage_marks(ax, columns):
    """Thin lines where a stage begins."""
    stages, times = columns.get("stage", []), columns["time"]
    for before, now, time in zip(stages, stages[1:], times[1:]):
        if before != now:
            ax.axvline(time, color="#999999", linewidth=0.6, linestyle=":")


def draw_history(ax, table, names, labels=None, ylabel=None, log=False):
    """Columns of a table (scarp_frames.read_table) over time."""
    columns, units = table
    for number, name in enumerate(names):
        ax.plot(columns["time"], columns[name],
                label=plain_label(labels[number] if labels else name.replace("_", " ")),
                linestyle=["-", "--", "-."][number // len(CYCLE) % 3])
    if log:
        ax.set_yscale("log")
    stage_marks(ax, columns)
    ax.set_xlabel("time [s]")
    ax.set_ylabel(ylabel or label_of(names[0], units[names[0]]))
    ax.grid(alpha=0.25, linewidth=0.5)
    if len(names) > 1:
        ax.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), fontsize=8)
