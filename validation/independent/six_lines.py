#!/usr/bin/env python3
"""A published exercise of six mooring lines, and the statics of the same lines without its linear approximations.

A. Montanari, University of Bologna, "Computation of mooring forces": an exercise of his course in harbour engineering, whose solution is
a script on the pages of the course. Read: the exercise with its numbers, and the script. The formulas of the script are `published` below.

Prints, for each line, the tension of the exercise, and that of the lines as they are: straight between chock and bollard, their stretch by the true
distance, the rope from chock to bitts stretching with them; surge is held, as the exercise leaves it out. It shares no code with the engine.
"""

from math import atan, cos, hypot, sin, sqrt

BOLLARDS_M = [(-50.0, -10.0), (-35.0, -10.0), (-5.0, -10.0), (12.0, -10.0), (42.0, -10.0), (57.0, -10.0)]
CHOCKS_M = [(-50.0, -4.0), (-42.0, -5.0), (-10.0, -5.5), (17.0, -5.5), (49.0, -5.0), (57.0, -4.0)]
LENGTH_M, SIDE_M2, FORCE_COEFFICIENT = 117.0, 950.0, 1.3
WIND_MPS = 92.6 / 3.6
AIR_NPM3, GRAVITY_MPS2 = 12.25, 9.81
STIFFNESS_N = 90.0 * 125e3  # three ropes of 30 cm2, 125 kN/cm2
ON_DECK = 0.15  # of the distance from chock to bollard


def wind():
    """Force (N) across and moment (N m) about the pivot point."""
    force = FORCE_COEFFICIENT * SIDE_M2 * AIR_NPM3 * WIND_MPS**2 / (2.0 * GRAVITY_MPS2)
    return force, -0.04 * LENGTH_M * force


def published():
    """The exercise's solution: springs across the berth, k = EA/(1.15 l), k cos θ across."""
    force, moment = wind()
    springs = []
    for (bx, by), (cx, cy) in zip(BOLLARDS_M, CHOCKS_M):
        theta = atan((bx - cx) / (cy - by))
        length = (cy - by) / cos(theta)
        springs.append((STIFFNESS_N / ((1.0 + ON_DECK) * length) * cos(theta), cx, theta))
    a = sum(k for k, _, _ in springs)
    b = sum(k * x for k, x, _ in springs)
    c = sum(k * x * x for k, x, _ in springs)
    sway = (force * c - moment * b) / (a * c - b * b)
    yaw = (force * b - moment * a) / (b * b - a * c)
    return sway, yaw, [k * (sway + x * yaw) / cos(theta) for k, x, theta in springs]


def tensions(sway, yaw):
    """Tensions (N), force (N) and moment (N m) of the lines for a sway and a rotation of the ship about the pivot point."""
    all_n, force, moment = [], 0.0, 0.0
    for (bx, by), (cx, cy) in zip(BOLLARDS_M, CHOCKS_M):
        x, y = cx * cos(yaw) - cy * sin(yaw), sway + cx * sin(yaw) + cy * cos(yaw)
        rest, now = hypot(bx - cx, by - cy), hypot(bx - x, by - y)
        # Taut at the start; the rope outboard and that on deck have one tension and stretch by one strain.
        tension = max(0.0, STIFFNESS_N * (now - rest) / ((1.0 + ON_DECK) * rest))
        fx, fy = tension * (bx - x) / now, tension * (by - y) / now
        all_n.append(tension)
        force += fy
        moment += x * fy - (y - sway) * fx
    return all_n, force, moment


def exact():
    """Equilibrium in sway and yaw by Newton's method."""
    force, moment = wind()
    sway, yaw, _ = published()
    for _ in range(60):
        residual = [a + b for a, b in zip(tensions(sway, yaw)[1:], (force, moment))]
        step = (1e-7, 1e-9)
        columns = []
        for ds, dy in ((step[0], 0.0), (0.0, step[1])):
            moved = [a + b for a, b in zip(tensions(sway + ds, yaw + dy)[1:], (force, moment))]
            columns.append([(m - r) / (ds + dy) for m, r in zip(moved, residual)])
        (a, c), (b, d) = columns
        det = a * d - b * c
        sway -= (d * residual[0] - b * residual[1]) / det
        yaw -= (a * residual[1] - c * residual[0]) / det
    assert sqrt(sum(r * r for r in residual)) < 1e-3 * force, residual
    return sway, yaw, tensions(sway, yaw)[0]


def main():
    force, moment = wind()
    print(f"wind: {force / 1e3:.4f} kN, {moment / 1e3:.4f} kN m about the pivot point")
    for name, (sway, yaw, tension) in (("exercise", published()), ("as they are", exact())):
        numbers = " ".join(f"{n / 1e3:.4f}" for n in tension)
        print(f"{name}: sway {sway * 1e3:.3f} mm, yaw {yaw * 1e3:.5f} mrad; tensions (kN) {numbers}")


if __name__ == "__main__":
    main()
