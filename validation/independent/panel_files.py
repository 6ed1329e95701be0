"""What `fenderline.hydrodynamics` makes of files of a panel code, against the motions that the code itself wrote.

    python3 validation/independent/panel_files.py STEM ROLL PITCH YAW [FORWARD STARBOARD UP]    # WAMIT: STEM.1, .3, .hst, .out and .4
    python3 validation/independent/panel_files.py FILE.LIS                        # AQWA: the listing, and FILE.AH1 if that is beside it
    python3 validation/independent/panel_files.py CASE OUTPUT                     # HAMS: the folder of a case, and that of its output in it
    python3 validation/independent/panel_files.py                                 # the files of this repository, by Haskind's relation

ROLL, PITCH and YAW are the radii of gyration (m) that the code had. The motions are by the frequency-domain equation with the data that were converted, so
what is compared is the reading: signs, axes, phases, units, the first column. Prints the notes, and the largest difference of heave and pitch, as complex numbers,
where the motion is above 5 % of its maximum. A damping matrix in STEM.frc is added.

No file of a panel code is in this repository. It needs NumPy.
"""

import importlib
import math
import re
import sys
import types
import warnings
from dataclasses import replace
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
SIGNS = np.array([1, -1, -1, 1, -1, -1])
MIRROR = np.array([1, -1, 1, -1, 1, -1])


def converters():
    """The package without its compiled part."""
    package = types.ModuleType("fenderline")
    package.__path__ = [str(ROOT / "crates/python/python/fenderline")]
    sys.modules.setdefault("fenderline", package)
    return importlib.import_module("fenderline.hydrodynamics")


def differences(data, motions, damping=None, restoring=None):
    """The largest difference of heave and pitch over the code's own, with its place. `motions` are in the axes of panel codes."""
    worst = {2: (0.0,), 4: (0.0,)}
    most = np.max([np.abs(own) for own in motions.values()], axis=0)
    count = 0
    for (omega, heading), own in motions.items():
        near = min(data.damping, key=lambda w: abs(w - omega))
        if abs(near - omega) > 2.5e-3 * omega or not -180.0 <= heading <= 180.0:
            continue
        folded = abs(heading)
        expected = own * SIGNS * (MIRROR if 0.0 < heading < 180.0 else 1)
        found = data.motion(near, folded, damping=damping, restoring=restoring)
        count += 1
        for k in (2, 4):
            if abs(expected[k]) > 0.05 * most[k]:
                off = abs(found[k] - expected[k]) / abs(expected[k])
                worst[k] = max(worst[k], (off, near, heading, abs(expected[k])))
    print(f"{count} frequencies and headings")
    for k, name in ((2, "heave"), (4, "pitch")):
        if len(worst[k]) > 1:
            off, omega, heading, size = worst[k]
            print(f"{name}: {100 * off:.2f} % at most, at {omega:.3f} rad/s and {heading:g}°, where it is {size:.3g} {'m' if k == 2 else 'rad'}")


def wamit(hydrodynamics, stem, radii, reference):
    data = hydrodynamics.from_wamit(stem, gyradii_m=tuple(radii), reference_m=tuple(reference) if reference else None)
    print("\n".join(data.notes + [f"refused: {problem}" for problem in data.problems]))
    motions = {}
    for line in Path(f"{stem}.4").read_text(encoding="utf-8", errors="replace").splitlines():
        try:
            period, beta, mode, _, _, real, imaginary = (float(cell) for cell in line.split())
        except ValueError:
            continue
        if period > 0:
            motions.setdefault((2 * math.pi / period, beta), np.zeros(6, complex))[int(mode) - 1] = complex(real, imaginary)
    damping = None
    frc = Path(f"{stem}.frc")
    if frc.is_file():
        rows = [line.split() for line in frc.read_text().splitlines() if len(line.split()) == 6]
        if len(rows) >= 12:
            damping = np.array([[float(cell) for cell in row] for row in rows[6:12]]) * np.outer(SIGNS, SIGNS)
    differences(data, motions, damping)


