# SPDX-License-Identifier: BSD-3-Clause
"""Bishop's critical circle as a line."""

import numpy as np

CIRCLE = dict(color="#0072b2", linewidth=1.4, linestyle=(0, (6, 2)))


def arc(bishop):
    """The critical circle below the ground line, (n, 2)."""
    circle = bishop["circle"]
    angles = [np.arctan2(p[0] - circle["x"], circle["y"] - p[1]) for p in (bishop["entry"], bishop["exit"])]
    along = np.linspace(*angles, 200)
    return np.column_stack([circle["x"] + circle["radius"] * np.sin(along),
                            circle["y"] - circle["radius"] * np.cos(along)])
