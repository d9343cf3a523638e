#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Does a sheared lattice stand under pressure? The growth rate T2 of the fastest wave on lattices that were sheared at
random at constant volume, as soil is that flows, for smoothing functions of the same support 2h, from the equations
alone (kernels/EQUATIONS.md: T2, K1, E26), not from the engine's code.

usage: sheared_lattice.py [--strains 0 0.05 0.15 0.4] [--lattices 16] [--pressure 157] [--youngs 10]
Prints the mean and the largest growth rate [1/s] for every function, h/dx and strain (the norm of its logarithm)."""
import argparse

import numpy as np

NU, DENSITY, SPACING, ALPHA = 0.3, 2000.0, 0.5, 0.1


def yang_liu(q):
    """First and second derivative, without the normalisation: it goes with the moment."""
    return (np.where(q < 1, 3 * q**2 - 6, np.where(q < 2, -3 * (2 - q) ** 2, 0)),
            np.where(q < 1, 6 * q, np.where(q < 2, 6 * (2 - q), 0)))


def cubic_spline(q):
    return (np.where(q < 1, -3 * q + 2.25 * q**2, np.where(q < 2, -0.75 * (2 - q) ** 2, 0)),
            np.where(q < 1, -3 + 4.5 * q, np.where(q < 2, 1.5 * (2 - q), 0)))


def wendland_c2(q):
    b = np.maximum(1 - q / 2, 0)
    return -5 * q * b**3, -5 * b**3 + 7.5 * q * b**2


FUNCTIONS = {"cubic_spline": cubic_spline, "yang_liu": yang_liu, "wendland_c2": wendland_c2}
SETTINGS = {
    2: [("cubic_spline", 1.2), ("cubic_spline", 1.3), ("yang_liu", 1.2), ("yang_liu", 1.3), ("wendland_c2", 1.5)],
    3: [("cubic_spline", 1.2), ("cubic_spline", 1.3), ("yang_liu", 1.2), ("yang_liu", 1.3), ("yang_liu", 1.4),
        ("wendland_c2", 1.5)]}


def growth_rate(function, ratio, deformation, pressure, youngs):
    """Of the fastest wave on the lattice that the deformation makes of a cubic one [1/s]."""
    dimension = len(deformation)
    pressure_wave = youngs * (1 - NU) / ((1 + NU) * (1 - 2 * NU)) / DENSITY  # squares of the speeds of sound
    shear_wave = youngs / (2 * (1 + NU)) / DENSITY
    span = np.arange(-int(5 * ratio), int(5 * ratio) + 1)
    sites = np.stack(np.meshgrid(*[span] * dimension), -1).reshape(-1, dimension)
    place = sites[np.any(sites != 0, 1)] @ deformation.T
    distance = np.linalg.norm(place, axis=1)
    place, distance = place[distance < 2 * ratio], distance[distance < 2 * ratio]
    slope, bend = function(distance / ratio)
    slope, bend = slope / ratio, bend / ratio**2
    way = place / distance[:, None]
    along = way[:, :, None] * way[:, None, :]
    unit = np.eye(dimension)
    correction = np.linalg.inv(-np.einsum("n,nab->ab", slope * distance, along))  # K1
    gradient = -(slope[:, None] * way) @ correction.T
    second = np.einsum("n,nab->nab", bend - slope / distance, along) + (slope / distance)[:, None, None] * unit
    second = second @ correction
    damping = np.einsum("n,nab->nab", -slope * ratio * distance / (distance**2 + 0.01 * ratio**2), along)
    damping *= np.trace(correction) / dimension

    samples = 8  # half a sample short of waves of exactly two rows
    axis = np.pi * (np.arange(-samples, samples) + 0.5) / samples
    waves = np.stack(np.meshgrid(axis[samples:], *[axis] * (dimension - 1)), -1).reshape(-1, dimension)
    phase = waves @ np.linalg.inv(deformation) @ place.T
    turn, slant = 1 - np.cos(phase), np.sin(phase) @ gradient
    change = -2 * pressure / DENSITY * np.einsum("kn,nab->kab", turn, second)
    change -= shear_wave * np.sum(slant**2, 1)[:, None, None] * unit
    change -= (pressure_wave - shear_wave) * slant[:, :, None] * slant[:, None, :]
    values, vectors = np.linalg.eigh(0.5 * (change + change.transpose(0, 2, 1)))
    # E26 acts between particles that approach each other, half of the time.
    drag = 0.25 * ALPHA * np.sqrt(pressure_wave) / SPACING
    drag *= np.einsum("kam,kab,kbm->km", vectors, np.einsum("kn,nab->kab", turn, damping), vectors)
    square = np.maximum(values, 0) / SPACING**2
    return np.max(np.sqrt(square + drag**2) - drag)


def sheared(dimension, strain, random):
    rate = random.normal(size=(dimension, dimension))
    rate -= np.trace(rate) / dimension * np.eye(dimension)
    rate *= strain / np.linalg.norm(rate)
    deformation = term = np.eye(dimension)
    for power in range(1, 16):
        term = term @ rate / power
        deformation = deformation + term
    return deformation


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--strains", type=float, nargs="+", default=[0.0, 0.05, 0.15, 0.4])
    parser.add_argument("--lattices", type=int, default=16)
    parser.add_argument("--pressure", type=float, default=157.0, help="kPa")
    parser.add_argument("--youngs", type=float, default=10.0, help="MPa")
    given = parser.parse_args()
    for dimension, settings in SETTINGS.items():
        for name, ratio in settings:
            words = []
            for strain in given.strains:
                random = np.random.default_rng(7)
                rates = [growth_rate(FUNCTIONS[name], ratio, sheared(dimension, strain, random), 1e3 * given.pressure,
                                     1e6 * given.youngs) for _ in range(given.lattices if strain else 1)]
                words.append(f"{strain:g}: {np.mean(rates):.2f}, {np.max(rates):.2f}")
            print(f"{dimension}D {name} {ratio}   " + "   ".join(words), flush=True)


if __name__ == "__main__":
    main()
