"""Makes the chart and the survey of a harbour that exists nowhere: a channel with a bend, dredged into a shelving bottom, with sloping banks, a
turning basin and a quay.

    python3 scenarios/harbours/make_harbour.py

writes `bend.geojson` (features of S-57 in metres) and `bend.asc` (an ESRI ASCII grid of depths) beside this script. Standard library only; the files
are the same on every machine.
"""

import json
import math
from pathlib import Path

HERE = Path(__file__).resolve().parent

# Metres east and north. The channel comes from the west-south-west, bends to the east-north-east, and ends in the basin before the quay.
CENTRE = [(-2400.0, -900.0), (-200.0, -300.0), (1500.0, 300.0)]
HALF_WIDTH = 75.0
CHANNEL = 13.0
BANK = 1 / 6
BASIN, BASIN_RADIUS, POCKET = (1500.0, 300.0), 260.0, 13.5
# The quay's front runs along the coast; the land lies to the north of it.
QUAY = (1300.0, 1700.0)
COAST = 500.0
CELL = 20.0
WEST, SOUTH, COLUMNS, ROWS = -2200.0, -1000.0, 210, 80


def to_segment(x: float, y: float, a: tuple[float, float], b: tuple[float, float]) -> float:
    dx, dy = b[0] - a[0], b[1] - a[1]
    share = min(1.0, max(0.0, ((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy)))
    return math.hypot(x - a[0] - share * dx, y - a[1] - share * dy)


def natural(x: float, y: float) -> float:
    """The bottom before it was dredged: from 9 m in the south to the water's edge at the coast."""
    return min(9.0, (COAST - y) / 60.0)


def depth(x: float, y: float) -> float:
    """Depth below datum (m)."""
    before = natural(x, y)
    off = min(to_segment(x, y, a, b) for a, b in zip(CENTRE, CENTRE[1:]))
    dredged = CHANNEL - max(0.0, off - HALF_WIDTH) * BANK
    basin = POCKET - max(0.0, math.hypot(x - BASIN[0], y - BASIN[1]) - BASIN_RADIUS) * BANK
    # Before the quay the pocket goes up to its front, and on under it, as a wall stands there.
    if QUAY[0] <= x <= QUAY[1] and BASIN[1] <= y <= COAST + 2 * CELL:
        basin = POCKET
    return max(before, dredged, basin)


def value(x: float, y: float) -> str:
    """What the survey has: nothing on land, which the chart has."""
    is_land = y > COAST and not QUAY[0] <= x <= QUAY[1]
    return "-9999" if is_land or y > COAST + 2 * CELL else f"{depth(x, y):.1f}"


def survey() -> str:
    head = f"ncols {COLUMNS}\nnrows {ROWS}\nxllcenter {WEST:g}\nyllcenter {SOUTH:g}\ncellsize {CELL:g}\nNODATA_value -9999\n"
    rows = []
    for row in reversed(range(ROWS)):
        y = SOUTH + row * CELL
        rows.append(" ".join(value(WEST + column * CELL, y) for column in range(COLUMNS)))
    return head + "\n".join(rows) + "\n"


def feature(objl: int, kind: str, coordinates: object, **attributes: object) -> dict[str, object]:
    return {"type": "Feature", "properties": {"OBJL": objl, **attributes}, "geometry": {"type": kind, "coordinates": coordinates}}


def beside(along: float, side: float) -> tuple[float, float]:
    """A place beside the channel: metres along its centre line from the sea, and to the left of it."""
    for a, b in zip(CENTRE, CENTRE[1:]):
        length = math.hypot(b[0] - a[0], b[1] - a[1])
        if along <= length or b is CENTRE[-1]:
            ux, uy = (b[0] - a[0]) / length, (b[1] - a[1]) / length
            return round(a[0] + along * ux - side * uy, 1), round(a[1] + along * uy + side * ux, 1)
        along -= length
    raise AssertionError


def channel() -> list[list[float]]:
    """The edge of the dredged channel: its sides meet at the bend on the line that halves its angle."""
    (ax, ay), (bx, by), (cx, cy) = CENTRE
    first, second = math.atan2(by - ay, bx - ax), math.atan2(cy - by, cx - bx)
    half, reach = (first + second) / 2, HALF_WIDTH / math.cos((second - first) / 2)

    def off(at: tuple[float, float], direction: float, metres: float) -> list[float]:
        return [round(at[0] - metres * math.sin(direction), 1), round(at[1] + metres * math.cos(direction), 1)]

    left = [off(CENTRE[0], first, HALF_WIDTH), off(CENTRE[1], half, reach), off(CENTRE[2], second, HALF_WIDTH)]
    right = [off(CENTRE[0], first, -HALF_WIDTH), off(CENTRE[1], half, -reach), off(CENTRE[2], second, -HALF_WIDTH)]
    return [*right, *reversed(left), right[0]]


def chart() -> dict[str, object]:
    east, south = WEST + (COLUMNS - 1) * CELL, SOUTH
    north = SOUTH + (ROWS - 1) * CELL

    def band(y0: float, y1: float) -> list[list[list[float]]]:
        return [[[WEST, y0], [east, y0], [east, y1], [WEST, y1], [WEST, y0]]]

    nine, five = COAST - 9 * 60.0, COAST - 5 * 60.0
    features = [
        feature(42, "Polygon", band(south, nine), DRVAL1=9.0, DRVAL2=9.0),
        feature(42, "Polygon", band(nine, five), DRVAL1=5.0, DRVAL2=9.0),
        feature(42, "Polygon", band(five, COAST), DRVAL1=0.0, DRVAL2=5.0),
        feature(46, "Polygon", [channel()], DRVAL1=CHANNEL, OBJNAM="Channel"),
        feature(46, "Polygon", [[[QUAY[0], BASIN[1] - 150], [QUAY[1], BASIN[1] - 150], [QUAY[1], COAST], [QUAY[0], COAST], [QUAY[0], BASIN[1] - 150]]], DRVAL1=CHANNEL, OBJNAM="Basin"),
        feature(43, "LineString", [[WEST, nine], [east, nine]], VALDCO=9.0),
        feature(43, "LineString", [[WEST, five], [east, five]], VALDCO=5.0),
        feature(71, "Polygon", band(COAST, north), OBJNAM="Mainland"),
        feature(30, "LineString", [[WEST, COAST], [QUAY[0], COAST]]),
        feature(30, "LineString", [[QUAY[1], COAST], [east, COAST]]),
        feature(122, "LineString", [[QUAY[0], COAST], [QUAY[1], COAST]], CATSLC=6, OBJNAM="Long Quay"),
        feature(85, "LineString", [list(CENTRE[0]), list(CENTRE[1])], OBJNAM="First leg"),
        feature(85, "LineString", [list(CENTRE[1]), list(CENTRE[2])], OBJNAM="Second leg"),
        feature(75, "Point", [1900.0, 441.2], COLOUR=["1"], LITCHR=7, SIGGRP="(1)", SIGPER=4.0, VALNMR=9.0, OBJNAM="Basin Light"),
    ]
    for number, along in enumerate((300.0, 1000.0, 1700.0, 2500.0, 3200.0)):
        # Region A: red to port, green to starboard of a ship that enters.
        for side, code, colour, name in ((1, 1, "3", 2 * number + 2), (-1, 2, "4", 2 * number + 1)):
            at = beside(along, side * (HALF_WIDTH + 15))
            features.append(feature(17, "Point", list(at), CATLAM=code, COLOUR=[colour], OBJNAM=str(name)))
    soundings = []
    for column in range(10, COLUMNS, 20):
        for row in range(5, ROWS, 10):
            x, y = WEST + column * CELL, SOUTH + row * CELL
            if y < COAST:
                soundings.append([x, y, round(depth(x, y), 1)])
    features.append(feature(129, "MultiPoint", soundings))
    return {"type": "FeatureCollection", "name": "bend", "features": features}


def main() -> None:
    (HERE / "bend.asc").write_text(survey(), encoding="ascii", newline="\n")
    made = chart()
    lines = ",\n".join(json.dumps(one) for one in made["features"])  # type: ignore[attr-defined]
    text = f'{{\n"type": "FeatureCollection",\n"name": "bend",\n"features": [\n{lines}\n]\n}}\n'
    (HERE / "bend.geojson").write_text(text, encoding="ascii", newline="\n")


if __name__ == "__main__":
    main()
