#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What B6 does to an elastic layer on a rough wall, from the equations alone (kernels/EQUATIONS.md: K1 to K3, B2, B5, B6), not
from the engine's code: the shear stress at rest under gravity that is tilted by 20 degrees, and the largest CFL number (2/omega in
h/c) of layers and of blocks that stand free. Plane strain, nu = 0.3, h = 1.2 dx; spacing, density and sound speed are 1.

usage: wall_columns.py"""
import numpy as np

from layer_growth import Layer

INNER, NO_TRUST, FULL_TRUST = 2.0, 1.0, 1.3  # as in engine/boundary/wall_columns.cpp


class LedLayer(Layer):
    """Rows of soil on a rough wall, `width` columns in a period; less than that in number: a block that stands free."""

    def __init__(self, rows, width, columns, slope):
        super().__init__(rows, width, 1.0, 0.3, 0.0, 1.2)
        self.soil = self.soil[self.soil[:, 0] < columns]
        self.prepare()
        count = len(self.soil)
        moment = np.linalg.inv(self.correction)
        trust = np.clip((np.linalg.det(moment) - 0.05) / 0.05, 0, 1)[:, None, None]
        self.correction = np.linalg.inv(trust * moment + (1 - trust) * np.eye(2))
        self.inner, self.outer = self.gradient[:, :count], self.gradient[:, count:]
        average, place = self.mean(self.wall)
        self.takes = average[..., None, None] * np.eye(2)  # T_w,ab = sum_j takes[w, j, b, c] T_j,ac
        self.weight = place - self.wall  # times gravity: of the soil between, along and across the face
        self.across = np.zeros(len(self.wall))
        if slope:
            face = self.wall * [1, 0]
            (first, low), (inner, high) = self.mean(face - [0, 0.5]), self.mean(face + [0, INNER])
            rise = high[:, 1] - low[:, 1]
            x = np.clip((rise - NO_TRUST) / (FULL_TRUST - NO_TRUST), 0, 1)
            share = x**2 * (3 - 2 * x)
            change = (share / np.maximum(rise, 1e-9) * (self.wall - place)[:, 1])[:, None] * (inner - first)
            self.takes[:, :, 1, 1] += change
            self.across = -share * self.weight[:, 1]

    def mean(self, points):
        """Weights of the soil near points, and where it is."""
        offset = self.offset(points, self.soil)
        weight = self.value(np.hypot(offset[..., 0], offset[..., 1]))
        weight = weight / np.maximum(weight.sum(1, keepdims=True), 1e-300)
        return weight, points - np.einsum("wj,wja->wa", weight, offset)

    def strain(self, velocity):
        change = np.einsum("jka,jkb->jab", velocity[None] - velocity[:, None], self.inner)
        change -= np.einsum("ja,jwb->jab", velocity, self.outer)
        of_walls = -np.einsum("ja,jwb->wab", velocity, self.outer)
        return (change + np.einsum("wjcb,wac->jab", self.takes, of_walls)) @ self.correction

    def force(self, stress, gravity=None):
        of_walls = np.einsum("wjbc,jac->wab", self.takes, stress)
        if gravity is not None:
            of_walls += np.einsum("w,ab->wab", self.weight @ gravity, np.eye(2))
            of_walls[:, 1, 1] += self.across * gravity[1]
        force = np.einsum("iab,ib->ia", stress, self.gradient.sum(1))
        return force + np.einsum("jab,ijb->ia", stress, self.inner) + np.einsum("wab,iwb->ia", of_walls, self.outer)

    def corrected_stress(self, velocity):
        strain = self.strain(velocity)
        strain = 0.5 * (strain + strain.transpose(0, 2, 1))
        trace = self.lame * np.trace(strain, axis1=1, axis2=2)
        return (2 * self.shear * strain + trace[:, None, None] * np.eye(2)) @ self.correction

    def stiffness(self):
        size = 2 * len(self.soil)
        columns = [self.force(self.corrected_stress(e.reshape(-1, 2))).ravel() for e in np.eye(size)]
        return np.array(columns).T

    def largest_cfl(self):
        k = -self.stiffness()
        return 2 / self.h / np.sqrt(np.linalg.eigvalsh(0.5 * (k + k.T))[-1])

    def shear_error(self, tilt=np.radians(20)):
        """Of each row, in rho g_t dx."""
        gravity = np.array([np.sin(tilt), -np.cos(tilt)])
        nothing = np.zeros((len(self.soil), 2, 2))
        load = self.force(nothing, gravity) + gravity
        moved = np.linalg.lstsq(self.stiffness(), -load.ravel(), rcond=1e-11)[0].reshape(-1, 2)
        rows = self.corrected_stress(moved)[:, 0, 1].reshape(self.layers, -1).mean(1) / gravity[0]
        return rows - (self.layers - 0.5 - np.arange(self.layers))


def main():
    for slope in (False, True):
        print("with B6" if slope else "without B6")
        print("  shear error of ten rows, from the wall:", np.round(LedLayer(10, 12, 12, slope).shear_error(), 3))
        layers = [f"{n}: {LedLayer(n, 10, 10, slope).largest_cfl():.2f}" for n in (1, 2, 3, 4, 6)]
        print("  largest CFL number of layers of so many rows:", ", ".join(layers))
        blocks = [f"{n} x {w}: {LedLayer(n, 24, w, slope).largest_cfl():.2f}" for n, w in ((1, 2), (2, 2), (3, 2), (3, 3), (4, 4))]
        print("  of blocks, rows x columns:", ", ".join(blocks))


if __name__ == "__main__":
    main()
