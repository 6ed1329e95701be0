#!/usr/bin/env python3
"""Turning circles and zig-zags of KVLCC2 and KCS by the MMG standard method, written a second time.

    python3 validation/independent/mmg_standard.py             prints every measure
    python3 validation/independent/mmg_standard.py --check     compares validation/kvlcc2.toml and kcs.toml with them
    python3 validation/independent/mmg_standard.py --printed-digits
                                                               the effect of the last digits of KVLCC2's coefficients

The equations are those of Yasukawa & Yoshimura, Introduction of MMG standard method for ship maneuvering predictions,
J. Mar. Sci. Technol. 20 (2015), eq. 1 to 32. Coefficients are read from vessels/*.toml: this tests the program's formulas
and trials, not the data. Unlike in the program, one function has all forces, the equations of motion are
solved about midship, the step is fixed, and measures are interpolated between steps. Ahead only.

KCS has coefficients by the drift angle; gamma_R depends on the sign of the drift at the rudder, as in the program.
"""

import math
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[2]
RHO, KNOT, G = 1025.0, 1852.0 / 3600.0, 9.80665
UNITS = {"m": 1, "m^2": 1, "m^3": 1, "m^5": 1, "kn": KNOT, "deg/s": math.pi / 180, "deg": math.pi / 180, "rpm": 1 / 60}


def number(value):
    """A plain number, or one with a unit of those above."""
    if isinstance(value, str):
        figure, unit = value.split(" ", 1)
        return float(figure) * UNITS[unit]
    return float(value)


