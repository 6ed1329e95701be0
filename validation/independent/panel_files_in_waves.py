"""Files of panel codes, set by set: converted, or refused with the reason, and the ship's simulated motion in regular waves against the panel code's.

    python3 validation/independent/panel_files_in_waves.py FOLDER PROGRAM [--only WORD] [--waves 4] [--pictures FOLDER] [--no-runs]

FOLDER is looked through for sets: WAMIT (STEM.1 with STEM.3), HAMS (Input/ControlFile.in), Nemoh (Nemoh.cal), AQWA (.AH1, .LIS) and Capytaine
(.nc). PROGRAM is the program `fenderline`. Each body of a set with several is a row. A set whose headings do not cover is tried
again as a hull that is alike to both sides, fore and aft, and as one of revolution; the row says so.

The reference is the panel code's own motion (`.4` of WAMIT, where STEM.frc has the radii of gyration), else the frequency-domain equation with the coefficients as they are in the file, before
anything was cut or repaired. The simulation runs in small regular waves until they have passed 100 times, and the last 70 periods are
weighted by the square of Hann's window, so that free oscillations, which hardly fade in a semi-submersible, do not count. Frequencies are the file's own,
where heave or pitch is above 2 % of the wave (pitch: of its slope).

No file of a panel code is in this repository. It needs NumPy, for Capytaine xarray and h5netcdf, for pictures Matplotlib.
"""

import argparse
import csv
import math
import re
import subprocess
import tempfile
import warnings
from pathlib import Path

import numpy as np
import panel_files

SIGNS = panel_files.SIGNS
MIRROR = panel_files.MIRROR
#: Periods of a run, those that are weighed, and steps in one.
PERIODS, WEIGHED, STEPS = 100, 70, 40
#: The step over the inverse of the last frequency of the data, for the memory of the water to be resolved.
RESOLVED = 0.8
#: The longest waves: wave number times the cube root of the displacement.
LONGEST = 0.02
#: The periods that a scenario may have (s).
PERIODS_S = (1.0, 40.0)
#: What counts, over the wave's amplitude or slope.
COUNTS = 0.02
#: A resonance without damping, which a run does not settle: this share of the restoring changes the motion by more than the second number.
RESONANCE = (0.005, 0.02)
#: What the damping added in STEM.frc may change.
DAMPED = 0.003


def sets_in(folder):
    """Name, converter and its arguments of each set."""
    for path in sorted(folder.rglob("*")):
        name, end = path.relative_to(folder), path.suffix.lower()
        if end == ".1" and path.parent.name.lower() != "wamit_format":
            yield str(name), "wamit", path.with_suffix("") if path.with_suffix(".3").is_file() else path
        elif path.name.lower() == "controlfile.in":
            case = path.parent.parent
            for output in sorted(case.glob("Output*")):
                if list(output.glob("Wamit_format/*.1")):
                    yield f"{case.relative_to(folder)} {output.name}", "hams", (case, output.name)
        elif path.name.lower() == "nemoh.cal":
            yield str(name.parent), "nemoh", path.parent
        elif end in (".ah1", ".lis"):
            yield str(name), "aqwa", path
        elif end == ".nc":
            yield str(name), "capytaine", path


def numbers_of(frc):
    """The rows of a file of WAMIT that are numbers."""
    rows = []
    for line in frc.read_text(errors="replace").splitlines():
        try:
            rows.append([float(cell) for cell in line.split()])
        except ValueError:
            continue
    return rows


def radii_of(stem):
    """Radii of gyration of STEM.frc: as they stand there, or by its mass matrix; `None` without it."""
    frc = Path(f"{stem}.frc")
    if not frc.is_file():
        return None
    rows = numbers_of(frc)
    mass = np.array([row for row in rows if len(row) == 6][:6])
    if len(mass) == 6 and mass[0, 0] > 0:
        x, z = -mass[2, 4] / mass[0, 0], mass[0, 4] / mass[0, 0]
        squared = mass[3, 3] / mass[0, 0] - z * z, mass[4, 4] / mass[0, 0] - x * x - z * z, mass[5, 5] / mass[0, 0] - x * x
        return tuple(math.sqrt(value) for value in squared) if min(squared) > 0 else None
    own = [row for row in rows if len(row) == 3]
    if len(own) >= 3 and all(own[k][k] > 0 for k in range(3)):
        return tuple(own[k][k] for k in range(3))
    return None


