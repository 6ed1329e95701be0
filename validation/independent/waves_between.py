"""Motions of free hulls in waves between the headings and frequencies of the shipped data, by panel runs at the very heading and frequency.

    python3 validation/independent/waves_between.py panels [CASE...]
    python3 validation/independent/waves_between.py moored PROGRAM FOLDER

`panels` needs what hydrodynamics/capytaine_hulls.py needs. For each file of hydrodynamics/ it draws five frequencies and five headings that are not
in the file (seeded), runs Capytaine there, solves (−ω²(M + A) + iωB + C) ξ = F with 5 % of the critical damping in roll, and writes
validation/independent/waves_between.csv: complex amplitudes over that of the wave. crates/scenario/tests/waves_between.rs moves the hulls by the shipped
files in the same waves and compares.

`moored` makes data of the ship in 20 m of water with half the steps of heading and frequency in FOLDER, runs
scenarios/berth/moored_in_waves.toml for an hour in a sea of 1.5 m from 225 degrees with them and with the shipped data by PROGRAM (`fenderline`), and prints the
standard deviations of the six motions.
"""

import csv
import importlib.util
import math
import random
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TABLE = Path(__file__).with_suffix(".csv")
MOTIONS = ["surge", "sway", "heave", "roll", "pitch", "yaw"]
SEED = 36
# Beyond this kLΔμ the reader tells that the headings do not resolve a wave: in open water, and with headings all round.
RESOLVED = (4.0, 3.0)


def module(path):
    spec = importlib.util.spec_from_file_location(path.stem, path)
    loaded = importlib.util.module_from_spec(spec)
    sys.modules[path.stem] = loaded
    spec.loader.exec_module(loaded)
    return loaded


def hulls():
    return module(ROOT / "hydrodynamics/capytaine_hulls.py")


def wave_number(omega, depth):
    number = omega**2 / 9.81
    for _ in range(100):
        tanh = math.tanh(number * depth)
        slope = 9.81 * (tanh + number * depth * (1 - tanh**2))
        number -= (9.81 * number * tanh - omega**2) / slope
    return number


def drawn(name, case):
    """Five frequencies and five headings (degrees, clockwise from the bow), one from each fifth of the range."""
    draw = random.Random(f"{SEED} {name}")
    omegas, length = case["omegas"], case["size"]["length"]
    step = math.radians(360 / len(case["headings"]) if case["wall"] else 180 / (len(case["headings"]) - 1))
    last = max(w for w in omegas if wave_number(w, case["depth"]) * length * step <= RESOLVED[case["wall"] is not None])
    first = omegas[0]
    frequencies = [round(first + (k + draw.random()) / 5 * (last - first), 3) for k in range(5)]
    low, high = (-180, 180) if case["wall"] else (0, 180)
    headings = [round(low + (k + draw.random()) / 5 * (high - low), 1) for k in range(5)]
    return frequencies, headings


def motions(hulls, name):
    """Rows of the table."""
    import numpy as np

    case = hulls.CASES[name]
    frequencies, headings = drawn(name, case)
    data, *_, volume, _ = hulls.solve(name, [*frequencies, np.inf], np.radians([-heading for heading in headings]), drifts=False)
    mass, size = hulls.WATER_KGPM3 * volume, case["size"]
    ship = hulls.converters().from_capytaine(
        data, gravity_above_water_m=0.0, gyradii_m=size["gyradii"], mass_kg=mass, fold=False, source=name
    )
    inertia = np.diag([mass] * 3 + [mass * gyradius**2 for gyradius in size["gyradii"]])
    restoring = np.zeros((6, 6))
    restoring[2:5, 2:5] = ship.restoring
    for (omega, heading), force in sorted(ship.excitation.items()):
        added, damping = np.array(ship.added_mass[omega]), np.array(ship.damping[omega])
        # The share of the critical damping as the program takes it: with the added mass at infinite frequency.
        critical = 2 * math.sqrt(restoring[3, 3] * (inertia[3, 3] + np.array(ship.added_mass[math.inf])[3, 3]))
        damping[3, 3] += hulls.ROLL_DAMPING * critical
        left = -(omega**2) * (inertia + added) + 1j * omega * damping + restoring
        motion = np.linalg.solve(left, np.array(force))
        yield [name, f"{omega:.3f}", f"{heading:.1f}", *(f"{part:.5g}" for z in motion for part in (z.real, z.imag))]


