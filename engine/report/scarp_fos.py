# SPDX-License-Identifier: BSD-3-Clause
"""The page of `scarp fos`: the factor, what was asked of the slope, the slip surface, every trial."""

import pathlib

import numpy as np

from scarp_figures import draw_particles_2d, label_of, outline, plt, section
from scarp_frames import frame_info, load_frame, read_json, read_series
from scarp_page import Page

STANDS, FAILS = dict(color="#0072b2", marker="o"), dict(color="#d55e00", marker="^")


def displacement_figure(study):
    """Largest displacement of each trial against its factor; failed ones end where the limit is crossed."""
    criterion, figure = study["criterion"], plt.figure(figsize=(7.2, 3.6))
    ax = figure.add_subplot()
    for verdict, style, words in ((False, STANDS, "stands"), (True, FAILS, "fails: ended at the limit")):
        trials = [t for t in study["trials"] if t["fails"] == verdict]
        ax.semilogy([t["reduction"] for t in trials], [max(t["displacement"], 1e-7) for t in trials],
                    linestyle="none", label=words, **style)
    for trial in study["trials"]:
        if trial["fails"]:
            ax.annotate(f"{trial['time']:.3g} s", (trial["reduction"], trial["displacement"]), xytext=(0, 6),
                        textcoords="offset points", rotation=60, fontsize=7)
    ax.axhline(criterion["limit"] + criterion["elastic"], color="#999999", linewidth=0.8, linestyle="--",
               label="failure: 1 % of the height")
    if study["factor_of_safety"] is not None:
        ax.axvspan(study["stands"], study["fails"], color="#009e73", alpha=0.3, linewidth=0,
                   label=f"factor of safety {study['factor_of_safety']:.3f}")
    ax.set_xlabel("strength reduction factor [-]")
    ax.set_ylabel("largest displacement [m]")
    ax.margins(y=0.15)
    ax.grid(alpha=0.25, linewidth=0.5)
    ax.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), fontsize=8)
    return figure


def slip_figures(page, folder, figures):
    """The last frame of the failing run: accumulated plastic strain and displacement."""
    infos = [frame_info(path) for path, _ in read_series(folder) if path.exists()]
    if not infos:
        page.text("There are no frames of the failure.")
        return
    first, frame = load_frame(infos[0]["path"]), load_frame(infos[-1]["path"])
    axes, where = (0, 1), ""
    if frame["dimension"] == 3:
        axes, where = (0, 2), " in the middle section across y"
        first, frame = section(first), section(frame)
    size = np.ptp(frame["position"], axis=0)
    height = float(np.clip(7.6 * size[axes[1]] / max(size[0], 1e-9) + 0.9, 1.8, 9.0))
    for field in ("accumulated_plastic_strain", "displacement"):
        if field not in frame["fields"]:
            continue
        figure, ax = plt.subplots(figsize=(9.0, height))
        draw_particles_2d(ax, frame, field, initial=outline(first, axes=axes), axes=axes)
        page.figure(figure, f"{label_of(field, '').rsplit(' [', 1)[0].capitalize()}{where}; dashed: outline before "
                    "the last step of the cut.", figures / f"failure_{field}.png")


def fos_page(folder, out, moving_picture):
    """Writes the page over what `scarp fos` left in a folder; returns its path. `moving_picture(page, run)` adds that of the
    failure."""
    folder = pathlib.Path(folder)
    study = read_json(folder / "fos.json")
    page = Page(study["title"] or folder.name,
                f"scarp fos at a spacing of {study['spacing']:g} m, preset {study['preset']}")
    page.progress.expect(3)  # plastic strain, displacement, trials
    factor = study["factor_of_safety"]
    if factor is None:
        page.text("No factor of safety was found.", problem=True)
    else:
        page.text(f"Factor of safety {factor:.3f}: the slope stands at a strength reduction factor of "
                  f"{study['stands']:.4g} and fails at {study['fails']:.4g}.", problem=False)
    if study["failure"]:
        page.text(f"The search did not reach its end: {study['failure']}", problem=True)
    page.text(study["criterion"]["sentence"])
    page.text(study["resolution"])
    for note in study["notes"]:
        page.text(note, problem=True)
    page.section("How it fails")
    if study["fails"] is not None and (folder / "failure" / "frames").exists():
        page.text(f"Strength cut by {study['fails']:.4g}, the least factor that failed, carried on beyond the limit.")
        page.part(folder / "failure" / "frames", moving_picture, page, folder / "failure")
        page.part(folder / "failure" / "frames", slip_figures, page, folder / "failure", folder / "figures")
    else:
        page.text("No failure was shown.")
    page.section("Displacement against strength")
    if study["trials"]:
        page.figure(displacement_figure(study), "Displacement of the judged point in each trial. Trials that fail end "
                    "where they cross the limit, after the time written beside them.",
                    folder / "figures" / "displacement_srf.png")
    trials = sorted(study["trials"], key=lambda t: t["reduction"])
    page.table(["factor", "", "largest displacement [m]", "speed at the end [m/s]", "time [s]", "ended because",
                "steps", "run time [s]"],
               [[f"{t['reduction']:.4f}", "fails" if t["fails"] else "stands", t["displacement"], t["speed"], t["time"],
                 t["end"], t["steps"], t["wall_s"]] for t in trials])
    page.section("Cost")
    settle = study["settle"]
    page.table(["", "value", "unit"],
               [["particles", study["particles"], ""], ["spacings in the height",
                study["criterion"]["spacings_in_height"], ""],
                ["settling, simulated", settle["time"], "s"], ["settling", settle["wall_s"], "s"],
                ["elastic response", study["elastic"]["wall_s"], "s"],
                ["settling and all trials", study["wall_s"], "s"]])
    page.text(f"Computed with {study['isa']} on {study['threads']} threads. The folder failure/ holds the frames of "
              "the failing run for ParaView.")
    path = pathlib.Path(out or folder / "report.html")
    page.save(path)
    return path
