# SPDX-License-Identifier: BSD-3-Clause
"""Beside the paper's Figs 4 to 7: concave, straight and convex slopes."""

import numpy as np
import slope_figures as slopes

SHAPES = ("concave", "straight", "convex")
VIEW = (26, -38)


def _geometry(page, runs, _readings, _share, figures):
    size = runs.reading
    rows = [("Fig. 4", [(slopes.mirrored(runs.initial(shape)), "z", shape) for shape in SHAPES], VIEW)]
    slopes.views(page, rows, figures / "fig_4.png",
                 f"Beside Fig. 4 (a) to (c), shaded by elevation: face of 45 degrees, {size['height']:g} m high, on "
                 f"{size['foundation']:g} m of the same soil, crest {size['crest']:g} m from the back wall. Section M "
                 "is y = 0; only y > 0 is run.")


def _views(page, runs, _readings, share, figures):
    rows = []
    for shape in SHAPES:
        frame = slopes.mirrored(runs.last(shape))
        z = runs.reading["foundation"] + 0.5 * runs.reading["height"]
        place, dx = frame["position"], frame["spacing"]
        planes = (np.abs(place[:, 1]) < 0.75 * dx) | (np.abs(place[:, 2] - z) < 0.75 * dx)
        rows.append((shape, [(frame, "displacement", "displacement"),
                             (slopes.slide_body(frame, share * runs.reading["height"]), "displacement", "slide body"),
                             (slopes.part(frame, planes), "accumulated_plastic_strain", "sections M and N")], VIEW))
    slopes.views(page, rows, figures / "fig_5.png",
                 "Beside Fig. 5: the slopes at the end, mirrored at section M. Left: displacement. Middle: soil that "
                 f"moved over {100 * share:g} % of the height. Right: sections M (y = 0) and N (mid-height), "
                 "accumulated plastic strain.")


def _histories(page, runs, readings, _share, figures):
    panels = []
    for title, probe, plane, kind in (("(a) M1, top: settlement", "M1", "crest", "settlement"),
                                      ("(b) M2, toe: advance", "M2", "toe", "advance")):
        lines = [(shape, runs.history(shape, probe, kind), *slopes.STYLES[shape]) for shape in SHAPES]
        lines.append(("2D, same cone", runs.history("plane 45 degree", plane, kind), *slopes.STYLES["2D"]))
        if "2D by Eq. 11" in readings:
            lines.append(("2D by Eq. 11", readings["2D by Eq. 11"].history("plane 45 degree", plane, kind),
                          *slopes.STYLES["2D by Eq. 11"]))
        panels.append((title, lines))
    slopes.histories(page, panels, figures / "fig_6.png", "Beside Fig. 6: displacement of M1 and M2.")


def _sections(page, runs, readings, _share, figures):
    panels = [("(a) 2D, same cone", runs.last("plane 45 degree"), runs.initial("plane 45 degree"))]
    initial = panels[0][2]
    for letter, shape in zip("bcd", SHAPES):
        frame = runs.last(shape)
        panels.append((f"({letter}) {shape}",
                       slopes.cut(frame, lambda p: p[:, 0], lambda p: p[:, 1], 0.5 * frame["spacing"]), initial))
    if "2D by Eq. 11" in readings:
        panels.append(("2D by Eq. 11", readings["2D by Eq. 11"].last("plane 45 degree"), initial))
    slopes.sections(page, panels, 2, figures / "fig_7.png",
                    "Beside Fig. 7: accumulated plastic strain on section M at the end; dashed: before.")


def draw(page, folder, figures):
    slopes.draw(page, folder, figures, (_views, _geometry, _histories, _sections))
