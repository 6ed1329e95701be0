#!/usr/bin/env python3
"""Shallow water: a tanker with derivatives measured in it, and the factors of four sets of corrections, independent of the
program.

    python3 validation/independent/shallow_water.py

The tanker of 190 000 dwt (van Berlekom & Goddard, Trans. SNAME 80, 1972) from the public toolbox MSS
(github.com/cybergalactic/MSS, CRAFT/SHIP/models/tanker.m): each derivative is that in deep water plus a term in
z = T/(h - T). Prints each as a ratio to its value in deep water, and turning circle and zig-zag by Runge-Kutta at 16 kn approach, 80
rpm, without the toolbox' limit of the rudder's angle.

Factors: Ankudinov and Taimuri et al. (2020) as in github.com/nikpau/mmgdynamics, with T/B for B/T in K2; effective
aspect ratio with the k in its denominator.
"""

import math

TANKER = {"L": 304.8, "B": 47.17, "T": 18.46, "V": 220000.0}
KVLCC2 = {"L": 320.0, "B": 58.0, "T": 20.8, "V": 312600.0}
DEPTHS = (2.0, 1.5, 1.2)


def tanker_terms(z):
    """Derivatives in the toolbox' units; Y_r without the added mass' -m_x."""
    return {
        "Y_v": -1.205 + (-0.85 * (1 - 0.8 / z) * z if z > 0.8 else 0.0),
        "Y_r": (1 - 0.752 + 0.182 * z) + (0.05 + 0.05 * z),
        "N_v": -0.451 - 0.241 * z,
        "N_r": -0.231 - 0.047 * z,
        "Y_v|v|": -2.400 - 1.5 * z,
        "N_|v|r": -0.300 - 0.120 * z,
        "m_x": 0.050 + 0.050 * z,
        "m_y": 1.020 + 0.387 * z,
        "m_y + X_vr": 1.020 + 0.387 * z,
        "J_z": 0.1232 - 0.25**2 + 0.0045 * z,
        "R_0": -0.0377 - 0.0061 * z,
    }


def tanker_rates(s, order, z):
    u, v, r, _, _, psi, rudder = s
    length, n = TANKER["L"], 80.0 / 60.0
    beta = math.atan(v / u)
    thrust = -0.00695 * u * u / length - 0.00063 * u * n + length * 0.0000354 * n * n
    cc = 0.605 * u * n + 38.2 * n * n
    drifted = cc * abs(beta) * beta * abs(rudder)
    y_uv = -0.85 * (1 - 0.8 / z) * z if z > 0.8 else 0.0
    x = (-0.0377 * u * u + length * 2.02 * v * r + 0.3 * v * v - 0.093 * cc * rudder**2 + 0.152 * cc * beta * rudder
         + length * thrust * 0.78 - 0.0061 * u * u * z + length * 0.387 * v * r * z + 0.0125 * v * v * z * z)
    y = (-1.205 * u * v - 2.4 * abs(v) * v + 0.208 * cc * rudder - length * 0.752 * u * r - 2.16 * drifted
         + 0.04 * thrust * length + length * 0.182 * u * r * z + y_uv * u * v - 1.5 * abs(v) * v * z - 0.191 * drifted * z)
    m = (-0.451 * u * v - length * 0.3 * abs(v) * r - 0.098 * cc * rudder - length * 0.231 * u * r + 0.688 * drifted
         - length * 0.02 * thrust - length * 0.047 * u * r * z - 0.241 * u * v * z - length * 0.12 * abs(v) * r * z
         + 0.344 * drifted * z)
    rate = math.radians(2.33)
    return [x / length / (1.05 + 0.05 * z), y / length / (2.02 + 0.387 * z), m / length**2 / (0.1232 + 0.0045 * z),
            math.cos(psi) * u - math.sin(psi) * v, math.sin(psi) * u + math.cos(psi) * v, r,
            max(-rate, min(rate, order - rudder))]


def step(s, order, z, h):
    def moved(k, f):
        return [a + f * b for a, b in zip(s, k)]

    a = tanker_rates(s, order, z)
    b = tanker_rates(moved(a, h / 2), order, z)
    c = tanker_rates(moved(b, h / 2), order, z)
    d = tanker_rates(moved(c, h), order, z)
    return [x + h / 6 * (p + 2 * q + 2 * w + e) for x, p, q, w, e in zip(s, a, b, c, d)]


