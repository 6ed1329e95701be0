"""Makes the chart, the survey and the tidal stream of a harbour that exists nowhere: a channel with a bend, dredged into a shelving bottom, with
sloping banks, a breakwater behind which the stream is slack, a turning basin and a quay.

    python3 scenarios/harbours/make_harbour.py

writes `bend.geojson` (features of S-57 in metres), `bend.asc` (an ESRI ASCII grid of depths) and `bend_stream.csv` (a current by place) beside this
script. Standard library only; the files are the same on every machine.
"""

import json
import math
from pathlib import Path

HERE = Path(__file__).resolve().parent

# Metres east and north. The channel comes from the south-west, bends to the east-north-east, and ends in the basin before the quay.
CENTRE = [(-1700.0, -1650.0), (-200.0, -300.0), (1500.0, 300.0)]
HALF_WIDTH = 75.0
CHANNEL = 13.0
BANK = 1 / 6
BASIN, BASIN_RADIUS, POCKET = (1500.0, 300.0), 260.0, 13.5
# The quay's front runs along the coast; the land lies to the north of it.
QUAY = (1300.0, 1700.0)
COAST = 500.0
# Beyond this line the bottom falls away to the sea.
SHELF, SEAWARD = -1300.0, 1 / 40
# The breakwater runs from the coast to the south, and ends 120 m before the middle of the channel.
BREAKWATER, HEAD = (-912.0, -888.0), -760.0
CELL = 20.0
WEST, SOUTH, COLUMNS, ROWS = -2200.0, -1900.0, 210, 125
# The stream sets along the coast, and is slack behind the breakwater (m/s). Eastings and northings between which it changes.
STREAM, SLACK = 0.35, 0.05
STREAM_EAST, STREAM_NORTH = (-2400.0, -960.0, -840.0, 2200.0), (-2100.0, -960.0, -560.0, 700.0)


def to_segment(x: float, y: float, a: tuple[float, float], b: tuple[float, float]) -> float:
    dx, dy = b[0] - a[0], b[1] - a[1]
    share = min(1.0, max(0.0, ((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy)))
    return math.hypot(x - a[0] - share * dx, y - a[1] - share * dy)


def natural(x: float, y: float) -> float:
    """The bottom before it was dredged: from the sea over a shelf of 9 m to the water's edge at the coast."""
    return min(9.0, (COAST - y) / 60.0) + max(0.0, SHELF - y) * SEAWARD


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


def stream() -> str:
    """The tidal stream at the corners of a grid: to the east outside, almost nothing to the east and to the north of the breakwater's head."""
    rows = []
    for north in STREAM_NORTH:
        for east in STREAM_EAST:
            is_behind = north >= STREAM_NORTH[2] and east >= STREAM_EAST[2]
            rows.append(f"{north:g},{east:g},{SLACK if is_behind else STREAM:g},90")
    head = "# Tidal stream of the harbour with a bend: along the coast outside, slack behind the breakwater. Made by make_harbour.py.\n"
    return head + "north_m,east_m,speed_mps,towards_deg\n" + "\n".join(rows) + "\n"


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
    ten, deepest = SHELF - 1.0 / SEAWARD, natural(WEST, SOUTH)
    west, east_side = BREAKWATER
    mole = [[west, COAST], [west, HEAD + 9], [-900.0, HEAD], [east_side, HEAD + 9], [east_side, COAST], [west, COAST]]
    features = [
        feature(42, "Polygon", band(south, ten), DRVAL1=10.0, DRVAL2=deepest),
        feature(42, "Polygon", band(ten, nine), DRVAL1=9.0, DRVAL2=10.0),
        feature(42, "Polygon", band(nine, five), DRVAL1=5.0, DRVAL2=9.0),
        feature(42, "Polygon", band(five, COAST), DRVAL1=0.0, DRVAL2=5.0),
        feature(46, "Polygon", [channel()], DRVAL1=CHANNEL, OBJNAM="Channel"),
        feature(46, "Polygon", [[[QUAY[0], BASIN[1] - 150], [QUAY[1], BASIN[1] - 150], [QUAY[1], COAST], [QUAY[0], COAST], [QUAY[0], BASIN[1] - 150]]], DRVAL1=CHANNEL, OBJNAM="Basin"),
        feature(43, "LineString", [[WEST, ten], [east, ten]], VALDCO=10.0),
        feature(43, "LineString", [[WEST, nine], [east, nine]], VALDCO=9.0),
        feature(43, "LineString", [[WEST, five], [east, five]], VALDCO=5.0),
        feature(71, "Polygon", band(COAST, north), OBJNAM="Mainland"),
        feature(30, "LineString", [[WEST, COAST], [QUAY[0], COAST]]),
        feature(30, "LineString", [[QUAY[1], COAST], [east, COAST]]),
        feature(122, "LineString", [[QUAY[0], COAST], [QUAY[1], COAST]], CATSLC=6, OBJNAM="Long Quay"),
        feature(122, "Polygon", [mole], CATSLC=1, OBJNAM="Breakwater"),
        feature(75, "Point", [-900.0, HEAD + 6], COLOUR=["3"], LITCHR=2, SIGPER=5.0, VALNMR=7.0, OBJNAM="Breakwater Light"),
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
    (HERE / "bend_stream.csv").write_text(stream(), encoding="ascii", newline="\n")
    made = chart()
    lines = ",\n".join(json.dumps(one) for one in made["features"])  # type: ignore[attr-defined]
    text = f'{{\n"type": "FeatureCollection",\n"name": "bend",\n"features": [\n{lines}\n]\n}}\n'
    (HERE / "bend.geojson").write_text(text, encoding="ascii", newline="\n")


if __name__ == "__main__":
    main()
