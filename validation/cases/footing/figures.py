# SPDX-License-Identifier: BSD-3-Clause
"""Pressure under the footing against its settlement."""

import csv

import scarp_report as scarp

plt = scarp.plt


def draw(page, folder, figures):
    tables = sorted(folder.glob("*_phi_*.csv"))
    if not tables:
        return
    figure, axes = plt.subplots(1, 2, figsize=(9.0, 3.4), sharey=True)
    for path in tables:
        preset, rest = path.stem.split("_phi_")
        friction, spacing = rest.split("_dx_")
        with open(path, newline="", encoding="utf-8") as stream:
            rows = [[float(value) for value in row] for row in list(csv.reader(stream))[1:]]
        ax = axes[0 if preset.startswith("modern") else 1]
        coulomb = ", Mohr-Coulomb" if preset.endswith("mohr_coulomb") else ""
        ax.plot([100 * row[0] for row in rows], [row[1] for row in rows], linewidth=1.0,
                label=f"phi = {friction} deg, dx = {spacing} m{coulomb}")
        ax.set_title(preset.split("_")[0], fontsize=9)
    for ax in axes:
        ax.axhline(1.0, color="#999999", linewidth=0.8, linestyle="--")
        ax.axvspan(0.4, 0.5, color="#0072b2", alpha=0.1)
        ax.set_ylim(0.6, 1.15)
        ax.set_xlabel("settlement [% of B]")
        ax.grid(alpha=0.25, linewidth=0.5)
        if ax.has_data() and ax.get_legend_handles_labels()[0]:
            ax.legend(fontsize=7, loc="lower right")
    axes[0].set_ylabel("pressure over Prandtl's [-]")
    page.figure(figure, "Pressure under the footing. Blue: where it is judged.", figures / "pressure.png")
