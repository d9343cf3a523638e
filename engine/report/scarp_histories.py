# SPDX-License-Identifier: BSD-3-Clause
"""Figures of the tables of a run: probes, forces on walls, energies, steps."""

import numpy as np

from scarp_figures import draw_history, plt
from scarp_frames import read_history


def history_figures(page, folder, figures):
    for name, draw in (("probes", probe_figure), ("walls", wall_figure), ("energy", energy_figure),
                       ("history", step_figure)):
        path = folder / f"{name}.csv"
        page.progress.expect(path.exists())
        page.part(path, draw_table, page, path, draw, figures / f"{name}.png")


def draw_table(page, path, draw, picture):
    table = read_history(path)
    if table:
        draw(page, *table, picture)


def probe_figure(page, columns, units, picture):
    names = list(dict.fromkeys(c.rsplit(".", 1)[0] for c in columns if "." in c))
    figure, axes = plt.subplots(2, 1, figsize=(9.0, 4.6), sharex=True)
    for ax, quantity in zip(axes, ("displacement", "velocity")):
        sizes = {"time": columns["time"], "stage": columns["stage"]}
        for name in names:
            parts = [columns[c] for c in columns if c.startswith(f"{name}.{quantity}_")]
            sizes["probe", name] = np.sqrt(sum(part**2 for part in parts))
        unit = "m" if quantity == "displacement" else "m/s"
        draw_history(ax, (sizes, {}), [("probe", name) for name in names], [n.replace("_", " ") for n in names],
                     f"|{quantity}| [{unit}]")
    axes[0].set_xlabel("")
    page.figure(figure, "Probes; dotted: a stage begins.", picture)


def wall_figure(page, columns, units, picture):
    names = [c for c in columns if ".force_" in c]
    figure, ax = plt.subplots(figsize=(9.0, 2.6))
    draw_history(ax, (columns, units), names, [n.replace(".force_", ", ") for n in names],
                 f"force on the wall [{units[names[0]]}]")
    page.figure(figure, "Forces of the soil on the walls.", picture)


def energy_figure(page, columns, units, picture):
    names = [c for c in columns if c not in ("time", "stage") and np.any(columns[c] != 0)]
    if names:
        figure, ax = plt.subplots(figsize=(9.0, 3.2))
        draw_history(ax, (columns, units), names, ylabel=f"energy [{units[names[0]]}]")
        page.figure(figure, "Energy balance; potential and elastic energy count from the start of each stage; parts "
                    "that stay zero are not drawn.", picture)


def step_figure(page, columns, units, picture):
    sleeps = "asleep" in columns
    figure, axes = plt.subplots(3 if sleeps else 2, 1, figsize=(9.0, 5.2 if sleeps else 3.8), sharex=True)
    positive = {n: np.where(v > 0, v, np.nan) if isinstance(v, np.ndarray) and n != "time" else v
                for n, v in columns.items()}
    draw_history(axes[0], (positive, units), ["max_velocity"], log=True)
    draw_history(axes[1], (positive, units), ["time_step"])
    if sleeps:
        draw_history(axes[2], (columns, units), ["asleep"])
        axes[1].set_xlabel("")
    axes[0].set_xlabel("")
    page.figure(figure, "Fastest particle, time step, share of the soil that sleeps." if sleeps else "Fastest particle and time step.", picture)
