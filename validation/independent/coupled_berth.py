#!/usr/bin/env python3
"""The scenarios of scenarios/berth without hydrodynamics, by the coupled method of `coupled/`.

    python3 coupled_berth.py                  runs all at their coarse steps and compares with berth/*.csv: a minute
    python3 coupled_berth.py make [NAME ...]  runs them at their fine steps too and writes berth/*.csv anew, and
                                              validation/coupled_independent.toml: ten minutes of a free core
    python3 coupled_berth.py run FILE STEP    any scenario that `coupled/` knows, with STEP in seconds; prints a table
"""

import csv
import math
import pathlib
import sys
import time
import tomllib

from coupled.simulation import Simulation

HERE = pathlib.Path(__file__).parent
SCENARIOS = HERE.parents[1] / "scenarios" / "berth"
RESULTS = HERE / "berth"
ROWS = HERE.parent / "coupled_independent.toml"
COLUMNS = ["quantity", "of", "unit", "value", "at_coarse_step"]

# Fine and coarse step of each scenario [s].
STEPS = {
    "bulb_and_stern_step_at_a_corner": (0.005, 0.02),
    "eight_cones_at_5_deg": (0.005, 0.02),
    "held_by_wind_six_hours": (0.05, 0.2),
    "leaning_on_eight_fenders": (0.05, 0.2),
    "tug_pushes_then_slides": (0.005, 0.02),
    "two_ships_on_pneumatic_fenders": (0.005, 0.02),
}

# Permitted difference between two machines, whose sines may differ, as a share of the largest value of a unit.
SAME = 1e-3

# Permitted difference of the two programs at their fine steps, and the known error of these steps.
TOLERANCE, UNCERTAINTY = 0.005, 0.003


def played(path, step_s):
    """[(quantity, of, unit, value)] of a run."""
    with open(path, "rb") as file:
        simulation = Simulation(tomllib.load(file), step_s)
    begun = time.monotonic()
    simulation.run()
    print(f"{path.stem}: {simulation.count} steps of {step_s} s in {time.monotonic() - begun:.0f} s, "
          f"at most {simulation.most_rounds} rounds", file=sys.stderr)
    rows = []
    for name, (_, force, _, depth, _) in sorted(simulation.peaks.items()):
        rows += [("peak_force", name, "N", force), ("peak_depth", name, "m", depth)]
    for body in simulation.bodies:
        if not body.fixed:
            rows += [
                ("final_speed", body.name, "m/s", math.hypot(body.vx, body.vy)),
                ("largest_speed", body.name, "m/s", simulation.fastest[body.name]),
                ("final_yaw_rate", body.name, "rad/s", body.rate),
                ("largest_yaw_rate", body.name, "rad/s", simulation.most_turning[body.name]),
            ]
    return rows


def read(name):
    with open(RESULTS / f"{name}.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    assert rows[0] == COLUMNS, name
    return [(quantity, of, unit, float(value), float(coarse)) for quantity, of, unit, value, coarse in rows[1:]]


def make(names):
    RESULTS.mkdir(exist_ok=True)
    for name in names:
        fine, coarse = (played(SCENARIOS / f"{name}.toml", step_s) for step_s in STEPS[name])
        others = {row[:2]: row[3] for row in coarse}
        with open(RESULTS / f"{name}.csv", "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(COLUMNS)
            for row in fine:
                writer.writerow([*row[:3], f"{row[3]:.8g}", f"{others[row[:2]]:.8g}"])
    ROWS.write_text(validation_rows(), encoding="utf-8")


def compare():
    """Runs at the coarse steps; the exit code."""
    wrong = 0
    for name, (_, step_s) in STEPS.items():
        kept = read(name)
        now = played(SCENARIOS / f"{name}.toml", step_s)
        if [row[:3] for row in kept] != [row[:3] for row in now]:
            print(f"{name}: other contacts or bodies than in berth/{name}.csv")
            wrong += 1
            continue
        for (quantity, of, unit, _, before), (_, _, _, value) in zip(kept, now):
            size = max(abs(row[4]) for row in kept if row[2] == unit)
            if abs(value - before) > SAME * size:
                print(f"{name}: {quantity} of {of} is {value:.8g} {unit}, kept {before:.8g}")
                wrong += 1
    print("as kept" if wrong == 0 else f"{wrong} differ: make them anew, with the reason in the commit")
    return 1 if wrong else 0


def validation_rows():
    """The file for `fenderline validate`: for each scenario the contact with the largest force, and every body."""
    text = [HEADING]
    for name in STEPS:
        title = name.replace("_", " ")
        rows = read(name)
        forces = [row for row in rows if row[0] == "peak_force"]
        hardest = max(forces, key=lambda row: row[3])[1]
        values = {row[:2]: row[3] for row in rows}
        for quantity, words in (("peak_force", "peak force"), ("peak_depth", "peak depth")):
            value = values[quantity, hardest]
            unit, value = ("kN", 1e-3 * value) if quantity == "peak_force" else ("m", value)
            text.append(row_of(f"{title}: {words} of {hardest}", f"{name}/{words} of {hardest}", value, unit,
                               f"tolerance = {TOLERANCE}", PEAKS, 'uncertainty = "steps"'))
        for body in [row[1] for row in rows if row[0] == "largest_speed"]:
            value = values["final_speed", body]
            largest = values["largest_speed", body]
            text.append(row_of(f"{title}: final speed of {body}", f"{name}/final speed of {body}", value, "m/s",
                               f"tolerance_absolute = {TOLERANCE * largest:.2g}", SPEEDS,
                               f'uncertainty = {UNCERTAINTY * largest:.2g}\nuncertainty_from = "{STEPS_OF_SPEEDS}"'))
    return "\n".join(text)


PEAKS = "Both programs agree within half a per cent at their fine steps: the goal."
SPEEDS = "0.5 % of the largest speed that the body has in the run: most end nearly at rest."
STEPS_OF_SPEEDS = "0.3 % of the largest speed, as of the peaks."
HEADING = """\
# The coupled method against its second implementation, which knows nothing of the first. Made by
# `python3 validation/independent/coupled_berth.py make`; do not edit.

subject = "Contact: the coupled method, written twice"

[[reference]]
short = "independent"
citation = "validation/independent/coupled: the coupled method in Python, by other ways, at fixed steps of 5 to 50 ms."
standing = "computed"

[[uncertainty]]
name = "steps"
share = 0.003
from = "Sub-steps of at most 0.15 rad leave (ωh)²/8, 0.3 %; the second program's coarse step changes peaks by 0.15 %."
"""


def row_of(case, computed, value, unit, tolerance, reason, uncertainty):
    return f"""\
[[number]]
case = "{case[0].upper()}{case[1:]}"
place = "its csv in berth/"
computed = "berth/{computed}"
published = {value:.6g}
unit = "{unit}"
{tolerance}
reason = "{reason}"
{uncertainty}
"""


def main(arguments):
    match arguments:
        case []:
            return compare()
        case ["make", *names]:
            make(names or STEPS)
        case ["run", path, step_s]:
            for quantity, of, unit, value in played(pathlib.Path(path), float(step_s)):
                print(f"{quantity:16} {of:24} {value:14.7g} {unit}")
        case _:
            print(__doc__)
            return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