class Ship:
    def __init__(self, name):
        family = name.split("-")[0]
        vessels = tomllib.loads((ROOT / f"vessels/{family}.toml").read_text(encoding="utf-8"))["vessel"]
        own, base = vessels[name], vessels[vessels[name].get("coefficients_of", name)]

        def of(part, key, default=None):
            table = {**base.get(part, {}), **own.get(part, {})} if part else {**base, **own}
            return number(table[key]) if key in table else default

        self.L, self.B, self.d = of("", "length_bp"), of("", "beam"), of("", "draught")
        block = of("", "block_coefficient")
        self.volume = own.get("volume") and number(own["volume"]) or block * self.L * self.B * self.d
        self.xg = of("", "centre_of_gravity")
        self.m = RHO * self.volume
        self.inertia = self.m * of("", "gyradius") ** 2
        by_volume = "surge_volume" in base["added_mass"]
        if by_volume:
            self.mx, self.my, self.jz = (RHO * of("added_mass", f"{k}_volume") for k in ("surge", "sway", "yaw"))
        else:
            unit = 0.5 * RHO * self.L**2 * self.d
            self.mx, self.my = unit * of("added_mass", "surge"), unit * of("added_mass", "sway")
            self.jz = unit * self.L**2 * of("added_mass", "yaw")
        self.hull = {**base}.get("sway_polynomial") or base["drift_polynomial"]
        self.by_drift = "drift_polynomial" in base
        self.D = of("propeller", "diameter")
        self.k = [base["propeller"]["thrust"][f"k{i}"] for i in range(3)]
        self.tp, self.w0, self.xp = of("propeller", "thrust_deduction"), of("propeller", "wake"), of("propeller", "place")
        self.change = base["propeller"].get("wake_change")
        if "area" in {**base["rudder"], **own.get("rudder", {})}:
            self.area = of("rudder", "area")
            self.eta = self.D / of("rudder", "span")
            self.lift = of("rudder", "lift_gradient")
        else:
            self.area = self.L * self.d / of("rudder", "area_ratio")
            self.eta = of("rudder", "propeller_to_span")
            aspect = of("rudder", "aspect_ratio")
            self.lift = 6.13 * aspect / (2.25 + aspect)
        self.eps, self.kappa = of("rudder", "wake_ratio"), of("rudder", "race_gain")
        self.gamma = base["rudder"]["straightening"]
        self.lr, self.tr = of("rudder", "straightening_place"), of("rudder", "resistance_deduction")
        self.ah, self.xh = of("rudder", "hull_gain"), of("rudder", "hull_place")
        self.xr = of("rudder", "place", -0.5)
        self.rate = of("rudder", "rate")
        froude = of("", "froude")
        self.speed = of("", "speed") if froude is None else froude * math.sqrt(G * self.L)
        if "coefficients_of" in own:
            # A model at the ship's Froude number.
            scale = number(base["length_bp"]) / self.L
            self.speed /= math.sqrt(scale)
            self.rate *= math.sqrt(scale)
        self.n = self.balance()

    def balance(self):
        """Revolutions at which thrust balances resistance at the speed of approach."""
        low, high = 0.0, 50.0 * self.speed / self.D
        for _ in range(200):
            middle = 0.5 * (low + high)
            low, high = (low, middle) if self.forces(self.speed, 0.0, 0.0, 0.0, middle)[0] > 0 else (middle, high)
        return 0.5 * (low + high)

    def forces(self, u, v, r, delta, n):
        """X, Y, N about midship."""
        L, d, h = self.L, self.d, self.hull
        speed = math.hypot(u, v)
        vp, rp = v / speed, r * L / speed
        beta = math.atan2(-v, u)
        q = 0.5 * RHO * L * d * speed**2
        if self.by_drift:
            b = beta
            x = q * (h["x_0"] + h["x_bb"] * b * b + h["x_br"] * b * rp + h["x_rr"] * rp * rp + h["x_bbbb"] * b**4)
            y = q * (h["y_b"] * b + h["y_r"] * rp + h["y_bbb"] * b**3 + h["y_bbr"] * b * b * rp + h["y_brr"] * b * rp * rp
                     + h["y_rrr"] * rp**3)
            moment = q * L * (h["n_b"] * b + h["n_r"] * rp + h["n_bbb"] * b**3 + h["n_bbr"] * b * b * rp
                              + h["n_brr"] * b * rp * rp + h["n_rrr"] * rp**3)
        else:
            x = q * (-h["resistance"] + h["x_vv"] * vp**2 + h["x_vr"] * vp * rp + h["x_rr"] * rp**2 + h["x_vvvv"] * vp**4)
            y = q * (h["y_v"] * vp + h["y_r"] * rp + h["y_vvv"] * vp**3 + h["y_vvr"] * vp**2 * rp
                     + h["y_vrr"] * vp * rp**2 + h["y_rrr"] * rp**3)
            moment = q * L * (h["n_v"] * vp + h["n_r"] * rp + h["n_vvv"] * vp**3 + h["n_vvr"] * vp**2 * rp
                              + h["n_vrr"] * vp * rp**2 + h["n_rrr"] * rp**3)
        at_propeller = beta - self.xp * rp
        left = 1.0 - self.w0
        if self.change:
            c1, c2 = self.change["c1"], self.change["c2_above" if at_propeller > 0 else "c2_below"]
            left *= 1 + (1 - math.exp(-c1 * abs(at_propeller))) * (c2 - 1)
        flow = u * left
        j = flow / (n * self.D) if n > 0 else 0.0
        kt = self.k[0] + self.k[1] * j + self.k[2] * j * j
        x += (1 - self.tp) * RHO * n * n * self.D**4 * kt
        if n > 0:
            race = math.sqrt(max(0.0, flow**2 + 8 * kt * (n * self.D) ** 2 / math.pi))
            ur = self.eps * math.sqrt(self.eta * (flow + self.kappa * (race - flow)) ** 2 + (1 - self.eta) * flow**2)
        else:
            ur = self.eps * flow
        at_rudder = beta - self.lr * rp
        vr = speed * self.gamma["above" if at_rudder > 0 else "below"] * at_rudder
        normal = 0.5 * RHO * self.area * self.lift * (ur**2 + vr**2) * math.sin(delta - math.atan2(vr, ur))
        x -= (1 - self.tr) * normal * math.sin(delta)
        y -= (1 + self.ah) * normal * math.cos(delta)
        moment -= (self.xr + self.ah * self.xh) * L * normal * math.cos(delta)
        return x, y, moment

    def slope(self, state, delta):
        _, _, heading, u, v, r = state
        x, y, moment = self.forces(u, v, r, delta, self.n)
        # A drift polynomial has -m'y in x_br and -m'x in y_r already.
        mx, my = (0.0, 0.0) if self.by_drift else (self.mx, self.my)
        a, b = self.m + self.my, self.xg * self.m
        c = self.inertia + self.xg**2 * self.m + self.jz
        right_y = y - (self.m + mx) * u * r
        right_n = moment - b * u * r
        det = a * c - b * b
        return (
            u * math.cos(heading) - v * math.sin(heading),
            u * math.sin(heading) + v * math.cos(heading),
            r,
            (x + (self.m + my) * v * r + b * r * r) / (self.m + self.mx),
            (right_y * c - right_n * b) / det,
            (a * right_n - b * right_y) / det,
        )

    def step(self, state, delta, order, dt):
        """Runge-Kutta; the rudder turns at its own rate, or at once if it has none."""
        def rudder(time):
            if self.rate is None:
                return order
            return delta + math.copysign(min(abs(order - delta), self.rate * time), order - delta)

        k1 = self.slope(state, rudder(0.0))
        k2 = self.slope([s + 0.5 * dt * k for s, k in zip(state, k1)], rudder(0.5 * dt))
        k3 = self.slope([s + 0.5 * dt * k for s, k in zip(state, k2)], rudder(0.5 * dt))
        k4 = self.slope([s + dt * k for s, k in zip(state, k3)], rudder(dt))
        new = tuple(s + dt / 6 * (a + 2 * b + 2 * c + d) for s, a, b, c, d in zip(state, k1, k2, k3, k4))
        return new, rudder(dt)

    def start(self):
        return (0.0, 0.0, 0.0, self.speed, 0.0, 0.0), 0.0, 0.005 * self.L / self.speed

    def turn(self, degrees):
        state, delta, dt = self.start()
        side, order, marks = math.copysign(1.0, degrees), math.radians(degrees), {}
        while abs(state[2]) < 6 * math.pi:
            before = state
            state, delta = self.step(state, delta, order, dt)
            for name, mark, place in (("advance", math.pi / 2, 0), ("diameter", math.pi, 1)):
                if abs(before[2]) < mark <= abs(state[2]):
                    share = (mark - abs(before[2])) / (abs(state[2]) - abs(before[2]))
                    marks[name] = (before[place] + share * (state[place] - before[place])) / self.L
        u, v, r = state[3:]
        speed = math.hypot(u, v)
        return {"advance": marks["advance"], "diameter": side * marks["diameter"], "speed_ratio": speed / self.speed,
                "rate": abs(r) * self.L / speed, "drift": abs(math.degrees(math.atan2(-v, u)))}

    def zig_zag(self, degrees):
        state, delta, dt = self.start()
        check, side = math.radians(abs(degrees)), math.copysign(1.0, degrees)
        order, found = math.radians(degrees), []
        dt *= 0.2
        extreme = None
        while len(found) < 2:
            before = state[2]
            state, delta = self.step(state, delta, order, dt)
            heading = state[2]
            # The heading passes the check angle on the rudder's side: the rudder is reversed.
            if extreme is None and side * heading >= check:
                order, extreme = -order, 0.0
                side = -side
            elif extreme is not None:
                swing = -side * heading
                if swing < -side * before and -side * before > check:
                    found.append(math.degrees(-side * before - check))
                    extreme = None
        return {"first": found[0], "second": found[1]}


