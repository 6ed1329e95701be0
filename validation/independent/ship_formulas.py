#!/usr/bin/env python3
"""Formulas of wind, current, waves, cables and floating, written a second time.

    python3 validation/independent/ship_formulas.py            prints every number
    python3 validation/independent/ship_formulas.py --check    compares the rows of validation/*.toml with them

Each function names the source of its formula and where it was read. The ship is the paper's container ship:
298 x 46 x 9 m, Cb 0.694 by the length overall, A_L 9000 m2, A_F 1700 m2. A row that cites this script has the number here,
to its last printed digit.
"""

import math
import sys
import tomllib
from pathlib import Path

G, SEA, AIR, KNOT = 9.80665, 1025.0, 1.224, 1852.0 / 3600.0
L, B, T, CB = 298.0, 46.0, 9.0, 0.694
VOLUME = CB * L * B * T
SIDE, FRONT = 9000.0, 1700.0


def isherwood():
    """Isherwood, Wind resistance of merchant ships, RINA 1973: the rows of his tables for 0, 60 and 90 degrees, read in
    isherwood72.m of the MSS toolbox (cybergalactic/MSS). Perimeter 700 m, one group of masts, superstructure 1500 m2,
    centroid amidships: assumed here and in the program. The angle counts from the bow."""
    perimeter, superstructure, masts, centroid = 700.0, 1500.0, 1.0, L / 2

    def surge(a):
        return -(a[0] + a[1] * 2 * SIDE / L**2 + a[2] * 2 * FRONT / B**2 + a[3] * L / B + a[4] * perimeter / L
                 + a[5] * centroid / L + a[6] * masts)

    def sway(b):
        return (b[0] + b[1] * 2 * SIDE / L**2 + b[2] * 2 * FRONT / B**2 + b[3] * L / B + b[4] * perimeter / L
                + b[5] * centroid / L + b[6] * superstructure / SIDE)

    return {
        "isherwood/surge_0": surge((2.152, -5.00, 0.243, -0.164, 0, 0, 0)),
        "isherwood/surge_60": surge((0.913, -4.68, 0, -0.104, 0.482, 0, 0.052)),
        "isherwood/surge_180": surge((-2.529, 3.76, -0.174, 0.128, 0, 1.55, 0)),
        "isherwood/sway_60": sway((1.163, 0.96, 0.101, 0, -0.177, -0.88, 0)),
        "isherwood/sway_90": sway((0.889, 0, 0.138, 0, 0, -0.66, 0)),
        "isherwood/sway_120": sway((0.996, 0, 0.184, 0, -0.212, -0.66, 0.34)),
    }


def blendermann():
    """Blendermann, Parameter identification of wind loads on ships, J. Wind Eng. Ind. Aerodyn. 51 (1994): container ship,
    loaded (CDt 0.90, CDl 0.55 from ahead and astern, delta 0.40), read in blendermann94.m of the MSS toolbox."""
    across, along, delta = 0.90, 0.55, 0.40
    on_side = along * FRONT / SIDE

    def at(degrees):
        angle = math.radians(degrees)
        low = 1 - 0.5 * delta * (1 - on_side / across) * math.sin(2 * angle) ** 2
        cx, cy = -along * math.cos(angle) / low, across * math.sin(angle) / low
        return cx, cy, (0 - 0.18 * (angle - math.pi / 2)) * cy

    return {
        "blendermann/surge_0": at(0)[0],
        "blendermann/surge_30": at(30)[0],
        "blendermann/sway_30": at(30)[1],
        "blendermann/sway_60": at(60)[1],
        "blendermann/sway_90": at(90)[1],
        "blendermann/yaw_60": at(60)[2],
        "blendermann/yaw_120": at(120)[2],
        "blendermann/side": 0.5 * AIR * 20.0**2 * SIDE * at(90)[1] / 1e6,
    }


def current():
    """UFC 4-159-03, Design: Moorings (2005), eq. 9 to 13, read: F = 1/2 rho V^2 L T C, C = C0 + (3.2 - C0)(T/d)^2,
    C0 = 0.22 sqrt(L^2 Am/(B V)). 0.5 m/s abeam. The midship coefficient of 0.98 is assumed."""
    deep = 0.22 * math.sqrt(L * L * 0.98 * B * T / (B * VOLUME))
    unit = 0.5 * SEA * 0.5**2 * L * T / 1e3
    found = {}
    for name, ratio in (("100", 100.0), ("2", 2.0), ("1.2", 1.2)):
        found[f"current/{name}"] = unit * (deep + (3.2 - deep) / ratio**2)
        # The reference for the simulation, which has its own coefficient in deep water.
        found[f"current/simulated/{name}"] = found[f"current/{name}"]
    return found


