#!/usr/bin/env python3
"""Fits coefficients of KVLCC2's model of 7 m to her free-running turning circles, and writes ../kvlcc2_fitted.toml.

    python3 validation/independent/kvlcc2_fit.py FOLDER [COEFFICIENT...]

needs the Python package of fenderline with SciPy (`pip install ".[identify]"`). FOLDER is that of kvlcc2_tracks.py: the records
may not be passed on, so the fitted vessel is kept here, and `fenderline validate` runs her.

The records are in full scale, and a negative rudder angle turns the ship to starboard. The fit takes the first 420 s after the
order, the measured rudder, the measured state at the start, and the revolutions of the test: with her printed resistance the
ship would need more.
"""

import math
import sys
import tempfile
import tomllib
from pathlib import Path

from fenderline import Scenario, Simulation, identify
from fenderline._tree import dumps

HERE = Path(__file__).resolve().parent
SCALE = 320.0 / 7.0
#: Mean revolutions of both turns in full scale, as kvlcc2_tracks.py reads them.
FULL_RPM = 91.7
#: MARIN's rudder in full scale.
RUDDER_DEG_PER_S = 2.35
CHOSEN = ["rudder.straightening.below", "rudder.straightening.above", "hull yaw damping"]

TRIAL = """
title = "KVLCC2's model of 7 m turns"
vessel_files = ["test.toml"]
[time]
step = "0.05 s"
duration = "200 s"
[body.ship]
vessel = "kvlcc2-test"
outline = [[3.6, 0], [2, 0.6], [-3, 0.6], [-3.6, 0], [-3, -0.6], [2, -0.6]]
position = [0, 0]
velocity = { surge = 1.18, sway = 0, yaw = 0 }
running = 1
[[order]]
vessel = "ship"
engine = 1
"""

MAPPING = {
    "skip_lines": 3,
    "separator": " ",
    "names": ["time", "x", "y", "roll", "heading", "u", "v", "roll rate", "yaw rate", "rudder", "rpm"],
    "columns": {"time": "time", "north": "x", "east": "y", "heading": "heading"},
    "controls": {"ship.rudder_rad": {"column": "rudder", "unit": "deg", "factor": -1}},
    "repeated": "first",
    "spacing": "4 s",
    "end": "420 s",
    "scale": SCALE,
}


def test_ship() -> str:
    """The file of the model of the library at the revolutions and with the rudder of the tests."""
    own = tomllib.loads((HERE.parents[1] / "vessels" / "kvlcc2.toml").read_text("utf-8"))["vessel"]["kvlcc2-model"]
    own["title"] = "KVLCC2, model of 7 m as tested"
    own["propeller"]["full"] = f"{FULL_RPM * math.sqrt(SCALE):.2f} rpm"
    own["rudder"]["rate"] = f"{RUDDER_DEG_PER_S * math.sqrt(SCALE):.2f} deg/s"
    source = "kvlcc2_tracks.py: MARIN's records of the free-running tests"
    own["source"].append({"of": ["propeller.full", "rudder.rate"], "source": source, "standing": "derived"})
    return dumps({"vessel": {"kvlcc2-test": own}})


def circle(scenario: Scenario, side: float) -> tuple[float, float]:
    """Advance and tactical diameter over the length, from the order at time 0."""
    order = {"at": 0, "vessel": "ship", "rudder": side * math.radians(35.0)}
    simulation = Simulation(Scenario.from_tree(scenario.tree() | {"order": [*scenario.tree()["order"], order]}, folder=Path(scenario.name).parent))
    # The centre of gravity is 0.25 m forward of midship.
    places = []
    while len(places) < 2:
        before = simulation.states[0, :3].tolist()
        simulation.step(1)
        now = simulation.states[0, :3].tolist()
        wanted = math.pi / 2.0 * (1 + len(places))
        if abs(now[2]) >= wanted:
            share = (wanted - abs(before[2])) / (abs(now[2]) - abs(before[2]))
            north, east, heading = (b + share * (n - b) for b, n in zip(before, now, strict=True))
            places.append((north - 0.25 * math.cos(heading) + 0.25, east - 0.25 * math.sin(heading)))
    return places[0][0] / 7.0, abs(places[1][1]) / 7.0


def state_at_start(track: Path) -> dict[str, object]:
    """The keys of the state at the first row of a record, in the scale of the model."""
    row = [float(word) for word in track.read_text("latin-1").splitlines()[3].split()]
    heading, speed = math.radians(row[4]), math.sqrt(SCALE)
    ahead = (math.cos(heading) * row[5] + math.sin(heading) * row[6]) / speed
    aside = (math.cos(heading) * row[6] - math.sin(heading) * row[5]) / speed
    velocity = {"surge": ahead, "sway": aside, "yaw": math.radians(row[8]) * speed}
    # The state is that of the centre of gravity.
    place = [row[1] / SCALE + 0.25 * math.cos(heading), row[2] / SCALE + 0.25 * math.sin(heading)]
    return {"body.ship.position": place, "body.ship.heading": heading, "body.ship.velocity": velocity}


def main(folder: Path, chosen: list[str]) -> None:
    tracks = [folder / "kvlcc2" / f"MARIN_FREE_KVLCC2_tc_{sign}35_m.dat" for sign in ("-", "")]
    with tempfile.TemporaryDirectory() as text:
        own = Path(text)
        (own / "test.toml").write_text(test_ship(), "utf-8")
        (own / "trial.toml").write_text(TRIAL, "utf-8")
        (own / "fitted.toml").write_text(TRIAL.replace("test.toml", "kvlcc2_fitted.toml").replace("kvlcc2-test", "kvlcc2-test-fitted"), "utf-8")
        scenarios = [Scenario.load(own / "trial.toml", state_at_start(track)) for track in tracks]
        found = identify.identify(scenarios, tracks, chosen, mapping=MAPPING, start="scenario", profiles=False)
        print(found.table())
        found.write(own / "kvlcc2_fitted.toml")
        text = (own / "kvlcc2_fitted.toml").read_text("utf-8")
        head = "# KVLCC2's model of 7 m, with coefficients fitted to her free-running turning circles by independent/kvlcc2_fit.py.\n\n"
        (HERE.parent / "kvlcc2_fitted.toml").write_text(head + text, "utf-8")
        for name in ("trial", "fitted"):
            for side, sign in (("starboard", 1.0), ("port", -1.0)):
                advance, diameter = circle(Scenario.load(own / f"{name}.toml"), sign)
                print(f"{name}, {side}: advance {advance:.3f} L, tactical diameter {diameter:.3f} L")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]), sys.argv[2:] or CHOSEN)