def damping_of(stem):
    """The damping that STEM.frc adds, in the axes of the file; zero without it. A scenario has no such damping."""
    rows = [row for row in numbers_of(Path(f"{stem}.frc")) if len(row) == 6]
    return np.array(rows[6:12]) * np.outer(SIGNS, SIGNS) if len(rows) >= 12 else np.zeros((6, 6))


def convert(code, kind, where, body, symmetry):
    also = {"body": body, "symmetry": symmetry}
    if kind == "wamit":
        radii = radii_of(where)
        return code.from_wamit(where, gyradii_m=radii or supposed(where), **also)
    if kind == "hams":
        return code.from_hams(where[0], output=where[1], **also)
    if kind == "nemoh":
        return code.from_nemoh(where, gyradii_m=supposed(where), **also)
    if kind == "aqwa":
        return code.from_aqwa(where, **also)
    try:
        return code.from_capytaine(where, gravity_above_water_m=centre_of(where, body), **also)
    except code.HydrodynamicsError as error:
        if "gyradii_m" not in str(error):
            raise
        return code.from_capytaine(where, gravity_above_water_m=centre_of(where, body), gyradii_m=supposed(where), **also)


def supposed(where):
    """Radii of gyration where the files have none: 0.5 of the cube root of the displacement. They are the same in the reference."""
    volumes = []
    folders = [where] if where.is_dir() else [where.parent]
    for path in (file for folder in folders for file in folder.rglob("*ydrostatics*.dat")):
        found = re.search(r"Displacement\s*=\s*(\S+)", path.read_text(errors="replace"))
        volumes += [float(found[1])] if found else []
    listing = Path(f"{where}.out")
    if listing.is_file():
        found = re.search(r"Volumes \(VOLX,VOLY,VOLZ\):\s+(\S+)", listing.read_text(errors="replace"))
        volumes += [float(found[1])] if found else []
    return (0.5 * max(volumes, default=1000.0) ** (1 / 3),) * 3


def centre_of(path, body):
    """The height of the centre of gravity in the dataset, else that of the file Hydrostatics.dat beside it, else the waterline."""
    import xarray

    with xarray.open_dataset(path) as data:
        if "center_of_mass" in data:
            values = np.atleast_2d(data["center_of_mass"].values)
            return float(values[(body or 1) - 1][2])
    for name in ("Hydrostatics.dat", f"Hydrostatics_{(body or 1) - 1}.dat"):
        if (path.parent / name).is_file():
            # The third line is that of z, whatever it is called.
            return float((path.parent / name).read_text().splitlines()[2].rsplit("=", 1)[1])
    return 0.0


def converted(code, kind, where):
    """Each body: the number, the symmetry that it took, and the data or the reason."""
    bodies = [None]
    try:
        convert(code, kind, where, None, None)
    except code.HydrodynamicsError as error:
        found = re.search(r"has (\d+) (?:bodies|structures)", str(error))
        bodies = list(range(1, int(found[1]) + 1)) if found else [None]
    for body in bodies:
        first = None
        for symmetry in (None, "sides", "fore and aft", "revolution"):
            try:
                data = convert(code, kind, where, body, symmetry)
            except code.HydrodynamicsError as error:
                first = first or (body, None, str(error))
                if symmetry is None:
                    break
                continue
            if not data.problems:
                first = body, symmetry, data
                break
            first = first or (body, None, "; ".join(data.problems))
            if not re.search("headings|symmetry", "; ".join(data.problems)):
                break
        yield first


def own_motions(kind, where, data):
    """The panel code's own motions by frequency and heading, in the axes of the file, or `None`."""
    if kind != "wamit" or radii_of(where) is None or not Path(f"{where}.4").is_file():
        return None
    motions = {}
    for line in Path(f"{where}.4").read_text(errors="replace").splitlines():
        try:
            period, beta, mode, _, _, real, imaginary = (float(cell) for cell in line.split())
        except ValueError:
            continue
        if period > 0 and 0 <= beta <= 180:
            row = motions.setdefault((2 * math.pi / period, beta), np.zeros(6, complex))
            row[int(mode) - 1] = complex(real, imaginary)
    return {key: own * SIGNS * (MIRROR if 0 < key[1] < 180 else 1) for key, own in motions.items()}


