#!/usr/bin/env python3
"""Turning circles and zig-zags of three ships with public manoeuvring models: references for estimates from main
particulars.

    python3 validation/independent/reference_ships.py            # prints every number
    python3 validation/independent/reference_ships.py --check    # compares the rows of validation/*.toml that cite it

Coefficients read in the public toolbox MSS (github.com/cybergalactic/MSS, CRAFT/SHIP/models), integrated here by
Runge-Kutta, without its limits of the rudder's angle:

- S175, a container ship of 175 m with roll, GM 0.3 m: Son & Nomoto, J. Soc. Nav. Arch. Japan 150 (1981); 80 rpm.
- A tanker of 190 000 dwt and 304.8 m: van Berlekom & Goddard, Trans. SNAME 80 (1972); 80 rpm, deep water.
- Mariner, a cargo ship of 160.93 m: Chislett & Strom-Tejsen, report Hy-5, Lyngby (1965); 15 kn. Two readings. The terms
  of the surge velocity are those of an expansion of (U/U0)^2 about U0 (Yd, 2 Yd, Yd; Yvu = Yv; 2 Y0, Y0), so that forces by
  the speed of approach count the loss of speed once; the toolbox takes forces by the momentary speed, which counts it
  twice.

Prints, as means of both sides for a rudder of 35 degrees: advance and tactical diameter in lengths; first overshoot of
10/10 and 20/20 in degrees. Then the speed of approach, and data of propeller and rudder that are not in the sources but follow from their
forces: the diameter by the thrust at bollard with a K_T of 0.34, the area by the rudder's force at small angles with
Fujii's gradient at an aspect ratio of 1.6, the speed of approach as inflow, and a_H = 3.6 Cb B/L.
"""

import math
import sys


class S175:
    length, rate = 175.0, math.radians(5.0)
    rps = 80.0 / 60.0
    m, mx, my, mass_iz, jz, ix, jx = 0.00792, 0.000238, 0.007049, 0.000456, 0.000419, 0.0000176, 0.0000034
    alpha_y, lever = 0.05, 0.0313

    def balance(self, u):
        return self.derivative([u, 0, 0, 0, 0, 0, 0, 0], 0.0)[0]

    def derivative(self, s, rudder):
        du, dv, dr, _, _, psi, dp, phi = s
        length = self.length
        speed = math.hypot(du, dv)
        u, v, r, p = du / speed, dv / speed, dr * length / speed, dp * length / speed
        u_p = u * ((1 - 0.184) + 1.09 * (v - 0.526 * r) ** 2)
        diameter = 6.533
        j = u_p * speed / (self.rps * diameter)
        kt = 0.527 - 0.455 * j
        u_r = u_p * 0.921 * math.sqrt(1 + 8 * 0.631 * kt / (math.pi * j * j))
        v_r = 0.088 * v - 0.156 * r - 0.275 * r**3 + 1.96 * r * r * v
        gradient = 6.13 * 1.8219 / (1.8219 + 2.25)
        normal = -gradient * 33.0376 / length**2 * (u_r**2 + v_r**2) * math.sin(rudder + math.atan2(v_r, u_r))
        thrust = 2 * diameter**4 * kt * self.rps**2 / (speed * length) ** 2
        weight = 9.81 * 21222 / (0.5 * (length * speed) ** 2)
        x = (-0.0004226 * u * u + (1 - 0.175) * thrust + (self.m + self.my - 0.00311) * v * r - 0.00386 * v * v
             + 0.0002 * r * r - 0.0002 * phi * phi + 0.71 * normal * math.sin(rudder))
        y = (-0.0116 * v + 0.00242 * r - 0.000063 * phi - 0.109 * v**3 + 0.00177 * r**3 + 0.0214 * v * v * r
             - 0.0405 * v * r * r + 0.04605 * v * v * phi + 0.00304 * v * phi * phi + 0.009325 * r * r * phi
             - 0.001368 * r * phi * phi + 1.237 * normal * math.cos(rudder) - (self.m + self.mx) * u * r)
        k = (0.0003026 * v - 0.000063 * r - 0.0000075 * p - 0.000021 * phi + 0.002843 * v**3 - 0.0000462 * r**3
             - 0.000588 * v * v * r + 0.0010565 * v * r * r - 0.0012012 * v * v * phi - 0.0000793 * v * phi * phi
             - 0.000243 * r * r * phi + 0.00003569 * r * phi * phi - 1.237 * 0.033 * normal * math.cos(rudder)
             + self.mx * self.lever * u * r - weight * 0.3 / length * phi)
        n = (-0.0038545 * v - 0.00222 * r + 0.000213 * p - 0.0001424 * phi + 0.001492 * v**3 - 0.00229 * r**3
             - 0.0424 * v * v * r + 0.00156 * v * r * r - 0.019058 * v * v * phi - 0.0053766 * v * phi * phi
             - 0.0038592 * r * r * phi + 0.0024195 * r * phi * phi + (-0.5 - 0.237 * 0.48) * normal * math.cos(rudder))
        # Sway and roll are coupled by the heights at which the added mass acts; yaw is not.
        m22, m33, m44 = self.m + self.my, self.ix + self.jx, self.mass_iz + self.jz
        m32, m42 = -self.my * self.lever, self.my * self.alpha_y
        det = m22 * m33 * m44 - m32**2 * m44 - m42**2 * m33
        sway = (m33 * m44 * y - m32 * m44 * k - m42 * m33 * n) / det
        yaw = (-m42 * m33 * y + m32 * m42 * k + (m22 * m33 - m32**2) * n) / det
        roll = (-m32 * m44 * y + (m22 * m44 - m42**2) * k + m32 * m42 * n) / det
        a, b = speed**2 / length, (speed / length) ** 2
        return [x * a / (self.m + self.mx), sway * a, yaw * b,
                du * math.cos(psi) - dv * math.sin(psi) * math.cos(phi),
                du * math.sin(psi) + dv * math.cos(psi) * math.cos(phi),
                dr * math.cos(phi), roll * b, dp]


