"""Why tables of passing-ship peaks and the integrals of Wang (1975) differ: other readings of the tables.

    python3 validation/independent/passing_table.py

prints, for two ships of one length, the peaks by the integrals over those of the tables, with several sectional areas; the distance at which
the integrals would give each number of the tables; and how near any sectional area of the form (1 - |2x/L|^n)^p, with any common
factor, can come to all nine numbers. It has nothing from the program.
"""

import math

from passing_ships import gauss

TABLE = {0.10: (4.73, 24.9, 5.33), 0.26: (1.62, 5.9, 1.23), 0.50: (0.48, 1.55, 0.25)}
NAMES = ("surge", "sway", "yaw")
NODES, WEIGHTS = gauss(32)
PLACES = 120


def power(n, p):
    """The area (1 - |z|^n)^p over that of midship, and its slope, for z from -1 to 1."""
    area = lambda z: (1.0 - abs(z) ** n) ** p
    slope = lambda z: -p * n * math.copysign(abs(z) ** (n - 1), z) * (1.0 - abs(z) ** n) ** (p - 1)
    return area, slope


COSINE = (lambda z: math.cos(0.5 * math.pi * z), lambda z: -0.5 * math.pi * math.sin(0.5 * math.pi * z))


def peaks(apart, shape):
    """The largest surge, sway and yaw of ships of length 2, `apart` lengths from each other, over rho U^2 S1 S2 / L^2."""
    area, slope = shape
    areas, slopes = [area(z) for z in NODES], [slope(z) for z in NODES]
    across = 2.0 * apart
    most = [0.0, 0.0, 0.0]
    for place in range(PLACES + 1):
        along = 3.2 * place / PLACES
        sums = [0.0, 0.0, 0.0]
        for z1, w1, s1, d1 in zip(NODES, WEIGHTS, areas, slopes):
            by_x = by_r = 0.0
            for z2, w2, d2 in zip(NODES, WEIGHTS, slopes):
                off = z2 - z1 + along
                part = w2 * d2 / (off * off + across * across) ** 1.5
                by_x += part * off
                by_r += part
            sums[0] += w1 * d1 * by_x
            sums[1] += w1 * d1 * by_r
            sums[2] += w1 * (d1 * z1 + s1) * by_r
        forces = (sums[0] / (2.0 * math.pi), sums[1] * across / math.pi, sums[2] * across / math.pi)
        most = [max(a, abs(b)) for a, b in zip(most, forces)]
    return 4.0 * most[0], 4.0 * most[1], 2.0 * most[2]


def ratios(shape):
    return {apart: [a / b for a, b in zip(peaks(apart, shape), table)] for apart, table in TABLE.items()}


def print_ratios(name, shape):
    for apart, row in ratios(shape).items():
        print(f"{name}, {apart:.2f}: " + ", ".join(f"{n} {100 * (r - 1):+.1f} %" for n, r in zip(NAMES, row)))


def distance(apart, index):
    """The distance at which the parabolas have the table's number."""
    low, high = 0.8 * apart, 1.3 * apart
    for _ in range(20):
        middle = 0.5 * (low + high)
        if peaks(middle, power(2, 1))[index] > TABLE[apart][index]:
            low = middle
        else:
            high = middle
    return low


if __name__ == "__main__":
    print_ratios("parabola", power(2, 1))
    print_ratios("cosine", COSINE)
    print_ratios("fourth power", power(4, 1))
    print("distance at which the parabola has the table's number, over that of the table")
    for apart in TABLE:
        print(f"{apart:.2f}: " + ", ".join(f"{n} {distance(apart, i) / apart:.3f}" for i, n in enumerate(NAMES)))
    best = (math.inf, 0.0, 0.0, 0.0)
    for n in (1.6, 1.8, 2.0, 2.2, 2.4, 2.8):
        for p in (1.0, 1.1, 1.2, 1.3, 1.5):
            logs = [math.log(r) for row in ratios(power(n, p)).values() for r in row]
            off = 0.5 * (max(logs) - min(logs))
            best = min(best, (off, n, p, math.exp(-0.5 * (max(logs) + min(logs)))))
    off, n, p, factor = best
    print(f"best of all: n {n}, p {p}, times {factor:.3f}: the worst of nine numbers is {100 * off:.1f} % off")
