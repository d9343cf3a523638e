# SPDX-License-Identifier: BSD-3-Clause
"""Amplitude of the standing wave over time."""

import numpy as np
import scarp_report as scarp

plt = scarp.plt


def draw(page, folder, figures):
    figure, axes = plt.subplots(2, 1, figsize=(8.0, 4.6), sharex=True)
    drawn = False
    for ax, kind in zip(axes, ("elastic", "whole")):
        for preset, color in (("modern", "#0072b2"), ("paper", "#d55e00")):
            tables = sorted(folder.glob(f"wave_{preset}_2d_{kind}_*.csv"), key=lambda path: float(path.stem.split("_")[-1]))
            if not tables:
                continue
            time, share, exact = np.loadtxt(tables[0], delimiter=",", skiprows=1, unpack=True)
            ax.plot(1000.0 * time, share, color=color, linewidth=1.2,
                    label=f"{preset}, dx = {tables[0].stem.split('_')[-1]} m")
            ax.plot(1000.0 * time, exact, color="#999999", linewidth=0.8, linestyle="--",
                    label=None if drawn else "closed form")
            drawn = True
        ax.set_ylabel("amplitude [-]")
        ax.set_title("elastic terms only" if kind == "elastic" else "as the preset stands", fontsize=9)
        ax.grid(alpha=0.25, linewidth=0.5)
        ax.legend(fontsize=8, loc="lower left", ncol=3)
    axes[1].set_xlabel("time [ms]")
    if drawn:
        page.figure(figure, "Share of the standing wave in the velocity field, plane strain, finest spacing.",
                    figures / "wave.png")
    else:
        plt.close(figure)