class Tanker:
    length, rate = 304.8, math.radians(2.33)
    rps = 80.0 / 60.0
    volume, beam, draught = 220000.0, 47.17, 18.46

    def balance(self, u):
        return self.derivative([u, 0, 0, 0, 0, 0, 0, 0], 0.0)[0]

    def derivative(self, s, rudder):
        u, v, r, _, _, psi = s[:6]
        d, n, length = -rudder, self.rps, self.length  # their rudder is positive to port
        drift = math.atan2(v, u)
        thrust = -0.00695 / length * u * u - 0.00063 * u * n + length * 0.0000354 * n * n
        race = 0.605 * u * n + 38.2 * n * n
        bend = race * abs(drift) * drift * abs(d)
        x = (-0.0377 * u * u + length * 2.02 * v * r + 0.3 * v * v - 0.093 * race * d * d + 0.152 * race * drift * d
             + length * thrust * (1 - 0.22)) / length
        y = (-1.205 * u * v - 2.4 * abs(v) * v + 0.208 * race * d - length * 0.752 * u * r - 2.16 * bend
             + 0.04 * thrust * length) / length
        z = (-0.451 * u * v - length * 0.3 * abs(v) * r - 0.098 * race * d - length * 0.231 * u * r + 0.688 * bend
             - 0.02 * length * thrust)
        return [x / 1.05, y / 2.02, z / (length**2 * 0.1232),
                u * math.cos(psi) - v * math.sin(psi), u * math.sin(psi) + v * math.cos(psi), r, 0.0, 0.0]

    def gear(self, speed):
        per_length = 1025 * self.volume / self.length
        diameter = (1025 * self.volume * self.length * 0.0000354 / (1025 * 0.34)) ** 0.25
        force = per_length * 0.208 * (0.605 * speed * self.rps + 38.2 * self.rps**2)
        full = self.volume / (self.length**2 * self.draught)
        return diameter, force / (0.5 * 1025 * speed**2 * fujii(1.6) * (1 + 3.6 * full))


class Mariner:
    length, rate, speed = 160.93, math.radians(5.0), 7.7175

    def __init__(self, by_momentary_speed):
        self.by_momentary_speed = by_momentary_speed

    def derivative(self, s, rudder):
        surge, sway, yaw, _, _, psi = s[:6]
        length, e = self.length, 1e-5
        unit = math.hypot(surge, sway) if self.by_momentary_speed else self.speed
        u, v, r, d = (surge - self.speed) / unit, sway / unit, yaw * length / unit, -rudder
        x = (-184 * u - 110 * u * u - 215 * u**3 - 899 * v * v + 18 * r * r - 95 * d * d - 190 * u * d * d
             + 798 * r * v + 93 * v * d + 93 * u * v * d) * e
        y = (-1160 * v * (1 + u) - 499 * r * (1 + u) - 8078 * v**3 + 15356 * v * v * r + 278 * d * (1 + u) ** 2
             - 90 * d**3 - 4 * v * d * d + 1190 * v * v * d - 4 * (1 + u) ** 2) * e
        n = (-264 * v * (1 + u) - 166 * r * (1 + u) + 1636 * v**3 - 5483 * v * v * r - 139 * d * (1 + u) ** 2
             + 45 * d**3 + 13 * v * d * d - 489 * v * v * d + 3 * (1 + u) ** 2) * e
        m22, m23 = (798 + 748) * e, 798 * e * -0.023 + 9.354 * e
        m32, m33 = 798 * e * -0.023 - 4.646 * e, (39.2 + 43.8) * e
        det = m22 * m33 - m23 * m32
        a = unit**2 / length
        return [x * a / ((798 + 42) * e), (m33 * y - m23 * n) / det * a, (m22 * n - m32 * y) / det * a / length,
                surge * math.cos(psi) - sway * math.sin(psi), surge * math.sin(psi) + sway * math.cos(psi), yaw,
                0.0, 0.0]

    def gear(self):
        full = 0.00798 * 0.5 * self.length / 7.47
        return 0.00278 * self.length**2 / (fujii(1.6) * (1 + 3.6 * full))