def cross_flow():
    """The drag coefficient of the midship section: the points of Hoerner.m of the MSS toolbox, which gives Leite et al.,
    Appl. Ocean Res. 20 (1998) for them, with straight lines between. The integrals over the length by 20,000 strips."""
    points = [(0.472838, 1.58374), (0.492877, 1.27862), (0.493252, 1.21082), (0.558473, 1.08356), (0.833589, 0.87959),
              (0.988002, 0.828415), (1.30807, 0.759941), (1.63918, 0.691442), (1.85998, 0.657076), (2.31288, 0.630693),
              (2.59998, 0.596186), (3.00877, 0.586846), (3.45075, 0.585909), (3.7379, 0.559877), (4.00309, 0.559315)]

    def coefficient(ratio):
        if ratio >= points[-1][0]:
            return points[-1][1]
        for (a, low), (b, high) in zip(points, points[1:]):
            if a <= ratio <= b:
                return low + (high - low) * (ratio - a) / (b - a)
        raise ValueError(ratio)

    drag, strips = coefficient(B / (2 * T)), 20_000
    places = [(k + 0.5) / strips * L - L / 2 for k in range(strips)]
    sway = 0.5 * SEA * T * drag * sum(1.0 for _ in places) * L / strips
    yaw = 0.5 * SEA * T * drag * sum(abs(0.01 * x) * 0.01 * x * x for x in places) * L / strips
    found = {f"hoerner/{name}": coefficient(float(name)) for name in ("0.5", "0.99", "1.31", "2.31", "4")}
    return found | {"cross_flow/drag": drag, "cross_flow/sway": sway / 1e3, "cross_flow/yaw": yaw / 1e6}


def jonswap():
    """JONSWAP in the form of DNV-RP-C205, read in waveSpectrum.m of the MSS toolbox: Hs 2 m, Tp 8 s, gamma 3.3, integrated
    from 0.2 to 4 rad/s by the trapezoidal rule. A_gamma = 1 - 0.287 ln(gamma)."""
    hs, wp, gamma = 2.0, 2 * math.pi / 8.0, 3.3

    def density(w):
        sigma = 0.07 if w <= wp else 0.09
        peak = gamma ** math.exp(-0.5 * ((w - wp) / (sigma * wp)) ** 2)
        return (1 - 0.287 * math.log(gamma)) * 5 / 16 * hs**2 * wp**4 / w**5 * math.exp(-1.25 * (wp / w) ** 4) * peak

    step, count = 2e-4, 19_000
    m0 = step * (sum(density(0.2 + k * step) for k in range(1, count)) + 0.5 * (density(0.2) + density(4.0)))
    return {"jonswap/m0": m0, "jonswap/height": 4 * math.sqrt(m0)}


def floating():
    """T = 2 pi k/sqrt(g GM) with k = 0.40 B, and 2 pi sqrt(3 m/(rho g Awp)) for an added mass of twice the displacement, with
    a waterplane of 10 612 m2: closed forms of a floating body; k and the added mass are assumed here and in the program."""
    found = {f"roll/{gm}": 2 * math.pi * 0.40 * B / math.sqrt(G * gm) for gm in (1, 2, 5)}
    return found | {"heave": 2 * math.pi * math.sqrt(3 * VOLUME / (G * 10_612.0))}


def tug():
    """F/BP = sqrt(1 - (D/BP)^2), D = 1/2 rho Cd L T V^2: the force that a tug across the flow has left of her bollard pull.
    60 t, 32 x 4.5 m, Cd 0.73. A derivation of ours: no published envelope was found."""
    pull = 60e3 * G
    drag = 0.5 * SEA * 0.73 * 32.0 * 4.5
    return {f"tug/{knots}": math.sqrt(1 - (drag * (knots * KNOT) ** 2 / pull) ** 2) for knots in (5, 6)}


