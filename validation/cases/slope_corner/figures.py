# SPDX-License-Identifier: BSD-3-Clause
"""Beside the paper's Figs 4 and 8 to 10: slopes that turn a corner."""

import numpy as np
import slope_figures as slopes

SHAPES = ("concave corner", "convex corner")
VIEW = (34, 38)


def _geometry(page, runs, _readings, _share, figures):
    size = runs.reading
    rows = [("Fig. 4", [(runs.initial(shape), "z", shape) for shape in SHAPES], VIEW)]
    slopes.views(page, rows, figures / "fig_4.png",
                 f"Beside Fig. 4 (d) and (e), shaded by elevation: faces of 45 degrees, {size['height']:g} m high, on "
                 f"{size['foundation']:g} m of the same soil, crests {size['crest']:g} m from the back walls. Section P "
                 "is the diagonal x = y; section Q cuts a straight face.")


def _views(page, runs, _readings, share, figures):
    rows = []
    for shape in SHAPES:
        frame = runs.last(shape)
        rows.append((shape, [(frame, "displacement", "displacement"),
                             (frame, "accumulated_plastic_strain", "plastic strain"),
                             (slopes.slide_body(frame, share * runs.reading["height"]), "displacement", "slide body")],
                     VIEW))
    slopes.views(page, rows, figures / "fig_8.png",
                 "Beside Fig. 8: the corners at the end. Left: displacement. Middle: accumulated plastic strain. Right: "
                 f"soil that moved over {100 * share:g} % of the height.")


def _histories(page, runs, readings, _share, figures):
    panels = []
    for title, number, plane, kind in (("(a) P1 and Q1, top: settlement", 1, "crest", "settlement"),
                                       ("(b) P2 and Q2, toe: advance", 2, "toe", "advance")):
        lines = []
        for section, style in (("P", "-"), ("Q", "--")):
            for shape, colour in zip(SHAPES, ("#0072b2", "#d55e00")):
                lines.append((f"{section}, {shape}", runs.history(shape, f"{section}{number}", kind), colour,
                              style))
        plain = [("2D", runs, "#000000")]
        if "2D by Eq. 11" in readings:
            plain.append(("2D by Eq. 11", readings["2D by Eq. 11"], "#999999"))
        for name, of, colour in plain:
            lines.append((f"{name}, section P", of.history("plane 35 degree", plane, kind), colour, "-"))
            lines.append((f"{name}, section Q", of.history("plane 45 degree", plane, kind), colour, "--"))
        panels.append((title, lines))
    slopes.histories(page, panels, figures / "fig_9.png", "Beside Fig. 9: displacements in sections P and Q.")


def _sections(page, runs, _readings, _share, figures):
    size = runs.reading
    panels = []
    for row, (section, plane) in enumerate((("P", "plane 35 degree"), ("Q", "plane 45 degree"))):
        flat = runs.last(plane)
        panels.append((f"({'ad'[row]}) {section}, 2D", flat, runs.initial(plane)))
        for column, shape in enumerate(SHAPES):
            frame = runs.last(shape)
            dx = frame["spacing"]
            if section == "P":
                along, across, at = lambda p: (p[:, 0] + p[:, 1]) / np.sqrt(2), lambda p: p[:, 0] - p[:, 1], 0.0
                between = np.sqrt(2)  # the lattice's diagonal
            else:
                far = runs.initial(shape)["position"][:, 1].max() + 0.5 * dx
                at = (far - 0.5 * size["crest"] if column == 0 else 0.5 * size["crest"]) + 0.5 * dx
                along, across, between = lambda p: p[:, 0], lambda p: p[:, 1], 1.0
            initial = slopes.cut(runs.initial(shape), along, across, at, between)
            letter = "bcef"[2 * row + column]
            panels.append((f"({letter}) {section}, {shape}",
                           slopes.cut(frame, along, across, at, between), initial))
    slopes.sections(page, panels, 3, figures / "fig_10.png",
                    "Beside Fig. 10: accumulated plastic strain on sections P (top) and Q (bottom) at the end; dashed: "
                    "before.")


def draw(page, folder, figures):
    slopes.draw(page, folder, figures, (_views, _geometry, _histories, _sections))