def panels(names):
    """Computes the rows of some cases, or of all, and keeps the others."""
    loaded = hulls()
    rows = {}
    if TABLE.exists():
        for row in list(csv.reader(TABLE.open(encoding="utf-8")))[1:]:
            rows.setdefault(row[0], []).append(row)
    for name in names or loaded.CASES:
        rows[name] = list(motions(loaded, name))
        with TABLE.open("w", newline="", encoding="utf-8") as file:
            table = csv.writer(file, lineterminator="\n")
            table.writerow(["data", "omega_radps", "heading_deg", *(f"{part}_{motion}" for motion in MOTIONS for part in ("re", "im"))])
            table.writerows(row for case in loaded.CASES for row in rows.get(case, []))
        print(name, flush=True)


def moored(program, folder):
    import numpy as np

    loaded = hulls()
    folder = Path(folder).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    case = loaded.CASES["ship_20m"]
    omegas, headings = case["omegas"], case["headings"]
    half = lambda axis: np.sort(np.concatenate([axis, 0.5 * (axis[1:] + axis[:-1])]))
    loaded.CASES["ship_20m"] = case | {"omegas": half(omegas), "headings": half(headings)}
    loaded.run("ship_20m", folder)
    scenario = (ROOT / "scenarios/berth/moored_in_waves.toml").read_text(encoding="utf-8")
    scenario = scenario.replace('duration = "10 h"', 'duration = "1 h"').replace('interval = "10 s"', 'interval = "1 s"')
    sea = 'waves = { height = "1.5 m", period = "10 s", from = "225 deg", seed = 5 }'
    scenario = scenario.replace('waves = { height = "0.8 m", period = "10 s", from = "200 deg", seed = 5 }', sea)
    (folder / "long_waves.csv").write_bytes((ROOT / "scenarios/berth/long_waves.csv").read_bytes())
    found = {}
    for label, data in [("shipped", ROOT / "hydrodynamics/ship_20m.hydro"), ("half", folder / "ship_20m.hydro")]:
        (folder / f"{label}.hydro").write_bytes(data.read_bytes())
        path = folder / f"{label}.toml"
        path.write_text(scenario.replace("container_ship_20m.hydro", f"{label}.hydro"), encoding="utf-8")
        subprocess.run([program, "run", path, "--out", folder / label], check=True)
        columns = {}
        for table in ["bodies", "vessels"]:
            with (folder / label / f"{table}.csv").open(encoding="utf-8") as file:
                lines = csv.reader(line for line in file if not line.startswith("#"))
                names = next(lines)
                for row in lines:
                    values = dict(zip(names, row))
                    for key in ["x", "y", "heading", "heave", "roll", "pitch"]:
                        for name, value in values.items():
                            if name.split("_")[0].split(" ")[0] == key and values.get("body", "ship") in ("ship", ""):
                                columns.setdefault(key, []).append(float(value))
        found[label] = {key: np.std(values) for key, values in columns.items()}
    for key, size in found["half"].items():
        print(f"{key}: {found['shipped'][key]:.4g} with the shipped data, {size:.4g} with half the steps: {100 * (found['shipped'][key] / size - 1):+.2f} %")


if __name__ == "__main__":
    if sys.argv[1:2] == ["panels"]:
        panels(sys.argv[2:])
    elif len(sys.argv) == 4 and sys.argv[1] == "moored":
        moored(*sys.argv[2:])
    else:
        sys.exit(__doc__)
