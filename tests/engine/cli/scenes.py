# SPDX-License-Identifier: BSD-3-Clause
"""Small scenes that several tests of the programs run."""

SCENE = """title = "Block"
dimension = 2
gravity = [0.0, -9.81]
spacing = 0.5
[[material]]
name = "rock"
model = "linear_elastic"
density = 2000.0
youngs_modulus = "10 MPa"
poisson_ratio = 0.3
[[body]]
material = "rock"
polygon = [[0, 0], [4, 0], [4, 2], [0, 2]]
[[wall]]
name = "base"
kind = "no_slip"
line = [[-2, 0], [6, 0]]
[[stage]]
name = "short"
duration = 0.04
"""

COLUMN = """title = "Column"
dimension = 2
spacing = "0.125 m"
[[material]]
name = "rock"
model = "linear_elastic"
density = 2000.0
youngs_modulus = "10 MPa"
poisson_ratio = 0.3
[[body]]
material = "rock"
polygon = [[0, 0], [1, 0], [1, 4], [0, 4]]
[[wall]]
name = "box"
kind = "free_slip"
box = {min = [0, 0], max = [1, 6], open = ["+y"]}
[[stage]]
name = "settle"
duration = "1 s"
damping = 30
[[probe]]
name = "top"
at = [0.5, 4]
"""

SLOPE = """title = "Slope"
dimension = 2
spacing = "1 m"
[[material]]
name = "clay"
density = 2000.0
youngs_modulus = "100 MPa"
poisson_ratio = 0.3
cohesion = "10 kPa"
friction_angle = "20 deg"
dilation_angle = "9 deg"
[[body]]
material = "clay"
polygon = [[0, 0], [45, 0], [45, 5], [32, 5], [12, 15], [0, 15]]
[[wall]]
name = "base"
kind = "no_slip"
line = [[0, 0], [45, 0]]
[[wall]]
name = "sides"
kind = "free_slip"
box = {min = [0, 0], max = [45, 20], open = ["-y", "+y"]}
[initial]
stress = "geostatic"
[[stage]]
name = "settle"
until = "rest"
duration = "5 s"
[[stage]]
name = "fail"
duration = "5 s"
[[probe]]
name = "crest"
at = [12, 15]
"""


def block_of(particles):
    """A square block on a base, with about so many particles."""
    side = round(particles**0.5)
    return SCENE.replace("[4, 0], [4, 2], [0, 2]", f"[{side}, 0], [{side}, {side}], [0, {side}]").replace(
        "[[-2, 0], [6, 0]]", f"[[-2, 0], [{side + 2}, 0]]").replace("spacing = 0.5", "spacing = 1").replace("0.04", "10")
