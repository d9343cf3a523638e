#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-only
"""What a step of scarp-lammps costs on many nodes: the table of README.md. usage: step_model.py

A part is a cube of n particles. It has the ghosts of a shell as thick as the halo; numbers for each ghost and messages
are those that scarp-lammps sends, which the tests count. Times are assumptions, named below."""

import math

CORES = 32                # of a node; as many processes of one thread, or two of sixteen
STEP = 0.75e-6            # [s] of a particle in 3D on one core, `modern` (bench/README.md)
GHOST = 0.4e-6            # [s] of a ghost's values in and out of messages and records, by one thread (measured on one)
LATENCY = 2.0e-6          # [s] of a message between nodes
BANDWIDTH = 12.5e9        # [B/s] of a node, into which all ghosts come from others
JOINS = 5                 # joins of a step: time step (2), lists (2), end of the call
FIRST, SECOND = 7, 16     # numbers for each ghost: place, velocity, diffusivity; place, density, stress, moment
REACH = 2.15 * 1.3        # [dx] of the lists in 3D: (2 + skin) h
SMOOTH, ROUGH = REACH, 2.0 * REACH


def ghosts(n, halo):
    side = n ** (1.0 / 3.0)
    return (side + 2.0 * halo) ** 3 - n


def step_seconds(particles, nodes, each, halo):
    """[s] for own particles, ghosts, their values, joins; `each`: processes of a node."""
    n, threads = particles / (nodes * each), CORES / each
    count = ghosts(n, halo)
    # A shell comes in three rounds, along each axis from both sides.
    halo_seconds = 2 * 6 * LATENCY + each * count * (FIRST + SECOND) * 8 / BANDWIDTH
    joins = JOINS * LATENCY * math.ceil(math.log2(nodes * each))
    return n * STEP / threads, count * GHOST / threads, halo_seconds, joins


def main():
    print("| particles | walls | nodes | ghosts per particle | step | for ghosts, values, joins | efficiency "
          "| ... with 2 processes a node |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    for particles in (10**7, 10**8):
        for name, halo in (("smooth", SMOOTH), ("rough", ROUGH)):
            for nodes in (2, 16, 128, 1024):
                parts = step_seconds(particles, nodes, CORES, halo)
                few = step_seconds(particles, nodes, 2, halo)
                n = particles / nodes / CORES
                share = ", ".join(f"{100 * p / sum(parts):.0f} %" for p in parts[1:])
                print(f"| 10^{round(math.log10(particles))} | {name} | {nodes} | {ghosts(n, halo) / n:.2f} "
                      f"| {1e3 * sum(parts):.0f} ms | {share} | {100 * parts[0] / sum(parts):.0f} % "
                      f"| {100 * few[0] / sum(few):.0f} % |")


if __name__ == "__main__":
    main()
