#!/usr/bin/env python3
"""Squat in a channel by two formulas, independent of the program.

    python3 validation/independent/squat_in_channels.py

Barrass with blockage: Cb S2^(2/3) V^2.08 / 30 with V in knots, S2 = S/(1 - S), S = B T / A; open water is 7.7 + 20 (1 - Cw)^2 beams
wide, Cw = (1 + 2 Cb)/3. ICORELS with Huuska's factor: 2.4 Cb B T / L Fh^2 / sqrt(1 - Fh^2) times 7.45 s + 0.76 where that is above 1, s = 0.98 B T / A, as
the squat calculator of the Finnish transport agency has it (read; there the factor begins at s = 0.03).
"""

import math

SHIP = {"L": 190.0, "B": 32.26, "T": 11.9, "Cb": 0.78}
DEPTH_M, KNOTS, GRAVITY = 14.0, 9.0, 9.80665


def barrass(ship, width_m):
    waterplane = (1 + 2 * ship["Cb"]) / 3
    width_m = min(width_m, (7.7 + 20 * (1 - waterplane) ** 2) * ship["B"])
    blockage = ship["B"] * ship["T"] / (width_m * DEPTH_M)
    return ship["Cb"] * (blockage / (1 - blockage)) ** (2 / 3) * KNOTS**2.08 / 30


def icorels(ship, width_m):
    froude = KNOTS * 1852 / 3600 / math.sqrt(GRAVITY * DEPTH_M)
    blockage = 0.98 * ship["B"] * ship["T"] / (width_m * DEPTH_M)
    factor = 7.45 * blockage + 0.76 if blockage > 0.03 else 1.0
    return factor * 2.4 * ship["Cb"] * ship["B"] * ship["T"] / ship["L"] * froude**2 / math.sqrt(1 - froude**2)


for name, width_m in (("open water", math.inf), ("200 m", 200.0)):
    print(f"{name}: Barrass with blockage {barrass(SHIP, width_m):.4f} m, ICORELS with blockage {icorels(SHIP, width_m):.4f} m")
