# SPDX-License-Identifier: BSD-3-Clause
"""Figures of the particles of a run at the ends of its stages."""

import numpy as np

from scarp_figures import (draw_particles_2d, draw_particles_3d, draw_plan, in_view, label_of, outline, plt, section)
from scarp_frames import frame_info, load_frame, load_walls, read_series


def shown_frames(page, folder, most=6):
    """The first frame, the frames at the end of a stage or of the run, and their numbers; damaged ones are left out
    and told."""
    found = [(n, page.part(path, frame_info, path)) for n, (path, _) in enumerate(read_series(folder))
             if path.exists()]
    infos = [dict(info, number=n) for n, info in found if info is not None]
    if not infos:
        return None, []
    ends = [info for info in infos if info["event"] in ("stage_end", "last", "stopped")]
    if infos[-1]["number"] not in [info["number"] for info in ends]:
        ends.append(infos[-1])
    return infos[0], ends[-most:]


def particle_figures(page, folder, figures):
    first, ends = shown_frames(page, folder)
    if first is None:
        page.text("The run wrote no frames.")
        return
    initial = page.part(first["path"], load_frame, first["path"])
    draw = plane_frame if first["dimension"] == 2 else space_frame
    lines = []
    page.progress.expect(len(ends) * (2 if first["dimension"] == 2 else 4))
    if initial is not None:
        lines = outline(initial) if first["dimension"] == 2 else outline(section(initial), axes=(0, 2))
    for end in ends:
        page.part(end["path"], draw, page, folder, figures, lines, end)


def walls_of(page, folder, number):
    return page.part(folder / "frames" / "walls.hdf", load_walls, folder, number)


def plane_frame(page, folder, figures, lines, end):
    frame, outside = in_view(load_frame(end["path"]))
    walls = walls_of(page, folder, end["number"])
    for field in ("accumulated_plastic_strain", "displacement"):
        if field in frame["fields"]:
            size = np.ptp(np.concatenate([frame["position"]] + [np.pad(l, ((0, 0), (0, 1))) for l in lines]),
                          axis=0)
            height = float(np.clip(7.6 * size[1] / max(size[0], 1e-9) + 0.9, 1.8, 9.0))
            figure, ax = plt.subplots(figsize=(9.0, height))
            draw_particles_2d(ax, frame, field, None, lines, walls)
            page.figure(figure, f"{label_of(field, '').rsplit(' [', 1)[0].capitalize()} at t = {end['time']:.4g} s"
                        f" ({words_of(end)}); dashed: outline at the start; grey: wall particles. {outside}",
                        figures / f"{field}_{end['number']:05}.png")


def space_frame(page, folder, figures, lines, end):
    frame, outside = in_view(load_frame(end["path"]))
    name, when = f"{end['number']:05}.png", f"at t = {end['time']:.4g} s ({words_of(end)})"
    figure = plt.figure(figsize=(9.0, 6.4))
    draw_particles_3d(figure.add_subplot(projection="3d"), frame, title="")
    page.figure(figure, f"Displacement {when}; particles that can be seen from outside. {outside}",
                figures / f"view_{name}")
    figure, ax = plt.subplots(figsize=(9.0, figure_height(frame, 1)))
    draw_plan(ax, frame)
    page.figure(figure, f"Elevation of the highest particle {when}. {outside}", figures / f"plan_{name}")
    cut = section(frame)
    for field in ("accumulated_plastic_strain", "displacement"):
        if field in cut["fields"]:
            figure, ax = plt.subplots(figsize=(9.0, figure_height(frame, 2)))
            draw_particles_2d(ax, cut, field, initial=lines, axes=(0, 2))
            page.figure(figure, f"Middle section across y {when}, {field.replace('_', ' ')}; dashed: outline "
                        f"at the start. {outside}", figures / f"section_{field}_{name}")


def figure_height(frame, axis):
    size = np.ptp(frame["position"], axis=0)
    return float(np.clip(7.6 * size[axis] / max(size[0], 1e-9) + 0.9, 1.8, 9.0))


def words_of(end):
    return {"stage_end": f"end of stage “{end['stage']}”", "stopped": "where the run stopped"}.get(
        end["event"], "last frame")
