#!/usr/bin/env python3
"""Added mass of hulls with the container ship's dimensions, by a public panel method.

    python3 -m venv venv && venv/bin/pip install capytaine==3.0.0 scipy
    venv/bin/python validation/independent/added_mass_panels.py

Capytaine solves the potential flow. The water surface is a rigid lid (frequency zero), because manoeuvring is slow. The ship
is 298 x 46 x 9 m with a block coefficient of 0.694. Her real hull is not known, so two are computed: one with the full
draught at the ends, one with rounded sections that rise by nine tenths at the ends. The real hull is probably between them.
Prints added mass over the displacement, and over the moment of inertia at a gyradius of 0.25 L, for two meshes of each.
"""

import logging

import capytaine as cpt
import numpy as np
from scipy.special import beta

LENGTH, BEAM, DRAUGHT, BLOCK, DENSITY = 298.0, 46.0, 9.0, 0.694, 1025.0
PARALLEL, RISE_FROM, AMIDSHIPS = 0.25, 0.6, 8.0
HULLS = {"as deep at the ends": (8.0, 0.0), "cut away at the ends": (2.0, 0.9)}


def from_end(x, begin):
    """0 amidships to `begin` of the half length, 1 at the end; x from -1 to 1."""
    return np.clip((np.abs(x) - begin) / (1 - begin), 0, 1)


def sections(x, fineness, at_ends, rise):
    """Half beam and draught as shares, and the exponent of the superellipse that a section is."""
    return (1 - from_end(x, PARALLEL) ** fineness, 1 - rise * from_end(x, RISE_FROM) ** 2,
            at_ends + (AMIDSHIPS - at_ends) * (1 - from_end(x, PARALLEL)))


def block(fineness, at_ends, rise):
    x = np.linspace(-1, 1, 2001)
    width, depth, power = sections(x, fineness, at_ends, rise)
    return np.trapezoid(width * depth * beta(1 / power, 1 + 1 / power) / power, x) / 2


def fineness_for_block(at_ends, rise):
    low, high = 1.0, 30.0
    for _ in range(80):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if block(middle, at_ends, rise) < BLOCK else (low, middle)
    return 0.5 * (low + high)


def hull(at_ends, rise, along, down):
    fineness = fineness_for_block(at_ends, rise)
    x = -np.cos(np.linspace(0, np.pi, along + 1))
    angle = np.linspace(0, np.pi / 2, down + 1)

    def point(place, turn, side):
        width, depth, power = sections(place, fineness, at_ends, rise)
        return (place * LENGTH / 2, side * BEAM / 2 * width * np.cos(turn) ** (2 / power),
                -DRAUGHT * depth * np.sin(turn) ** (2 / power))

    panels = []
    for i in range(along):
        for j in range(down):
            for side in (1, -1):
                corners = [point(x[i], angle[j], side), point(x[i + 1], angle[j], side),
                           point(x[i + 1], angle[j + 1], side), point(x[i], angle[j + 1], side)]
                panels.append(corners[::side])
    vertices = np.array(panels).reshape(-1, 3)
    mesh = cpt.Mesh(vertices=vertices, faces=np.arange(len(vertices)).reshape(-1, 4))
    return cpt.FloatingBody(mesh=mesh, dofs=cpt.rigid_body_dofs(rotation_center=(0, 0, 0)))


def main():
    logging.disable(logging.WARNING)
    solver = cpt.BEMSolver()
    mass = DENSITY * BLOCK * LENGTH * BEAM * DRAUGHT
    units = {"Surge": mass, "Sway": mass, "Yaw": mass * (0.25 * LENGTH) ** 2}
    for name, (at_ends, rise) in HULLS.items():
        for along, down in ((30, 6), (50, 9)):
            body = hull(at_ends, rise, along, down)
            shares = []
            for motion, unit in units.items():
                problem = cpt.RadiationProblem(body=body, omega=0.0, radiating_dof=motion, rho=DENSITY)
                shares.append(f"{motion.lower()} {solver.solve(problem).added_masses[motion] / unit:.4f}")
            print(f"{name}, {2 * along * down} panels: {', '.join(shares)}")


if __name__ == "__main__":
    main()
