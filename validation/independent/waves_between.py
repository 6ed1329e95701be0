"""Motions of free hulls in waves between the headings and frequencies of the shipped data, by panel runs at the very heading and frequency.

    python3 validation/independent/waves_between.py [CASE...]

It needs what hydrodynamics/capytaine_hulls.py needs. For each file of hydrodynamics/ it draws five frequencies and five headings that are not
in the file and that it resolves (seeded), runs Capytaine there, solves (−ω²(M + A) + iωB + C) ξ = F with 5 % of the critical damping in roll, and writes
validation/independent/waves_between.csv: complex amplitudes over that of the wave, and in open water the mean drift over the square of it (N/m², and N/m
in yaw). crates/scenario/tests/waves_between.rs moves the hulls by the shipped files in the same waves and compares.
"""

import csv
import importlib.util
import math
import random
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TABLE = Path(__file__).with_suffix(".csv")
MOTIONS = ["surge", "sway", "heave", "roll", "pitch", "yaw"]
DRIFT = ["drift_surge", "drift_sway", "drift_yaw"]
SEED = 36
# Beyond this kLΔμ the reader tells that the headings do not resolve a wave: in open water, and with headings all round.
RESOLVED = (4.0, 3.0)
# Beyond this LΔk it tells that the frequencies do not.
RESOLVED_STEP = 2.5


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
    numbers = [wave_number(w, case["depth"]) for w in omegas]
    steps = [0.0] + [(after - before) * length for before, after in zip(numbers, numbers[1:])]
    # Rows are of waves that the data resolve, by the reader's two criteria.
    too_coarse = [n for n in range(len(omegas)) if numbers[n] * length * step > RESOLVED[case["wall"] is not None] or steps[n] > RESOLVED_STEP]
    last = omegas[min(too_coarse, default=len(omegas)) - 1]
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
    data, *_, volume, _ = hulls.solve(name, [*frequencies, np.inf], np.radians([-heading % 360 for heading in headings]))
    mass, size = hulls.WATER_KGPM3 * volume, case["size"]
    ship = hulls.converters().from_capytaine(
        data, gravity_above_water_m=0.0, gyradii_m=size["gyradii"], mass_kg=mass, fold=False, source=name
    )
    inertia = np.diag([mass] * 3 + [mass * gyradius**2 for gyradius in size["gyradii"]])
    restoring = np.zeros((6, 6))
    restoring[2:5, 2:5] = ship.restoring
    # Couplings of the hull, as the file has them: others are rounding.
    matters = sys.modules["fenderline.hydrodynamics._data"]._matters
    tables = [list(ship.added_mass.values()), [table for omega, table in ship.damping.items() if math.isfinite(omega)]]
    coupled = np.array([[any(matters(i, j, table) for table in tables) for j in range(6)] for i in range(6)])
    for (omega, heading), force in sorted(ship.excitation.items()):
        # Symmetric, as radiation is and as the file has them: on a mesh sway by roll and roll by sway differ.
        added, damping = (0.5 * coupled * (np.array(table[omega]) + np.array(table[omega]).T) for table in (ship.added_mass, ship.damping))
        # The share of the critical damping as the program takes it: with the added mass at infinite frequency.
        critical = 2 * math.sqrt(restoring[3, 3] * (inertia[3, 3] + np.array(ship.added_mass[math.inf])[3, 3]))
        damping[3, 3] += hulls.ROLL_DAMPING * critical
        left = -(omega**2) * (inertia + added) + 1j * omega * damping + restoring
        motion = np.linalg.solve(left, np.array(force))
        drift = [f"{part:.5g}" for part in ship.drift[omega, heading]] if ship.drift else [""] * 3
        yield [name, f"{omega:.3f}", f"{heading:.1f}", *(f"{part:.5g}" for z in motion for part in (z.real, z.imag)), *drift]


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
            table.writerow(["data", "omega_radps", "heading_deg", *(f"{part}_{motion}" for motion in MOTIONS for part in ("re", "im")), *DRIFT])
            table.writerows(row for case in loaded.CASES for row in rows.get(case, []))
        print(name, flush=True)


if __name__ == "__main__":
    panels(sys.argv[1:])
