#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-only
"""What a step of scarp-lammps costs on many nodes: the table of README.md. usage: step_model.py

A part is a cube of n particles. It has the ghosts of a shell as thick as the halo; numbers for each ghost and messages
are those that scarp-lammps sends, which the tests count. Times are assumptions, named below."""

import math

CORES = 32                # processes of a node, one thread each
STEP = 1.0e-6             # [s] of a particle in 3D on one core, modern numerics
GHOST = 0.1e-6            # [s] of a ghost: its record, twice a step, and its share of the lists
LATENCY = 2.0e-6          # [s] of a message between nodes
BANDWIDTH = 12.5e9 / CORES  # [B/s] of a process, where all send at once
JOINS = 5                 # joins of a step: time step (2), lists (2), end of the call
FIRST, SECOND = 6, 10     # numbers for each ghost: place, velocity; place, density, stress
REACH = 2.15 * 1.2        # [dx] of the lists: (2 + skin) h
SMOOTH, ROUGH = REACH, 2.0 * REACH


def ghosts(n, halo):
    side = n ** (1.0 / 3.0)
    return (side + 2.0 * halo) ** 3 - n


def step_seconds(particles, nodes, halo):
    processes = nodes * CORES
    n = particles / processes
    count = ghosts(n, halo)
    # A shell comes in three rounds, along each axis from both sides.
    halo_seconds = 2 * 6 * LATENCY + count * (FIRST + SECOND) * 8 / BANDWIDTH
    joins = JOINS * LATENCY * math.ceil(math.log2(processes))
    return n * STEP, count * GHOST, halo_seconds, joins


def main():
    print("| particles | walls | nodes | particles per process | ghosts per particle | step | of it for ghosts, halo, joins "
          "| efficiency |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    for particles in (10**7, 10**8, 10**9):
        for name, halo in (("smooth", SMOOTH), ("rough", ROUGH)):
            for nodes in (2, 16, 128, 1024):
                parts = step_seconds(particles, nodes, halo)
                n = particles / nodes / CORES
                share = ", ".join(f"{100 * p / sum(parts):.0f} %" for p in parts[1:])
                print(f"| 10^{round(math.log10(particles))} | {name} | {nodes} | {n:.0f} | {ghosts(n, halo) / n:.2f} "
                      f"| {1e3 * sum(parts):.3g} ms | {share} | {100 * parts[0] / sum(parts):.0f} % |")


if __name__ == "__main__":
    main()
