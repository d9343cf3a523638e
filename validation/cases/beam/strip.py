#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Bending of an endless elastic strip from the particle equations alone (kernels/EQUATIONS.md: K1, K3), not from the engine's code:
its frequency over the exact one, and the strain that each row reads of a pure bending. Plane strain, nu = 0.3; spacing, density and
Young's modulus are 1. The stiffness is the sum over particles of (K1 strain)^T C (K1 strain), whose gradient the force of K3 is.

usage: strip.py"""
import numpy as np

NU = 0.3
LAME, SHEAR = NU / ((1 + NU) * (1 - 2 * NU)), 0.5 / (1 + NU)
ELASTICITY = np.array([[LAME + 2 * SHEAR, LAME, 0], [LAME, LAME + 2 * SHEAR, 0], [0, 0, SHEAR]])
SLOPES = {  # dW/dq up to a factor, which K1 divides out; q = r/h < 2
    "cubic spline": lambda q: -3 * q + 2.25 * q**2 if q < 1 else -0.75 * (2 - q) ** 2,
    "Wendland C2": lambda q: -5 * q * (1 - q / 2) ** 3,
}


def rows_of_gradients(rows, smoothing, ratio):
    """For each row (neighbour's row, its columns to the right, corrected grad W)."""
    reach, found = int(2 * ratio), []
    for row in range(rows):
        neighbours, moment = [], np.zeros((2, 2))
        for other in range(max(0, row - reach), min(rows, row + reach + 1)):
            for across in range(-reach, reach + 1):
                offset = np.array([across, other - row], float)
                distance = np.hypot(*offset)
                if 0 < distance < 2 * ratio:
                    gradient = -SLOPES[smoothing](distance / ratio) * offset / distance
                    moment += np.outer(offset, gradient)
                    neighbours.append((other, across, gradient))
        inverse = np.linalg.inv(moment)
        found.append([(other, across, gradient @ inverse) for other, across, gradient in neighbours])
    return found


def frequency(rows, wave_number, smoothing, ratio):
    """Lowest frequency of bending waves exp(i k x), rigid motion being none of them."""
    stiffness = np.zeros((2 * rows, 2 * rows), complex)
    for row, neighbours in enumerate(rows_of_gradients(rows, smoothing, ratio)):
        strain = np.zeros((3, 2 * rows), complex)
        for other, across, (gx, gy) in neighbours:
            block = np.array([[gx, 0], [0, gy], [gy, gx]])
            strain[:, 2 * other : 2 * other + 2] += block * np.exp(1j * wave_number * across)
            strain[:, 2 * row : 2 * row + 2] -= block
        stiffness += strain.conj().T @ ELASTICITY @ strain
    return np.sqrt(np.linalg.eigvalsh(stiffness)[0])


def timoshenko(depth, wave_number):
    """Frequency of a bending wave in Timoshenko's beam, plane strain, shear factor 5/(6 - nu)."""
    bending, shear, radius = 1 / (1 - NU**2), 5 / (6 - NU) * SHEAR, depth**2 / 12
    sum_ = wave_number**2 / bending + wave_number**2 / shear + 1 / (bending * radius)
    return np.sqrt(0.5 * bending * shear * (sum_ - np.sqrt(sum_**2 - 4 * wave_number**4 / (bending * shear))))


def bending_strain(rows, smoothing, ratio):
    """Strain along the strip of each row over its exact value, in u = (-x y, x^2/2 + nu' y^2/2), at x = 0."""
    height = np.arange(rows) - 0.5 * (rows - 1)
    return [sum(-across * height[other] * gradient[0] for other, across, gradient in neighbours) / -height[row]
            for row, neighbours in enumerate(rows_of_gradients(rows, smoothing, ratio))]


if __name__ == "__main__":
    for name, ratio in (("cubic spline", 1.2), ("Wendland C2", 1.5)):
        print(f"{name}, h = {ratio} dx; waves of the free beam, 4.73/L, L = 10 depths")
        for count in (5, 10, 20, 40):
            wave = 4.73 / (10 * count)
            print(f"  {count:2d} rows: frequency over Timoshenko's {frequency(count, wave, name, ratio) / timoshenko(count, wave):.4f}")
        outer = ", ".join(f"{share:.3f}" for share in bending_strain(10, name, ratio)[:4])
        print(f"  10 rows: strain along the beam over its exact value, outermost row first: {outer}")
