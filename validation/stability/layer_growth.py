#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Do waves in an elastic layer on a no-slip wall grow? Linear stability of `modern` without its time integration,
from the equations alone (kernels/EQUATIONS.md: E20, E23, K1, K2, B1, B2, E26), not from the engine's code.

One column of the layer is displaced, strained and pushed; what that does to all columns, as a wave along the layer,
is a small matrix whose eigenvalues are the growth rates. Artificial viscosity acts on approach only: half of it
counts. No gravity, plane strain.

usage: layer_growth.py [--limits 0.5 0.8 ...] [--poisson 0.15 0.3 0.45] [--alpha 0.1] [--ratio 1.2] [--columns 24]
Prints the largest growth rate over the sound speed, in 1/dx, for layers of 3 to 12 particles."""
import argparse

import numpy as np


class Layer:
    """Spacing, density and sound speed are 1."""

    def __init__(self, layers, columns, limit, poisson, alpha, ratio):
        self.layers, self.columns, self.h, self.alpha = layers, columns, ratio, alpha
        self.shear = (1 - 2 * poisson) / (2 * (1 - poisson))
        self.lame = 1 - 2 * self.shear
        x = np.arange(columns) + 0.5
        rows = int(np.ceil(2 * ratio - 0.5))
        self.soil = np.array([[a, k + 0.5] for k in range(layers) for a in x])
        self.wall = np.array([[a, -k - 0.5] for k in range(rows) for a in x])
        ring = np.array([[i, j] for i in range(-5, 6) for j in range(-5, 6) if i or j], float)
        r = np.hypot(*ring.T)
        self.lattice = -np.sum(r * self.slope(r)) / 2  # K2
        offset = self.offset(self.wall, self.soil)
        weight = self.value(np.hypot(offset[..., 0], offset[..., 1]))
        seen = weight.sum(1) > 0
        self.wall, weight = self.wall[seen], weight[seen]
        self.average = weight / weight.sum(1, keepdims=True)
        behind, before = -self.wall[:, 1], self.average @ self.soil[:, 1]
        self.factor = np.minimum(limit, behind / before)[:, None]

    def value(self, r):
        q = r / self.h
        w = np.where(q < 1, 1 - 1.5 * q**2 + 0.75 * q**3, np.where(q < 2, 0.25 * (2 - q) ** 3, 0))
        return 10 / (7 * np.pi * self.h**2) * w

    def slope(self, r):
        q = r / self.h
        s = np.where(q < 1, -3 * q + 2.25 * q**2, np.where(q < 2, -0.75 * (2 - q) ** 2, 0))
        return 10 / (7 * np.pi * self.h**3) * s

    def offset(self, a, b):
        d = a[:, None] - b[None]
        d[..., 0] -= self.columns * np.round(d[..., 0] / self.columns)
        return d

    def prepare(self):
        every = np.vstack([self.soil, self.wall])
        self.apart = self.offset(self.soil, every)
        self.distance = np.hypot(self.apart[..., 0], self.apart[..., 1])
        own = self.distance == 0
        self.distance[own] = 1
        gradient = np.where(own, 0, self.slope(self.distance) / self.distance / self.lattice)
        self.gradient = gradient[..., None] * self.apart
        moment = -np.einsum("ija,ijb->iab", self.apart, self.gradient)
        self.correction = np.linalg.inv(moment)  # K1

    def rates(self, velocity, stress):
        """Acceleration and stress rate (xx, yy, xy). Without stress at rest, positions and density do not enter."""
        wall_velocity = -self.factor * (self.average @ velocity)  # B1
        wall_stress = self.average @ stress  # B2
        relative = velocity[:, None] - np.vstack([velocity, wall_velocity])[None]
        strain = -np.einsum("ija,ijb->iab", relative, self.gradient) @ self.correction

        def tensor(s):
            return np.stack([s[..., 0], s[..., 2], s[..., 2], s[..., 1]], -1).reshape(*s.shape[:-1], 2, 2)

        everywhere = tensor(np.vstack([stress, wall_stress]))
        force = np.einsum("iab,ib->ia", tensor(stress), self.gradient.sum(1))
        force += np.einsum("jab,ijb->ia", everywhere, self.gradient)
        approach = 0.5 * self.h * (relative * self.apart).sum(-1) / (self.distance**2 + 0.01 * self.h**2)
        force += np.einsum("ij,ija->ia", self.alpha * approach, self.gradient)
        xx, yy = strain[:, 0, 0], strain[:, 1, 1]
        xy = 0.5 * (strain[:, 0, 1] + strain[:, 1, 0])
        trace = self.lame * (xx + yy)
        return force, np.stack([trace + 2 * self.shear * xx, trace + 2 * self.shear * yy, 2 * self.shear * xy], 1)

    def growth(self):
        """The largest real part of an eigenvalue over all waves along the layer."""
        self.prepare()
        size, count = 5 * self.layers, len(self.soil)
        column = np.empty((self.columns, size, size))
        for k in range(size):
            velocity, stress = np.zeros((count, 2)), np.zeros((count, 3))
            field, layer = (velocity, k // 2) if k < 2 * self.layers else (stress, (k - 2 * self.layers) // 3)
            field[layer * self.columns, k % 2 if field is velocity else (k - 2 * self.layers) % 3] = 1
            force, stressing = self.rates(velocity, stress)
            by_column = [f.reshape(self.layers, self.columns, -1).transpose(1, 0, 2) for f in (force, stressing)]
            column[:, :, k] = np.hstack([f.reshape(self.columns, -1) for f in by_column])
        largest = 0.0
        for wave in range(self.columns // 2 + 1):
            phase = np.exp(-2j * np.pi * wave * np.arange(self.columns) / self.columns)
            largest = max(largest, np.linalg.eigvals(np.einsum("c,cij->ij", phase, column)).real.max())
        return largest


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--limits", type=float, nargs="+", default=[0.5, 0.65, 0.8, 0.9, 1.0])
    parser.add_argument("--poisson", type=float, nargs="+", default=[0.15, 0.3, 0.45])
    parser.add_argument("--alpha", type=float, default=0.1)
    parser.add_argument("--ratio", type=float, default=1.2)
    parser.add_argument("--columns", type=int, default=24)
    arguments = parser.parse_args()
    thick = (3, 4, 5, 6, 8, 12)
    print("nu    limit  " + "".join(f"{n:>2} layers   " for n in thick))
    for poisson in arguments.poisson:
        for limit in arguments.limits:
            rates = [Layer(n, arguments.columns, limit, poisson, arguments.alpha, arguments.ratio).growth()
                     for n in thick]
            print(f"{poisson:<5g} {limit:<6g} " + "  ".join(f"{r:9.1e}" if r > 1e-12 else "        0" for r in rates))


if __name__ == "__main__":
    main()