def fujii(aspect):
    return 6.13 * aspect / (aspect + 2.25)


def step(f, s, h):
    k1 = f(s)
    k2 = f([a + 0.5 * h * b for a, b in zip(s, k1)])
    k3 = f([a + 0.5 * h * b for a, b in zip(s, k2)])
    k4 = f([a + h * b for a, b in zip(s, k3)])
    return [a + h / 6 * (p + 2 * q + 2 * r + t) for a, p, q, r, t in zip(s, k1, k2, k3, k4)]


def moved(rudder, goal, change):
    return rudder + max(-change, min(change, goal - rudder))


def turn(ship, speed, goal):
    h = ship.length / speed / 200
    s, rudder, advance = [speed, 0, 0, 0, 0, 0, 0, 0], 0.0, None
    while True:
        rudder = moved(rudder, goal, ship.rate * h)
        after = step(lambda state: ship.derivative(state, rudder), s, h)
        before_rad, after_rad = abs(s[5]), abs(after[5])
        for angle in (math.pi / 2, math.pi):
            if before_rad < angle <= after_rad:
                share = (angle - before_rad) / (after_rad - before_rad)
                place = [a + share * (b - a) for a, b in zip(s, after)]
                if angle == math.pi:
                    return advance, abs(place[4]) / ship.length
                advance = place[3] / ship.length
        s = after


def overshoot(ship, speed, angle, side):
    h = ship.length / speed / 200
    s, rudder, goal, largest = [speed, 0, 0, 0, 0, 0, 0, 0], 0.0, side * angle, 0.0
    while True:
        rudder = moved(rudder, goal, ship.rate * h)
        s = step(lambda state: ship.derivative(state, rudder), s, h)
        heading = side * s[5]
        if heading >= angle:
            goal = -side * angle
        if goal * side < 0:
            largest = max(largest, heading - angle)
            if heading < angle:
                return math.degrees(largest)


def approach(ship):
    low, high = 1.0, 20.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if ship.balance(middle) > 0 else (low, middle)
    return middle


SHIPS = [("s175", S175()), ("tanker_190", Tanker()), ("mariner", Mariner(False)), ("mariner_momentary", Mariner(True))]


def measures(ship):
    speed = ship.speed if isinstance(ship, Mariner) else approach(ship)
    turns = [turn(ship, speed, side * math.radians(35)) for side in (1, -1)]
    advance, diameter = (sum(both) / 2 for both in zip(*turns))
    ten, twenty = (sum(overshoot(ship, speed, math.radians(angle), side) for side in (1, -1)) / 2
                   for angle in (10, 20))
    return speed, {"advance": advance, "diameter": diameter, "overshoot_10": ten, "overshoot_20": twenty}


def all_numbers():
    found = {}
    for name, ship in SHIPS:
        for measure, value in measures(ship)[1].items():
            for route in ("yoshimura_masumoto", "clarke"):
                found[f"estimated/{route}/{name}/{measure}"] = value
    return found


def main():
    for name, ship in SHIPS:
        speed, found = measures(ship)
        print(f"{name}: approach {speed:.4f} m/s, "
              + ", ".join(f"{measure} {value:.4f}" for measure, value in found.items()))
        if isinstance(ship, Tanker):
            diameter, area = ship.gear(speed)
            print(f"  propeller {diameter:.2f} m, rudder {area:.1f} m2")
        if isinstance(ship, Mariner):
            print(f"  rudder {ship.gear():.1f} m2")


if __name__ == "__main__":
    if sys.argv[1:] == ["--check"]:
        from ship_formulas import check

        sys.exit(0 if check(all_numbers(), "reference_ships.py") else 1)
    main()