def cable():
    """An elastic cable on a flat bottom without friction: span 200 m, depth 50 m, 210 m, EA 1e9 N, 200 kg/m, 0.1 m thick, in
    sea water. Not by the closed form: the suspended part is summed from 20,000 pieces, each stretched by its own tension,
    and the two unknowns, horizontal tension and length on the bottom, are found by bisection. `catenary()` of MoorPy 3.0
    gives 483.611 and 315.967 kN."""
    weight = (200.0 - SEA * math.pi * 0.1**2 / 4) * G
    stiffness, length, span, depth = 1e9, 210.0, 200.0, 50.0
    pieces = 20_000

    def hang(horizontal, lying):
        ds = (length - lying) / pieces
        x, z = lying * (1 + horizontal / stiffness), 0.0
        for k in range(pieces):
            vertical = weight * ds * (k + 0.5)
            tension = math.hypot(horizontal, vertical)
            stretch = 1 + tension / stiffness
            x += ds * stretch * horizontal / tension
            z += ds * stretch * vertical / tension
        return x, z

    def lying_for_depth(horizontal):
        low, high = 0.0, length
        for _ in range(40):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if hang(horizontal, middle)[1] > depth else (low, middle)
        return 0.5 * (low + high)

    # Nested bisection would need 40 x 40 sums of 20,000; a secant on the span needs few.
    a, b = 4.0e5, 6.0e5
    fa, fb = (hang(h, lying_for_depth(h))[0] - span for h in (a, b))
    for _ in range(12):
        a, b, fa = b, b - fb * (b - a) / (fb - fa), fb
        fb = hang(b, lying_for_depth(b))[0] - span
        if abs(fb) < 1e-9:
            break
    vertical = weight * (length - lying_for_depth(b))
    return {"cable/horizontal": b / 1e3, "cable/vertical": vertical / 1e3,
            "cable/tension": math.hypot(b, vertical) / 1e3}


def added_mass():
    """Clarke, Gedling & Hine (1983) by 1/2 rho L^3 and 1/2 rho L^5, read in clarke83.m of the MSS toolbox; and the regression
    of Zhou, Sheng & Feng (1983) on Motora's charts, as in public programs that agree; no print was read. Shares of the
    displacement, and of the moment of inertia at a gyradius of 0.25 L. Container ship, and the tug of 32 x 13 x 4.5 m."""
    def zhou(l, b, d, cb):
        surge = (0.398 + 11.97 * cb * (1 + 3.73 * d / b) - 2.89 * cb * l / b * (1 + 1.13 * d / b)
                 + 0.175 * cb * (l / b) ** 2 * (1 + 0.541 * d / b) - 1.107 * l * d / b**2) / 100
        sway = (0.882 - 0.54 * cb * (1 - 1.6 * d / b) - 0.156 * (1 - 0.673 * cb) * l / b
                + 0.826 * d * l / b**2 * (1 - 0.678 * d / b) - 0.638 * cb * d * l / b**2 * (1 - 0.669 * d / b))
        arm = l / 100 * (33 - 76.85 * cb * (1 - 0.784 * cb) + 3.43 * l / b * (1 - 0.63 * cb))
        mass = SEA * cb * l * b * d
        return surge, sway, (arm / (0.25 * l)) ** 2, mass * (1 + min(surge, sway)) / 1e6

    found = {}
    for name, hull in (("container", (L, B, T, CB)), ("tug", (32.0, 13.0, 4.5, 0.485))):
        for key, value in zip(("surge", "sway", "yaw", "mass"), zhou(*hull)):
            found[f"{name}/zhou/{key}"] = value
    slender = math.pi * (T / L) ** 2
    sway = slender * (1 + 0.16 * CB * B / T - 5.1 * (B / L) ** 2) * 0.5 * L**3
    yaw = slender * (1 / 12 + 0.017 * CB * B / T - 0.33 * B / L) * 0.5 * L**5
    return found | {"container/clarke/sway": sway / VOLUME, "container/clarke/yaw": yaw / (VOLUME * (0.25 * L) ** 2)}


def all_numbers():
    found = {}
    for part in (isherwood, blendermann, current, cross_flow, jonswap, floating, tug, cable, added_mass):
        found |= part()
    return found


def check(found, script="ship_formulas.py"):
    """Compares each row that cites the script with its number, to half a unit of the row's last digit."""
    bad, count = 0, 0
    for path in sorted(Path(__file__).parents[1].glob("*.toml")):
        text = path.read_text(encoding="utf-8")
        data = tomllib.loads(text, parse_float=str)
        only = data["reference"][0]["short"] if len(data.get("reference", [])) == 1 else None
        for row in data.get("number", []):
            if row.get("source", only) != script:
                continue
            count += 1
            printed = str(row["published"])
            digits = len(printed.partition(".")[2])
            value = found.get(row["computed"])
            if value is None or abs(value - float(printed)) > 0.5000001 * 10.0**-digits:
                print(f"{path.name}: {row['case']} ({row['computed']}): {printed} in the file, {value} here")
                bad += 1
    print(f"{count} rows cite {script}, {bad} of them differ")
    return bad == 0 and count > 0


if __name__ == "__main__":
    numbers = all_numbers()
    if sys.argv[1:] == ["--check"]:
        sys.exit(0 if check(numbers) else 1)
    for name, value in numbers.items():
        print(f"{name:28} {value:.6g}")