def hams(hydrodynamics, case, output):
    data = hydrodynamics.from_hams(case, output=output)
    print("\n".join(data.notes + [f"refused: {problem}" for problem in data.problems]))
    wamit_form = importlib.import_module("fenderline.hydrodynamics._wamit")
    control = (case / "Input" / "ControlFile.in").read_text()
    column = wamit_form.HAMS_COLUMNS[int(re.search(r"Output_frequency_type\s+(\d)", control)[1])]
    motions = {}
    for line in next((case / output / "Wamit_format").glob("*.4")).read_text().splitlines():
        first, beta, mode, _, _, real, imaginary = (float(cell) for cell in line.split())
        if first > 0 and beta <= 180.0:
            omega = wamit_form.omega(column, first, 1.0, data.depth_m, 9.80665)
            # HAMS's motions are over the specific weight of the water, and a quarter of a period late.
            own = -1j * data.water_kgpm3 * 9.80665 * complex(real, imaginary)
            motions.setdefault((omega, beta), np.zeros(6, complex))[int(mode) - 1] = own
    rows = [line.split() for line in (case / "Input" / "Hydrostatic.in").read_text().splitlines() if len(line.split()) == 6]
    moorings = np.array([[float(cell) for cell in row] for row in rows[24:30]]) * np.outer(SIGNS, SIGNS)
    differences(data, motions, restoring=moorings)


def aqwa(hydrodynamics, listing):
    text = listing.read_text(encoding="utf-8", errors="replace").splitlines()
    motions, heading, inside = {}, math.nan, False
    for line in text:
        if "VARIATION WITH" in line:
            inside = bool(re.match(r"\s*R\.A\.O\.S-VARIATION WITH WAVE PERIOD", line))
        try:
            row = [float(cell) for cell in line.split()]
        except ValueError:
            continue
        if inside and len(row) in (14, 15):
            if len(row) == 15:
                heading = row.pop(2)
            amplitudes, phases = np.array(row[2::2]), np.radians(row[3::2])
            motions[row[1], heading] = amplitudes * np.exp(-1j * phases) * np.array([1, 1, 1] + [math.pi / 180] * 3)
    beside = next((path for path in listing.parent.iterdir() if path.stem == listing.stem and path.suffix.lower() == ".ah1"), None)
    for path in [listing] + ([beside] if beside else []):
        print(path.name)
        data = hydrodynamics.from_aqwa(path)
        print("\n".join(data.notes))
        differences(data, motions)


def own(hydrodynamics):
    """Damping over that by the exciting forces, at the depth of the data and at twice of it."""
    check = importlib.import_module("fenderline.hydrodynamics._check")
    panels = importlib.import_module("fenderline.hydrodynamics._panel")
    for path in sorted((ROOT / "hydrodynamics").glob("*.hydro")):
        data = hydrodynamics.read(path)
        omegas = sorted(data.damping)
        waves, headings = (sorted({key[k] for key in data.excitation}) for k in (0, 1))
        panel = panels.Panel(
            source="", file=path, omega=np.array(omegas), added=np.array([data.added_mass[w] for w in omegas]),
            damping=np.array([data.damping[w] for w in omegas]), infinite=None, wave_omega=np.array(waves), headings_deg=np.array(headings),
            force=np.array([[data.excitation[w, h] for h in headings] for w in waves]), depth_m=data.depth_m, gravity_mps2=9.81,
            water_kgpm3=data.water_kgpm3,
        )
        found = [check.contradiction(replace(panel, depth_m=factor * data.depth_m)) for factor in (1, 2)]
        words = [f"off by {100 * (math.exp(off[0]) - 1):.0f} % (mean of the ratio {math.exp(off[1]):.2f})" if off else "not resolved" for off in found]
        print(f"{path.stem}: {words[0]}; at twice the depth {words[1]}")


if __name__ == "__main__":
    code = converters()
    warnings.simplefilter("ignore", code.HydrodynamicsWarning)
    arguments = sys.argv[1:]
    if not arguments:
        own(code)
    elif arguments[0].lower().endswith(".lis"):
        aqwa(code, Path(arguments[0]))
    elif Path(arguments[0]).is_dir():
        hams(code, Path(arguments[0]), arguments[1])
    else:
        values = [float(value) for value in arguments[1:]]
        wamit(code, arguments[0], values[:3], values[3:6])
