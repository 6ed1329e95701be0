"""Rows of fenders as single fenders. Known are rows along an edge of a body's outline, by `first`, `spacing` and `number`."""

import math

from .quantities import si

PLACING = ("first", "spacing", "number")


def fenders(scenario):
    """[(name, table)] of all fenders, those of rows included."""
    found = list(scenario.get("fender", {}).items())
    for name, row in scenario.get("fender_row", {}).items():
        found += members(name, row, scenario["body"][row["on"]]["outline"])
    return found


def members(name, row, outline):
    for key in ("last", "wall", "dolphins", "exception", "facing"):
        if key in row:
            raise ValueError(f"`{key}` of a row of fenders is not known here")
    x, y = (si(value) for value in row["first"])
    dx, dy, facing = edge(outline, x, y)
    shared = {key: value for key, value in row.items() if key not in PLACING}
    for index in range(row["number"]):
        along = index * si(row["spacing"])
        place = [x + along * dx, y + along * dy]
        yield f"{name}_{index + 1}", shared | {"position": place, "facing": facing}


def edge(outline, x, y):
    """Direction of the edge at a point, forward (or to starboard), and the angle out of the body [rad]."""
    points = [[si(value) for value in point] for point in outline]
    area = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(points, points[1:] + points[:1]))
    edges = []
    for (ax, ay), (bx, by) in zip(points, points[1:] + points[:1]):
        length = math.hypot(bx - ax, by - ay)
        dx, dy = (bx - ax) / length, (by - ay) / length
        along, off = (x - ax) * dx + (y - ay) * dy, (y - ay) * dx - (x - ax) * dy
        if abs(off) < 0.01 and -0.01 < along < length + 0.01:
            out = math.atan2(-dx, dy) if area > 0 else math.atan2(dx, -dy)
            is_back = dx < 0 if abs(dx) > 1e-9 else dy < 0
            edges.append((-dx, -dy, out) if is_back else (dx, dy, out))
    if len(edges) != 1:
        raise ValueError(f"[{x}, {y}] is on {len(edges)} edges of its body")
    return edges[0]
