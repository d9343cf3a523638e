# SPDX-License-Identifier: BSD-3-Clause
"""Beside the paper's Figs 2 and 3: shape, contours, profiles and layers of the deposit."""

import json

import numpy as np
import scarp_report as scarp
import slope_figures as slopes

plt = scarp.plt
LAYERS, GATE, BASE, FILL = 6, 0.3, 0.036, 0.144
GREYS = ["#31688e", "#fde725"]  # neighbouring layers in turn


def _runs(folder):
    """Folders of the runs that have ended, by cone and spacing: [(name, folder, last frame)]."""
    found = []
    for path in sorted(folder.glob("*_mm")):
        series = scarp.read_series(path)
        if series and (path / "outcome.json").exists():
            outcome = json.loads((path / "outcome.json").read_text(encoding="utf-8"))
            found.append((outcome["name"], path, scarp.load_frame(series[-1][0])))
    return sorted(found, key=lambda run: -run[2]["spacing"])


def _shape(page, frame, figures):
    figure = plt.figure(figsize=(9.0, 5.2))
    scarp.draw_particles_3d(figure.add_subplot(projection="3d"), slopes.mirrored(frame), "displacement", view=(30, -40),
                            title="(a)")
    page.figure(figure, "Beside Fig. 2 (a): the deposit shaded by displacement, mirrored at the middle plane.",
                figures / "fig_2a.png")
    figure, ax = plt.subplots(figsize=(9.0, 5.0))
    both = slopes.mirrored(frame)
    mesh = scarp.draw_plan(ax, both)
    top = np.ma.filled(mesh.get_array().astype(float), np.nan)
    edges = mesh.get_coordinates()
    x, y = (0.5 * (edges[0, 1:, 0] + edges[0, :-1, 0]), 0.5 * (edges[1:, 0, 1] + edges[:-1, 0, 1]))
    lines = ax.contour(x, y, top.reshape(len(y), len(x)), levels=np.arange(0.05, 0.18, 0.02), colors="black",
                       linewidths=0.7)
    ax.clabel(lines, fmt="%.2f", fontsize=7)
    ax.axvline(GATE, color="#d62728", linewidth=0.8, linestyle="--")
    ax.set_title("(b)")
    page.figure(figure, "Beside Fig. 2 (b): elevation from above with contours every 20 mm; red dashes: the gate. The "
                "observed contours are not available as numbers.", figures / "fig_2b.png")


def _profiles(page, runs, figures):
    figure, axes = plt.subplots(1, 3, figsize=(12.0, 3.6), width_ratios=(1.0, 1.0, 0.5))
    panels = ((axes[0], (("x_212_mm", "x = 212 mm", "-"),), "y [m]", "(c)"),
              (axes[1], (("middle_plane", "middle plane", "-"), ("y_100_mm", "y = 100 mm", "--")), "x [m]", "(d)"))
    for ax, files, label, title in panels:
        for colour, (name, path, _) in zip(scarp.CYCLE, runs):
            for file, words, style in files:
                table = scarp.read_table(path / f"{file}.csv")
                if table:
                    x, z = list(table[0].values())[:2]
                    ax.plot(x, z, style, color=colour, label=f"{name}, {words}")
        ax.set_xlabel(label)
        ax.set_ylabel("elevation [m]")
        ax.set_title(title)
        ax.grid(alpha=0.25, linewidth=0.5)
    axes[2].axis("off")
    axes[2].legend(*axes[1].get_legend_handles_labels(), fontsize=7, loc="center left")
    for factor, words, style in ((1.2, "Lube 2005", ":"), (1.8, "Lajeunesse 2005", "-.")):
        axes[1].axvline(GATE + factor * FILL, color="#999999", linestyle=style, linewidth=0.9)
        axes[1].text(GATE + factor * FILL, 0.13 if factor < 1.5 else 0.11, f" {words}", fontsize=7, color="#555555")
    page.figure(figure, "Beside Fig. 2 (c) and (d): profiles at x = 212 mm from the back wall (same colours), in the middle "
                "plane and at y = 100 mm; faces lie at whole spacings, so the levels differ with the spacing; grey: fronts of planar columns in experiments, which cannot spread to the sides.",
                figures / "fig_2cd.png")


def _layers(page, frame, path, figures):
    dx = frame["spacing"]
    gate, base, top = (dx * np.floor(face / dx + 0.5) for face in (GATE, BASE, BASE + FILL))  # as the case moves them
    middle = slopes.part(frame, frame["position"][:, 1] < dx)
    start = slopes.settled_place(middle)
    fill = (start[:, 0] < gate) & (start[:, 2] > base)
    moved = np.linalg.norm(middle["fields"]["displacement"], axis=1)
    figure, ax = plt.subplots(figsize=(9.0, 3.8))
    ax.set_aspect("equal")
    ax.set_xlim(0, 0.55)
    ax.set_ylim(0, 0.2)
    points_per_metre = 72 * 8.0 / 0.55
    size = (dx * points_per_metre) ** 2 * (0.25 + 0.75 * moved / max(moved.max(), 1e-12))
    layer = np.clip(((start[:, 2] - base) / ((top - base) / LAYERS)).astype(int), 0, LAYERS - 1)
    colours = np.array(GREYS)[layer % 2]
    colours[~fill] = "#bbbbbb"
    ax.scatter(*middle["position"][:, [0, 2]].T, s=size, c=colours, linewidths=0)
    table = scarp.read_table(path / "layers.csv")
    if table:
        columns = table[0]
        for number in np.unique(columns["boundary"]):
            one = columns["boundary"] == number
            ax.plot(columns["x"][one], columns["z"][one], "--", color="black", linewidth=0.8)
    values = json.loads((path / "outcome.json").read_text(encoding="utf-8"))["values"]
    points = np.array([[values.get(f"boundary {b}: inflection {c} [m]") or np.nan for c in "xz"]
                       for b in range(1, LAYERS)], dtype=float)
    ax.plot(*points.T, "o-", color="#d62728", markersize=4, linewidth=1.2)
    ax.set_xlabel("x [m]")
    ax.set_ylabel("z [m]")
    page.figure(figure, "Beside Fig. 3: middle section, layers of 24 mm in turn, dots larger the farther they moved; dashed: "
                "boundaries of the layers; red: their inflection points.", figures / "fig_3.png")


def draw(page, folder, figures):
    runs = _runs(folder)
    outer = [run for run in runs if run[0].startswith("outer")]
    if not outer:
        return
    name, path, frame = outer[-1]
    page.text(f"Shape, contours and layers of the run “{name}”.")
    _shape(page, frame, figures)
    _profiles(page, runs, figures)
    _layers(page, frame, path, figures)
