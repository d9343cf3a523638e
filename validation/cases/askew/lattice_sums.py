#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a uniform pressure does to soil beside a wall that stands askew to the lattice, from the equations alone: the sum of V grad W
over soil, dummies and images, times the spacing. Where it is not zero, a uniform stress s pushes a particle by 2 s times it (E20, K3).
Cubic spline, h = 1.2 dx; spacing 1.

usage: lattice_sums.py"""
import numpy as np

RATIO = 1.2
BANDS = ((0.0, 0.5), (0.5, 1.0), (1.0, 1.7), (1.7, 2.4))  # distances from the wall


def slope(q):
    """dW/dr of the cubic spline in 2D, q = r/h < 2."""
    return 10 / (7 * np.pi * RATIO**3) * np.where(q < 1, -3 * q + 2.25 * q**2, -0.75 * (2 - q) ** 2)


def soil_of(degrees):
    """Lattice turned by an angle, above the wall y = 0."""
    axis = np.arange(-60, 60) + 0.5
    across, up = (part.ravel() for part in np.meshgrid(axis, axis))
    cosine, sine = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    points = np.stack([cosine * across + sine * up, cosine * up - sine * across], 1)
    return points[(points[:, 1] > 0) & (points[:, 1] < 8) & (np.abs(points[:, 0]) < 40)]


def sums(soil, wall):
    """Distance from the wall and size of the sum, of the soil in the middle."""
    everything, found = np.vstack([soil, wall]), []
    for point in soil[(soil[:, 1] < BANDS[-1][1]) & (np.abs(soil[:, 0]) < 25)]:
        offset = everything - point
        distance = np.hypot(*offset.T)
        near = (distance > 1e-9) & (distance < 2 * RATIO)
        gradient = -slope(distance[near] / RATIO)[:, None] * offset[near] / distance[near][:, None]
        found.append((point[1], np.hypot(*gradient.sum(0))))
    return np.array(found)


if __name__ == "__main__":
    along, down = np.meshgrid(np.arange(-45, 45) + 0.5, [-0.5, -1.5, -2.5])
    dummies = np.stack([along.ravel(), down.ravel()], 1)
    print("rms of |sum V grad W| dx, by distance from the wall in dx:", *(f"{low}-{high}" for low, high in BANDS))
    for degrees in (0, 15, 30, 45):
        soil = soil_of(degrees)
        for name, wall in (("mirror images", soil * [1, -1]), ("dummies", dummies)):
            distance, size = sums(soil, wall).T
            inside = [(distance >= low) & (distance < high) for low, high in BANDS]
            shares = [np.sqrt((size[band] ** 2).mean()) if band.any() else 0.0 for band in inside]
            print(f"{degrees:2d} deg, {name}:", *(f"{share:.3f}" for share in shares))