def all_numbers():
    found = {}
    for name, key in (("kvlcc2", "kvlcc2"), ("kvlcc2_model", "kvlcc2-model"), ("kcs", "kcs")):
        ship = Ship(key)
        found[f"{name}/self_propulsion"] = ship.n
        for side, sign in (("starboard", 1), ("port", -1)):
            for measure, value in ship.turn(35 * sign).items():
                found[f"{name}/turn_35/{side}/{measure}"] = value
            for angle in (10, 20):
                for measure, value in ship.zig_zag(angle * sign).items():
                    found[f"{name}/zigzag_{angle}/{side}/{measure}"] = value
    found.update(estimates_of(found))
    return found


def estimates_of(found):
    """The reference for estimates from main particulars: the mean of both sides."""
    means = {}
    for name in ("kvlcc2", "kcs"):
        for measure, trial in (("advance", "turn_35/{}/advance"), ("diameter", "turn_35/{}/diameter"),
                               ("overshoot_10", "zigzag_10/{}/first"), ("overshoot_20", "zigzag_20/{}/first")):
            mean = sum(found[f"{name}/{trial.format(side)}"] for side in ("starboard", "port")) / 2
            for route in ("yoshimura_masumoto", "clarke"):
                means[f"estimated/{route}/{name}/{measure}"] = mean
    return means


