"""Quantities with units, as scenario and fender files write them, and straight lines through points."""

import math

UNITS = {
    "m": 1.0, "mm": 1e-3, "s": 1.0, "min": 60.0, "h": 3600.0, "kg": 1.0, "t": 1e3, "N": 1.0, "kN": 1e3, "MN": 1e6,
    "Pa": 1.0, "kPa": 1e3, "J": 1.0, "kJ": 1e3, "kn": 1852.0 / 3600.0, "rad": 1.0, "deg": math.pi / 180.0, "%": 0.01,
}


def si(value):
    """A number in SI; a string carries its unit: "500 kN/m^2", "20 kN.s/m^2"."""
    if not isinstance(value, str):
        return float(value)
    number, _, unit = value.strip().partition(" ")
    over, *under = unit.strip().split("/")
    factor = 1.0
    for group, direction in [(over, 1)] + [(part, -1) for part in under]:
        for name in group.split("."):
            name, _, power = name.partition("^")
            factor *= UNITS[name] ** (direction * int(power or 1))
    return float(number) * factor


def between(points, x):
    """Straight lines between points, the ends held; 1 where there are no points."""
    if not points:
        return 1.0
    if x <= points[0][0]:
        return points[0][1]
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        if x <= x1:
            return y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    return points[-1][1]


class Curve:
    """Reaction over deflection. Beyond the last point the last line goes on where it rises, else it is held."""

    def __init__(self, points):
        slope = (points[-1][1] - points[-2][1]) / (points[-1][0] - points[-2][0])
        far = points[-1][0] + 1e3
        self.points = points + [(far, points[-1][1] + max(slope, 0.0) * 1e3)]
        self.stored = [0.0]
        for (x0, y0), (x1, y1) in zip(self.points, self.points[1:]):
            self.stored.append(self.stored[-1] + 0.5 * (y0 + y1) * (x1 - x0))

    def at(self, x):
        """Reaction [N] and its integral [J]."""
        points = self.points
        i = 0
        while x > points[i + 1][0]:
            i += 1
        (x0, y0), (x1, y1) = points[i], points[i + 1]
        y = y0 + (y1 - y0) * (x - x0) / (x1 - x0)
        return y, self.stored[i] + 0.5 * (y0 + y) * (x - x0)

