"""The studies with their meshes, and the files with their results (`results/`)."""

import csv
import time
from pathlib import Path

from . import cases
from .press import NoEquilibrium

RESULTS = Path(__file__).resolve().parent.parent / "results"

# Finenesses, coarse to fine; each is twice the one before if two are compared.
MESHES = {"cylinder": (1, 2, 4), "solid_d": (1, 2), "hollow_d": (2, 4), "cone": (2,)}
# For shapes under a tilted plate, which need the whole section.
WHOLE = {"cylinder": 1, "solid_d": 1, "hollow_d": 2}
TILTS_DEG = (0, 5, 10)
# Their largest deflection; beyond it the bore of the cylinder closes at an angle.
TILTED_TO = 0.4
# Smallest deflection over height at which reactions are compared.
NOT_BELOW = 0.2
# Fineness of the small form, and the permitted difference of its meshes from the stored fine ones: the cylinder differs by 2.2 % at
# 40 %, where its bore begins to close, and by less than 1 % elsewhere.
SMALL = {"cylinder": 2, "solid_d": 1}
SMALL_TOLERANCE = 0.03


def write(name, header, rows):
    RESULTS.mkdir(exist_ok=True)
    with open(RESULTS / name, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        for row in rows:
            writer.writerow([f"{cell:.6g}" if isinstance(cell, float) else cell for cell in row])


def read(name):
    """Rows as dictionaries, with numbers as numbers."""
    def cell(text):
        try:
            return float(text)
        except ValueError:
            return text

    with open(RESULTS / name, newline="") as file:
        return [{key: cell(text) for key, text in row.items()} for row in csv.DictReader(file)]


def told(what, began):
    print(f"{what}: {time.process_time() - began:.1f} s of processor time", flush=True)


def whole():
    """All studies. A tilted plate without an equilibrium is reported and left out."""
    began = time.process_time()
    flat_plates(began)
    tilted_plates(began)
    write("time.csv", ["processor_seconds"], [(float(round(time.process_time() - began)),)])


def flat_plates(began):
    """Every shape on every mesh."""
    flat = []
    for name, finenesses in MESHES.items():
        for fineness in finenesses:
            rows, elements, _ = cases.load(name, fineness)
            energies = cases.energy(rows)
            flat += [
                (name, fineness, elements, float(d), float(r), float(e))
                for (d, r, _, _), e in zip(rows, energies)
            ]
            told(f"{name}, {elements} elements, {rows[-1][1]:.4f} at {rows[-1][0]:.2f}", began)
    header = ["shape", "fineness", "elements", "deflection", "reaction", "energy"]
    write("pressed.csv", header, flat)


def tilted_plates(began):
    """Whole sections under a plate that is tilted."""
    tilted = []
    for name, fineness in WHOLE.items():
        for tilt in TILTS_DEG:
            try:
                rows, _, _ = cases.load(name, fineness, to=TILTED_TO, whole=True, tilt_deg=tilt)
                tilted += [(name, tilt, *map(float, row)) for row in rows]
            except NoEquilibrium as error:
                print(f"{name} at {tilt} degrees: no equilibrium {error}", flush=True)
            told(f"{name} at {tilt} degrees", began)
    write("tilted.csv", ["shape", "tilt_deg", "deflection", "reaction", "lateral", "moment"], tilted)


def small():
    """Compares coarse meshes with the stored fine ones: 0 if they agree."""
    stored = read("pressed.csv")
    failed = 0
    for name, fineness in SMALL.items():
        began = time.process_time()
        finest = MESHES[name][-1]
        fine = {
            round(row["deflection"], 4): row["reaction"]
            for row in stored
            if row["shape"] == name and row["fineness"] == finest
        }
        rows, elements, _ = cases.load(name, fineness)
        pairs = [(d, r / fine[round(d, 4)] - 1) for d, r, _, _ in rows if d >= NOT_BELOW]
        worst = max(pairs, key=lambda pair: abs(pair[1]))
        good = abs(worst[1]) <= SMALL_TOLERANCE
        failed |= not good
        print(
            f"{name}, {elements} elements: reaction from {100 * NOT_BELOW:.0f} % on within "
            f"{100 * abs(worst[1]):.2f} % of the fine mesh (at {worst[0]:.2f})"
            f"{'' if good else ': TOO FAR'}",
            flush=True,
        )
        told(name, began)
    return int(failed)