def printed_digits():
    """Each measure of the model of 7 m, and its change by half a unit of the last digit of every printed coefficient: the
    root of the sum of squares."""
    # Printed to two digits after the point; all others to three.
    two_digits = {"w0", "eps", "kappa"}
    places = ("w0", "tp", "eps", "kappa", "lr", "tr", "ah", "xh", "lift", "D")

    def measures(ship):
        found = {}
        for side, sign in (("starboard", 1), ("port", -1)):
            found |= {f"turn of 35, {side}: {name}": value for name, value in ship.turn(35 * sign).items()}
            for angle in (10, 20):
                trial = ship.zig_zag(angle * sign)
                found |= {f"{angle}/{angle}, {side}: {name}": value for name, value in trial.items()}
        return found

    def changed(change):
        ship = Ship("kvlcc2-model")
        ship.hull, ship.change, ship.gamma = dict(ship.hull), dict(ship.change), dict(ship.gamma)
        change(ship)
        ship.n = ship.balance()
        return measures(ship)

    base = Ship("kvlcc2-model")
    unit = 0.5 * RHO * base.L**2 * base.d

    def add(table, key, half):
        return lambda ship: getattr(ship, table).__setitem__(key, getattr(ship, table)[key] + half)

    changes = [add("hull", key, 0.0005) for key in base.hull]
    changes += [add("gamma", key, 0.0005) for key in base.gamma]
    changes += [add("change", key, 0.05) for key in base.change]
    for key in places:
        half = 0.005 if key in two_digits else 0.0005
        changes.append(lambda ship, key=key, half=half: setattr(ship, key, getattr(ship, key) + half))
    for key, size in (("mx", unit), ("my", unit), ("jz", unit * base.L**2)):
        changes.append(lambda ship, key=key, size=size: setattr(ship, key, getattr(ship, key) + 0.0005 * size))
    changes.append(lambda ship: setattr(ship, "area", ship.area + 0.00005))
    changes.append(lambda ship: setattr(ship, "xg", ship.xg + 0.005))
    changes.append(lambda ship: setattr(ship, "inertia", ship.m * (0.245 * ship.L) ** 2))

    as_printed, others = measures(base), [changed(change) for change in changes]
    for name, value in as_printed.items():
        left = math.sqrt(sum((other[name] - value) ** 2 for other in others))
        print(f"{name:36} {value:8.4f} +- {left:.4f}, {100 * left / value:.1f} %")


if __name__ == "__main__":
    if sys.argv[1:] == ["--printed-digits"]:
        sys.exit(printed_digits())
    numbers = all_numbers()
    if sys.argv[1:] == ["--check"]:
        from ship_formulas import check

        sys.exit(0 if check(numbers, "mmg_standard.py") else 1)
    for name, value in numbers.items():
        print(f"{name:40} {value:.5g}")