def raw_motion(data, row, heading):
    """The frequency-domain equation with the coefficients before anything was cut or repaired."""
    panel = data.before
    at = int(np.argmin(np.abs(panel.wave_omega - panel.omega[row])))
    column = int(np.argmin(np.abs(panel.headings_deg - heading)))
    w = float(panel.omega[row])
    forward, starboard, up = data.reference_m
    mass = np.diag([data.mass_kg] * 3 + [data.mass_kg * k * k for k in data.gyradii_m])
    lever = np.eye(6)
    lever[0, 4], lever[0, 5], lever[1, 3], lever[1, 5] = up, starboard, -up, -forward
    lever[2, 3], lever[2, 4] = -starboard, forward
    stiffness = np.zeros((6, 6))
    stiffness[2:5, 2:5] = data.restoring
    left = -(w**2) * (lever.T @ mass @ lever + panel.added[row]) + 1j * w * panel.damping[row] + stiffness
    return np.linalg.solve(left, panel.force[at, column])


def full_restoring(data):
    matrix = np.zeros((6, 6))
    matrix[2:5, 2:5] = data.restoring
    return matrix


def cases(code, kind, where, data, count):
    """Frequency, heading and expected motion, spread over the frequencies at which heave or pitch counts."""
    own = own_motions(kind, where, data)
    panel = data.before
    headings = [heading for heading in (0.0, 45.0, 50.0, 60.0, 180.0) if (np.abs(panel.headings_deg - heading) < 0.01).any()]
    headings = [headings[0], headings[len(headings) // 2], headings[-1]] if headings else [float(panel.headings_deg[0])]
    known = sorted(w for w in data.damping if 0 < w < math.inf)
    found, left = [], 0
    for row, w in enumerate(panel.omega):
        if not any(abs(w - other) < 1e-6 * w for other in known) or not np.isfinite(panel.damping[row]).all():
            continue
        if any(abs(repair.omega_radps - w) < 1e-6 * w for repair in data.repairs):
            continue
        if not PERIODS_S[0] <= 2 * math.pi / w <= PERIODS_S[1]:
            continue
        slope = code._waves.wave_number_radpm(float(w), panel.depth_m, panel.gravity_mps2)
        if slope * (data.mass_kg / data.water_kgpm3) ** (1 / 3) < LONGEST:
            continue
        for heading in dict.fromkeys(headings):
            if own is None:
                motion = raw_motion(data, row, heading)
            else:
                near = min(own, key=lambda key: (abs(key[1] - heading), abs(key[0] - w)))
                if abs(near[0] - w) > 1e-3 * w or abs(near[1] - heading) > 0.01:
                    continue
                motion = own[near]
                # What the added damping changes is not compared.
                added = damping_of(where)
                alone, damped = data.motion(w, heading), data.motion(w, heading, damping=added)
                motion = np.where(np.abs(np.abs(damped) - np.abs(alone)) < DAMPED * np.abs(damped), motion, 0.0)
            near = data.motion(w, heading, restoring=RESONANCE[0] * full_restoring(data))
            still = np.abs(near - data.motion(w, heading)) < RESONANCE[1] * np.abs(near)
            motion = np.where(still, motion, 0.0)
            left += not (still[2] and still[4])
            if np.isfinite(motion).all() and (abs(motion[2]) > COUNTS or abs(motion[4]) > COUNTS * slope):
                found.append((float(w), heading, motion, slope))
    omegas = sorted({case[0] for case in found})
    chosen = {omegas[round(k * (len(omegas) - 1) / max(1, count - 1))] for k in range(count)} if omegas else set()
    by = "its own motions" if own else "its coefficients"
    return [case for case in found if case[0] in chosen], by + (f" ({left} waves at a resonance without damping left out)" if left else "")


def simulated(program, folder, data, w, heading):
    """Amplitudes of heave (m) and pitch (rad) of the reference point in a wave of 1 m, and how far two windows differ."""
    size = (data.mass_kg / data.water_kgpm3) ** (1 / 3)
    length, beam, draught = 6 * size, size, size / 3.6
    # Small, for nothing holds her: in a large oblique wave she would turn out of her heading within the run.
    amplitude = 2e-5 * size * min(1.0, 9.81 / (w * w * size))
    period = 2 * math.pi / w
    depth = data.depth_m if math.isfinite(data.depth_m) else 3000.0
    half = length / 2, beam / 2
    step = min(period / STEPS, RESOLVED / max(own for own in data.damping if own < math.inf))
    (folder / "case.toml").write_text(f"""
[time]
step = {step:.9g}
duration = {PERIODS * period:.9g}
[environment]
depth = {depth:.9g}
water_density = {data.water_kgpm3:.9g}
waves = {{ height = {2 * amplitude:.9g}, period = {period:.9g}, from = "{(180 - heading) % 360:g} deg", regular = true }}
[vessel.t]
length_bp = {length:.9g}
beam = {beam:.9g}
draught = {draught:.9g}
block_coefficient = {data.mass_kg / data.water_kgpm3 / (length * beam * draught):.6g}
gyradius = {data.gyradii_m[2]:.6g}
hydrodynamics = "case.hydro"
[body.ship]
vessel = "t"
outline = [[{-half[0]}, {-half[1]}], [{half[0]}, {-half[1]}], [{half[0]}, {half[1]}], [{-half[0]}, {half[1]}]]
""")
    done = subprocess.run([program, "run", "case.toml", "--out", "out"], cwd=folder, capture_output=True, text=True, timeout=600)
    if done.returncode not in (0, 1) or not (folder / "out/vessels.csv").is_file():
        return (done.stderr or done.stdout).strip()[:600]
    rows = list(csv.DictReader((folder / "out/vessels.csv").open()))
    (folder / "out/vessels.csv").unlink()
    t = np.array([float(row["t_s"]) for row in rows])
    heave, pitch = (np.array([float(row[name]) for row in rows]) for name in ("heave_m", "pitch_rad"))
    heave = heave - data.reference_m[0] * pitch

    def at(end):
        start = end - 0.8 * WEIGHED * period
        own = (t >= start) & (t <= end)
        weight = np.sin(math.pi * (t[own] - start) / (end - start)) ** 4
        waves = np.exp(-1j * w * t[own])
        return [2 * abs(np.sum(weight * (x[own] - np.average(x[own], weights=weight)) * waves)) / weight.sum() / amplitude for x in (heave, pitch)]

    return at(t[-1] - 0.2 * WEIGHED * period), at(t[-1])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=Path)
    parser.add_argument("program", type=lambda text: str(Path(text).resolve()))
    parser.add_argument("--only", default="")
    parser.add_argument("--waves", type=int, default=4)
    parser.add_argument("--pictures", type=Path)
    parser.add_argument("--no-runs", action="store_true")
    given = parser.parse_args()
    code = panel_files.converters()
    import fenderline.hydrodynamics._waves  # noqa: F401, PLC0415

    warnings.simplefilter("ignore", code.HydrodynamicsWarning)
    for name, kind, where in sets_in(given.folder):
        if given.only.lower() not in name.lower():
            continue
        for body, symmetry, data in converted(code, kind, where):
            label = f"{name} ({kind}{'' if body is None else f', body {body}'})"
            if isinstance(data, str):
                print(f"{label}: refused: {data}", flush=True)
                continue
            print(f"{label}: converted{f', symmetry = {symmetry!r}' if symmetry else ''}")
            for note in data.notes:
                print(f"    {note}")
            if given.pictures:
                given.pictures.mkdir(parents=True, exist_ok=True)
                data.picture(given.pictures / (re.sub(r"\W+", "_", label) + ".png"))
            if given.no_runs:
                continue
            chosen, by = cases(code, kind, where, data, given.waves)
            worst, count = {2: None, 4: None}, 0
            with tempfile.TemporaryDirectory() as scratch:
                data.write(Path(scratch) / "case.hydro")
                for w, heading, motion, slope in chosen:
                    found = simulated(given.program, Path(scratch), data, w, heading)
                    if isinstance(found, str):
                        print(f"    run at {w:.4g} rad/s: {found}")
                        break
                    before, after = found
                    count += 1
                    for at, k, scale in ((0, 2, 1.0), (1, 4, slope)):
                        expected = abs(motion[k])
                        if expected > COUNTS * scale:
                            off = after[at] / expected - 1
                            moved = abs(after[at] - before[at]) / expected
                            if worst[k] is None or abs(off) > abs(worst[k][0]):
                                worst[k] = off, w, heading, expected / scale, moved
            print(f"    {count} runs against {by}", end="")
            for k, what in ((2, "heave"), (4, "pitch")):
                if worst[k]:
                    off, w, heading, share, moved = worst[k]
                    print(f"; {what} {100 * off:+.2f} % at most ({w:.3g} rad/s, {heading:g}°, {share:.2g} of the wave; windows {100 * moved:.2f} %)", end="")
            print(flush=True)


if __name__ == "__main__":
    main()