def tanker_turn(z, sign):
    """Tactical diameter [L], steady U/U0, r', drift [deg]; negative rudder turns to starboard."""
    s, diameter = [8.23, 0, 0, 0, 0, 0, 0], None
    while abs(s[5]) < 4 * math.pi:
        before, s = s, step(s, sign * math.radians(35), z, 1.0)
        if diameter is None and abs(s[5]) >= math.pi:
            part = (math.pi - abs(before[5])) / (abs(s[5]) - abs(before[5]))
            diameter = abs(before[4] + part * (s[4] - before[4])) / TANKER["L"]
    speed = math.hypot(s[0], s[1])
    return diameter, speed / 8.23, abs(s[2]) * TANKER["L"] / speed, math.degrees(abs(math.atan(s[1] / s[0])))


def tanker_overshoot(z, angle):
    """First overshoot [deg]."""
    s, order, peak = [8.23, 0, 0, 0, 0, 0, 0], -math.radians(angle), 0.0
    while s[5] < math.radians(angle):
        s = step(s, order, z, 0.2)
    while s[2] > 0:
        s = step(s, -order, z, 0.2)
        peak = max(peak, s[5])
    return math.degrees(peak) - angle


def aspect_ratio(ship, x):
    k, block = 2 * ship["T"] / ship["L"], ship["V"] / (ship["L"] * ship["B"] * ship["T"])
    full = 1.4 * block * ship["B"] / ship["L"]

    def effective(exponent):
        angle = math.pi * x / 2
        return k / (k * x / 2 + (angle / math.tan(angle)) ** exponent)

    damping = effective(0.7)
    return {"Y_v": (math.pi / 2 * effective(2.3) + full) / (math.pi / 2 * k + full), "Y_r": damping / k,
            "N_v": effective(1.7) / k, "N_r": (0.54 * damping - damping**2) / (0.54 * k - k * k)}


def ankudinov(ship, x):
    z, broad = x / (1 - x), ship["B"] / ship["T"]
    block = ship["V"] / (ship["L"] * ship["B"] * ship["T"])
    b = block * broad * (1 + ship["B"] / ship["L"]) ** 2
    k0 = 1 + 0.0775 * z**2 - 0.011 * z**3 + 0.000068 * z**5
    k1 = -0.0643 * z + 0.0724 * z**2 - 0.0113 * z**3 + 0.0000767 * z**5
    k2 = (0.0342 if broad <= 4 else 0.137 / broad) * z

    def factor(one, two):
        return k0 + one * k1 * b + two * k2 * b * b

    yaw = factor(1 / 2, 1 / 3)
    sway = 1.5 * yaw - 0.5
    return {"Y_v": sway, "Y_r": factor(2 / 5, 24 / 105), "N_v": factor(1, 1), "N_r": yaw, "Y_v|v|": sway, "N_|v|r": yaw,
            "m_y": factor(2 / 3, 8 / 15), "J_z": factor(8 / 15, 40 / 105)}


def power(ship, x):
    block = ship["V"] / (ship["L"] * ship["B"] * ship["T"])
    full = block * ship["B"] / ship["T"]
    return {"Y_v": (1 - x) ** (-0.4 * full) - x, "N_r": (1 - x) ** (14.28 * ship["T"] / ship["L"] - 1.5) - x}


def show(name, values):
    print(f"    {name:<22}" + " ".join(f"{key} {value:.3f}" for key, value in values.items()))


def main():
    deep = tanker_terms(1e-9)
    for ratio in DEPTHS:
        x, z = 1 / ratio, 1 / (ratio - 1)
        print(f"h/T {ratio}")
        show("tanker, tested", {key: value / deep[key] for key, value in tanker_terms(z).items()})
        for name, ship in (("tanker", TANKER), ("KVLCC2", KVLCC2)):
            own, other = aspect_ratio(ship, x), ankudinov(ship, x)
            show(f"{name}, aspect ratio", own)
            show(f"{name}, Ankudinov", other)
            show(f"{name}, power", power(ship, x))
            show(f"{name}, N_r, mean", {"N_r": (own["N_r"] + other["N_r"]) / 2})
    print("the tanker, 35 degrees to starboard: TD/L, U/U0, r', drift; first overshoot 10/10, 20/20")
    for ratio in (1e9,) + DEPTHS:
        z = 1 / (ratio - 1)
        turn = tanker_turn(z, -1)
        zigzags = [tanker_overshoot(z, angle) for angle in (10, 20)]
        print(f"    h/T {ratio:<8.4g}" + " ".join(f"{value:.3f}" for value in turn + tuple(zigzags)))


if __name__ == "__main__":
    main()
