#!/usr/bin/env python3
"""Measures of the free-running tests of KVLCC2's model of 7 m, from their public records.

    python3 validation/independent/kvlcc2_tracks.py FOLDER

FOLDER is `data/01_raw` of github.com/martinlarsalbert/System-identification-of-Vessel-Manoeuvring-Models (Alexandersson et
al., Ocean Engineering 266, 2022), which holds the records that MARIN (2007) and HSVA (2006) gave to the workshop SIMMAN 2008.
They may not be passed on here: read them there.

MARIN's files are in full scale: time, x, y, roll, heading, velocities in earth axes, roll rate, yaw rate, rudder,
revolutions per minute. A negative rudder angle turns the ship to starboard. HSVA's files are in model scale: time, x, y, and
the heading in the fourth column. A turn begins with the first sample in which the rudder moves. The overshoot of a zig-zag is
the largest heading minus the zig-zag's angle.
"""

import math
import sys
from pathlib import Path

LENGTH_M = 320.0


def records(path):
    rows = []
    for line in path.read_text(encoding="latin-1").splitlines():
        try:
            row = [float(word) for word in line.split()]
        except ValueError:
            continue
        # Times have three digits, so that late samples repeat them.
        if len(row) >= 11 and (not rows or row[0] > rows[-1][0]):
            rows.append(row)
    return rows


def mean(values):
    values = list(values)
    return sum(values) / len(values)


def turn(rows):
    """Advance and tactical diameter over the length; ratio of speeds, r' and drift from 270 to 630 degrees of the turn."""
    at_rest = rows[0][9]
    start = next(row for row in rows if abs(row[9] - at_rest) > 0.3)
    heading = math.radians(start[4])
    turned = [abs(row[4] - start[4]) for row in rows]

    def place(angle):
        after = next(i for i, value in enumerate(turned) if value >= angle)
        share = (angle - turned[after - 1]) / (turned[after] - turned[after - 1])
        x, y = (a + share * (b - a) - c for a, b, c in zip(rows[after - 1][1:3], rows[after][1:3], start[1:3]))
        ahead, aside = math.cos(heading) * x + math.sin(heading) * y, math.cos(heading) * y - math.sin(heading) * x
        return ahead / LENGTH_M, abs(aside) / LENGTH_M

    steady = [row for row, value in zip(rows, turned) if 270 < value < 630]
    speeds = [math.hypot(row[5], row[6]) for row in steady]
    drifts = [math.degrees(math.atan2(row[6], row[5])) - row[4] for row in steady]
    return {
        "advance": place(90)[0],
        "advance from the first sample": place(90)[0] + (start[1] - rows[0][1]) / LENGTH_M,
        "diameter": place(180)[1],
        "speed_ratio": mean(speeds) / math.hypot(start[5], start[6]),
        "rate": mean(math.radians(abs(row[8])) * LENGTH_M / speed for row, speed in zip(steady, speeds)),
        "drift": abs(mean((drift + 180) % 360 - 180 for drift in drifts)),
        "helm before": at_rest,
        "revolutions of the model": mean(row[10] for row in rows) / 60 * math.sqrt(45.7),
    }


def overshoots(headings, angle):
    """First and second overshoot: the extremes between zeros of the heading, without the approach."""
    found, extreme = [], 0.0
    for before, heading in zip(headings, headings[1:]):
        extreme = max(extreme, abs(before))
        if before * heading < 0:
            found += [extreme - angle] if extreme > angle else []
            extreme = 0.0
    return (found + [extreme - angle])[:2]


def main(folder):
    marin, hsva = folder / "kvlcc2", folder / "kvlcc2_hsva" / "raw_data"
    for side, sign in (("starboard", "-"), ("port", "")):
        for measure, value in turn(records(marin / f"MARIN_FREE_KVLCC2_tc_{sign}35_m.dat")).items():
            print(f"MARIN, turn of 35, {side}: {measure:32} {value:.4g}")
        for angle in (10, 20):
            headings = [row[4] for row in records(marin / f"MARIN_FREE_KVLCC2_zz_{sign}{angle}_m.dat")]
            print(f"MARIN, {angle}/{angle}, {side}: overshoots", *(f"{value:.1f}" for value in overshoots(headings, angle)))
        headings = [row[3] for row in records(hsva / f"HSVA_CPMC_KVLCC2_Z_10_10_{side[0].upper()}.dat")]
        print(f"HSVA, 10/10, {side}: overshoots", *(f"{value:.1f}" for value in overshoots(headings, 10)))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]))
