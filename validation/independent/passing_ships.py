"""Peaks of the forces of a passing ship by the integrals of Wang (1975), with Gauss's rule.

    python3 validation/independent/passing_ships.py

prints, for parabolic sectional areas, the largest surge and sway over rho U^2 S1 S2 / L2^2 and the largest yaw over that times
L1: the references of validation/passing_ships.toml. It has nothing from the program: the double integrals are those of the paper, by
parts, while the program moves sources past the sections of the ship at rest.
"""

import math

POINTS = 40


def gauss(count):
    """Nodes and weights on -1 to 1, by Newton's method on the Legendre polynomial."""
    nodes, weights = [], []
    for index in range(count):
        z = math.cos(math.pi * (index + 0.75) / (count + 0.5))
        for _ in range(100):
            p, before = 1.0, 0.0
            for degree in range(count):
                p, before = ((2 * degree + 1) * z * p - degree * before) / (degree + 1), p
            slope = count * (z * p - before) / (z * z - 1.0)
            change = p / slope
            z -= change
            if abs(change) < 1e-15:
                break
        nodes.append(z)
        weights.append(2.0 / ((1.0 - z * z) * slope * slope))
    return nodes, weights


NODES, WEIGHTS = gauss(POINTS)


def forces(moored_m, passing_m, along_m, across_m):
    """Surge, sway and yaw over rho U^2 S1 S2; the areas are 1 - 4x^2/L^2."""
    surge = sway = yaw = 0.0
    for a, weight_a in zip(NODES, WEIGHTS):
        x1 = 0.5 * a * moored_m
        area1, slope1 = 1.0 - a * a, -8.0 * x1 / moored_m**2
        for b, weight_b in zip(NODES, WEIGHTS):
            x2 = 0.5 * b * passing_m
            slope2 = -8.0 * x2 / passing_m**2
            apart = x2 - x1 + along_m
            cube = (apart * apart + across_m * across_m) ** 1.5
            weight = 0.25 * weight_a * weight_b * moored_m * passing_m
            surge += weight * slope1 * slope2 * apart / cube
            sway += weight * slope1 * slope2 / cube
            yaw += weight * (slope1 * x1 + area1) * slope2 / cube
    return (
        surge / (2.0 * math.pi),
        sway * across_m / math.pi,
        yaw * across_m / math.pi,
    )


def peaks(moored_m, passing_m, across_m, steps=200):
    """The largest of each while the ship passes."""
    most = [0.0, 0.0, 0.0]
    for step in range(steps + 1):
        along_m = 0.8 * (moored_m + passing_m) * step / steps
        for index, force in enumerate(forces(moored_m, passing_m, along_m, across_m)):
            most[index] = max(most[index], abs(force))
    square = passing_m**2
    return most[0] * square, most[1] * square, most[2] * square / moored_m


if __name__ == "__main__":
    for name, case in {
        "one length, 0.10 of it apart": (200.0, 200.0, 20.0),
        "one length, 0.26 of it apart": (200.0, 200.0, 52.0),
        "one length, 0.50 of it apart": (200.0, 200.0, 100.0),
        "243.5 m and 185.4 m, 110 m apart": (243.5, 185.4, 110.0),
    }.items():
        print(name, " ".join(f"{value:.4f}" for value in peaks(*case)))
