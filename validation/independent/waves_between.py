"""Motions of free hulls in waves between the headings and frequencies of the shipped data, by panel runs at the very heading and frequency.

    python3 validation/independent/waves_between.py [CASE...]
    python3 validation/independent/waves_between.py --by-files [CASE...]
    python3 validation/independent/waves_between.py --finer [CASE...]

It needs what hydrodynamics/capytaine_hulls.py needs. For each file of hydrodynamics/ it draws five frequencies and five headings that are not
in the file and that it resolves (seeded), runs Capytaine there, solves (−ω²(M + A) + iωB + C) ξ = F with 5 % of the critical damping in roll, and writes
validation/independent/waves_between.csv: complex amplitudes over that of the wave, and in open water the mean drift over the square of it (N/m², and N/m
in yaw). crates/scenario/tests/waves_between.rs moves the hulls by the shipped files in the same waves and compares.

With `--by-files` nothing is run or written. The equation is solved at the rows of the table with added mass, damping and forces of the shipped files, by splines
between their frequencies and headings. For each file the worst vector error of a motion above 2 % of the wave is printed: what is left when the program's
memory of the water has no part in it. For each frequency the smallest singular value of the equation is printed, in units of ω² times her mass with added
mass at infinite frequency: to how much mass, restoring and damping cancel.

With `--finer` nothing is written. The rows of the table are computed again with panels of about three quarters of the length, and compared with the table: how
far the panel runs themselves are off, in each motion above 2 % of the wave.
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


def by_files(names):
    """Prints the worst errors of a linear solve with the shipped files."""
    import numpy as np
    from scipy.interpolate import CubicSpline

    loaded = hulls()
    loaded.converters()
    from fenderline import hydrodynamics

    rows = list(csv.reader(TABLE.open(encoding="utf-8")))[1:]
    mirrored = np.array([1, -1, 1, -1, 1, -1])
    for name in names or loaded.CASES:
        ship = hydrodynamics.read(ROOT / "hydrodynamics" / f"{name}.hydro")
        inertia = np.diag([ship.mass_kg] * 3 + [ship.mass_kg * gyradius**2 for gyradius in ship.gyradii_m])
        restoring = np.zeros((6, 6))
        restoring[2:5, 2:5] = ship.restoring
        total = np.diag(inertia + np.array(ship.added_mass[math.inf]))
        omegas = sorted(omega for omega in ship.added_mass if math.isfinite(omega))
        added, damping = (CubicSpline(omegas, [table[omega] for omega in omegas]) for table in (ship.added_mass, ship.damping))
        waves = sorted({omega for omega, _ in ship.excitation})
        headings = sorted({heading for _, heading in ship.excitation})
        forces = CubicSpline(waves, [[ship.excitation[omega, heading] for heading in headings] for omega in waves])
        is_half = headings[0] == 0
        all_headings = [-heading for heading in headings[:0:-1]] + headings if is_half else [*headings, headings[0] + 360]
        arms = [1, 1, 1, 10, 40, 40] if name.startswith("barge") else [1, 1, 1, 23, 142.5, 142.5]
        worst, least = (0.0, ""), {}
        for row in (row for row in rows if row[0] == name):
            omega, heading = float(row[1]), float(row[2])
            of_headings = forces(omega)
            turned = np.vstack([of_headings[:0:-1] * mirrored, of_headings] if is_half else [of_headings, of_headings[:1]])
            turned[-1] = turned[0]
            force = CubicSpline(all_headings, turned, bc_type="periodic")(heading)
            b = damping(omega)
            b[3, 3] += loaded.ROLL_DAMPING * 2 * math.sqrt(restoring[3, 3] * total[3])
            left = -(omega**2) * (inertia + added(omega)) + 1j * omega * b + restoring
            least[omega] = np.linalg.svd(left / np.sqrt(np.outer(total, total)) / omega**2, compute_uv=False)[-1]
            motion = np.linalg.solve(left, force)
            for k, arm in enumerate(arms):
                wanted = complex(float(row[3 + 2 * k]), float(row[4 + 2 * k]))
                if abs(wanted) * arm > 0.02:
                    worst = max(worst, (abs(motion[k] - wanted) / abs(wanted), f"{MOTIONS[k]}, {omega} rad/s, {heading}°"))
        print(f"{name}: at most {100 * worst[0]:.1f} % ({worst[1]}); mass, restoring and damping cancel to", end=" ")
        print(", ".join(f"{100 * value:.0f} % at {omega} rad/s" for omega, value in least.items()), flush=True)


# Panels of the finer hulls: along, across and down; along and around half a section.
FINER_BARGE, FINER_SHIP, FINER_SHIP_AT_WALL = (32, 14, 8), (48, 12), (36, 9)


def finer_hull(loaded, name):
    """The hull of a case with panels of about three quarters of the length."""
    if name.startswith("barge"):
        return lambda: loaded.box(80.0, 20.0, 5.0, FINER_BARGE)
    counts = FINER_SHIP_AT_WALL if loaded.CASES[name]["wall"] else FINER_SHIP
    return lambda: loaded.ship(285.0, 46.0, 9.0, loaded.SHIP_BLOCK, loaded.SHIP_WATERPLANE, counts)


def finer(names):
    """Prints by how much the panel runs change with finer panels."""
    loaded = hulls()
    rows = {(row[0], row[1], row[2]): row for row in list(csv.reader(TABLE.open(encoding="utf-8")))[1:]}
    for name in names or loaded.CASES:
        loaded.CASES[name] |= {"hull": finer_hull(loaded, name)}
        arms = [1, 1, 1, 10, 40, 40] if name.startswith("barge") else [1, 1, 1, 23, 142.5, 142.5]
        worst, count, above = (0.0, ""), 0, 0
        for row in motions(loaded, name):
            before = rows[row[0], row[1], row[2]]
            changes = []
            for k, arm in enumerate(arms):
                was, now = (complex(float(of[3 + 2 * k]), float(of[4 + 2 * k])) for of in (before, row))
                if abs(was) * arm > 0.02:
                    changes.append((abs(now - was) / abs(was), f"{MOTIONS[k]}, {row[1]} rad/s, {row[2]}°"))
            worst = max([worst, *changes])
            count, above = count + 1, above + any(change > 0.02 for change, _ in changes)
        print(f"{name}: with finer panels {above} of {count} rows change by more than 2 %, at most by {100 * worst[0]:.1f} % ({worst[1]})", flush=True)


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
    if sys.argv[1:2] == ["--by-files"]:
        by_files(sys.argv[2:])
    elif sys.argv[1:2] == ["--finer"]:
        finer(sys.argv[2:])
    else:
        panels(sys.argv[1:])
