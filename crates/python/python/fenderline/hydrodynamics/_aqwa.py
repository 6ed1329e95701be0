"""Text files of AQWA: `.AH1`, and the listing `.LIS`."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np

from fenderline.hydrodynamics._errors import HydrodynamicsError
from fenderline.hydrodynamics._panel import Panel, gyradii
from fenderline.hydrodynamics._text import lines, number, numbers, value
from fenderline.hydrodynamics._waves import Array, Complexes


def read(path: Path, body: int | str | None) -> Panel:
    """Reads a file by its end. Moments are about the centre of gravity, and so are phases."""
    if not path.is_file():
        raise HydrodynamicsError("there is no such file", path)
    if path.suffix.lower() == ".lis":
        return _listing(path, body)
    return _ah1(path, body)


class _Rows:
    """Lines of numbers one after another."""

    def __init__(self, path: Path) -> None:
        self.path, self.lines, self.at = path, lines(path), 0

    def row(self, count: int, what: str) -> list[float]:
        """The numbers of the next line, of which there must be so many."""
        if self.at >= len(self.lines):
            raise HydrodynamicsError(f"the file ends within {what}", self.path, len(self.lines))
        found = numbers(self.lines[self.at])
        self.at += 1
        if found is None or len(found) != count:
            words = "text" if found is None else f"{len(found)}"
            raise HydrodynamicsError(f"{what} must have {count} numbers in this line, but there is {words}", self.path, self.at)
        return found

    def matrix(self, head: list[int], what: str) -> Array:
        """Six rows of six numbers; the first has the indices before them."""
        first = self.row(6 + len(head), what)
        if first[: len(head)] != [float(x) for x in head]:
            raise HydrodynamicsError(f"{what} must begin with {head}, but begins with {first[: len(head)]}", self.path, self.at)
        return np.array([first[len(head) :], *(self.row(6, what) for _ in range(5))])


def _body(body: int | str | None, count: int, path: Path) -> int:
    if body is None and count > 1:
        raise HydrodynamicsError(f"the file has {count} structures; say which, as body = 1", path)
    if body is None:
        return 0
    if isinstance(body, int) and 1 <= body <= count:
        return body - 1
    raise HydrodynamicsError(f"there is no body {body!r}; there are 1 to {count}", path)


def _ah1(path: Path, body: int | str | None) -> Panel:
    rows = _Rows(path)
    while rows.at < len(rows.lines) and rows.lines[rows.at].lstrip().startswith("*"):
        rows.at += 1
    start = rows.at
    first = numbers(rows.lines[start]) if start < len(rows.lines) else None
    if first is None or len(first) < 4:
        raise HydrodynamicsError("this is no .AH1 file: it must begin with structures, headings and frequencies", path, start + 1)
    headings_count, count = _whole(first[1]), _whole(first[2])
    if headings_count < 1 or count < 1:
        raise HydrodynamicsError("there must be headings and frequencies", path, start + 1)
    headings, omega = _axes(rows, headings_count, count, first[3:])
    # Each structure may repeat its headings and frequencies.
    structures = 1
    while rows.at < len(rows.lines) and (more := numbers(rows.lines[rows.at])) is not None:
        if len(more) < 4 or more[0] != structures + 1:
            break
        again = _axes(rows, _whole(more[1]), _whole(more[2]), more[3:])
        if again[0] != headings or again[1] != omega:
            raise HydrodynamicsError("the structures have headings or frequencies of their own", path, rows.at)
        structures += 1
    blocks = {line.strip(): k for k, line in enumerate(rows.lines) if re.fullmatch(r"[A-Z_]+", line.strip())}
    if structures == 1 and "COG" in blocks:
        structures = max(1, sum(1 for _ in _of_structures(rows, blocks["COG"])))
    which = _body(body, structures, path)
    for name in ("GENERAL", "ADDEDMASS", "DAMPING", "FORCERAO"):
        if name not in blocks:
            raise HydrodynamicsError(f"the file has no {name}", path)

    def block(name: str) -> None:
        rows.at = blocks[name] + 1

    block("GENERAL")
    general = (numbers(rows.lines[rows.at]) or []) if rows.at < len(rows.lines) else []
    # Older versions have no number of the structure before depth, density and gravity.
    values = general[1:4] if len(general) >= 6 or (len(general) >= 4 and general[0] == 1.0) else general[:3]
    if len(values) != 3:
        raise HydrodynamicsError("GENERAL must have depth, density and gravity", path, rows.at + 1)
    depth, water, gravity = values

    def blocks_of(name: str, indices: int) -> dict[tuple[int, ...], Array]:
        """The matrices of a table by their indices; structures that do not interact have none of their coupling."""
        block(name)
        found: dict[tuple[int, ...], Array] = {}
        while rows.at < len(rows.lines) and len(numbers(rows.lines[rows.at]) or []) == 6 + indices:
            key = tuple(_whole(x) for x in (numbers(rows.lines[rows.at]) or [])[:indices])
            found[key] = rows.matrix(list(key), name)
        return found

    def matrices(name: str) -> Array:
        found = blocks_of(name, 3)
        missing = [k + 1 for k in range(count) if (which + 1, which + 1, k + 1) not in found]
        if missing:
            raise HydrodynamicsError(
                f"{name} of structure {which + 1} is missing at frequency {missing[0]}", path, min(rows.at + 1, len(rows.lines))
            )
        return np.array([found[which + 1, which + 1, k + 1] for k in range(count)])

    def limit(name: str) -> Array | None:
        return blocks_of(name, 2).get((which + 1, which + 1)) if name in blocks else None

    def own(name: str) -> Array | None:
        if name not in blocks:
            return None
        block(name)
        found = [rows.matrix([k + 1], name) for k in range(structures)]
        return found[which]

    added, damping, infinite = matrices("ADDEDMASS"), matrices("DAMPING"), limit("ADDEDMASS_HF")
    block("FORCERAO")
    force = np.full((count, headings_count, 6), np.nan + 0j)
    for one in range(structures):
        for column in range(headings_count):
            for k in range(count):
                amplitudes = rows.row(9, "FORCERAO")
                if amplitudes[:3] != [one + 1.0, column + 1.0, k + 1.0]:
                    raise HydrodynamicsError(
                        f"FORCERAO must go on with {[one + 1, column + 1, k + 1]}, but has {amplitudes[:3]}", path, rows.at
                    )
                phases = rows.row(6, "FORCERAO")
                if one == which:
                    # AQWA's phases are lags.
                    force[k, column] = np.array(amplitudes[3:]) * np.exp(-1j * np.radians(phases))
    panel = Panel(
        source=f"AQWA, {path.name}",
        file=path,
        omega=np.array(omega),
        added=added,
        damping=damping,
        infinite=infinite,
        wave_omega=np.array(omega),
        headings_deg=np.array(headings),
        force=force,
        depth_m=depth,
        gravity_mps2=gravity,
        water_kgpm3=water,
    )
    mass, stiffness = own("MASS"), own("HYDSTIFFNESS")
    panel.restoring = stiffness
    if mass is not None:
        panel.mass_kg, panel.gyradii_m = float(mass[0, 0]), gyradii(mass, float(mass[0, 0]))
    if "COG" in blocks:
        centre = _of_structures(rows, blocks["COG"])
        if which < len(centre) and len(centre[which]) == 3:
            panel.gravity_above_water_m = centre[which][2]
    if "FARFIELD" in blocks:
        _far_field(panel, rows, blocks["FARFIELD"] + 1, which)
    _what_is_left(panel, structures, which)
    return panel


def _axes(rows: _Rows, headings: int, count: int, begun: list[float]) -> tuple[list[float], list[float]]:
    """Headings and frequencies of a structure: as many numbers, over as many lines as it takes."""
    start = rows.at
    rows.at += 1
    found = list(begun)
    while len(found) < headings + count and rows.at < len(rows.lines):
        more = numbers(rows.lines[rows.at])
        if more is None:
            break
        found += more
        rows.at += 1
    if len(found) != headings + count:
        raise HydrodynamicsError(
            f"there must be {headings} headings and {count} frequencies, but there are {len(found)} numbers", rows.path, start + 1
        )
    omega = found[headings:]
    if any(not low < high for low, high in zip([0.0, *omega], omega, strict=False)):
        raise HydrodynamicsError("the frequencies must rise from above zero", rows.path, start + 1)
    return found[:headings], omega


def _whole(value: float) -> int:
    """A whole number, or -1."""
    return int(value) if math.isfinite(value) and value == int(value) else -1


def _of_structures(rows: _Rows, at: int) -> list[list[float]]:
    """Rows below a title that begin with the number of the structure."""
    found: list[list[float]] = []
    for line in rows.lines[at + 1 :]:
        row = numbers(line)
        if not row or row[0] != len(found) + 1:
            break
        found.append(row[1:])
    return found


def _far_field(panel: Panel, rows: _Rows, at: int, which: int) -> None:
    """Mean drift by the momentum far away: structure, heading, frequency and six forces."""
    drift = np.full((len(panel.wave_omega), len(panel.headings_deg), 3), np.nan)
    for line in rows.lines[at:]:
        row = numbers(line)
        if row is None or len(row) != 9:
            break
        column, place = _whole(row[1]), _whole(row[2])
        if row[0] == which + 1 and 1 <= column <= drift.shape[1] and 1 <= place <= drift.shape[0]:
            drift[place - 1, column - 1] = [row[3], row[4], row[8]]
    if np.isfinite(drift).any():
        panel.drift = drift


def _what_is_left(panel: Panel, structures: int, which: int) -> None:
    panel.several = structures > 1
    if structures > 1:
        others = ", ".join(str(k + 1) for k in range(structures) if k != which)
        panel.notes.append(
            f"Left out: structure {others}, and the coupling of structure {which + 1} to it; the other structures are in the forces as "
            "if they were held."
        )


def _listing(path: Path, body: int | str | None) -> Panel:
    """The listing: the tables of each structure, wherever they stand."""
    text = lines(path)
    general: dict[str, float] = {}
    structure = 0
    masses: dict[int, list[float]] = {}
    centres: dict[int, list[float]] = {}
    stiffness: dict[int, Array] = {}
    radiation: dict[int, dict[float, dict[str, tuple[int, Array]]]] = {}
    waves: dict[int, dict[float, dict[float, Complexes]]] = {}
    last: dict[int, float] = {}
    """The direction with which the last page of a structure ended: the next page goes on with it."""
    now = 0.0
    k = 0
    while k < len(text):
        line = text[k]
        found = re.search(r"S T R U C T U R E\s+(\d+)", line)
        if found:
            structure = int(found[1])
        for key, name in (("depth", "WATER  DEPTH"), ("water", "DENSITY  OF  WATER"), ("gravity", "ACCELERATION  DUE  TO GRAVITY")):
            if name in line and "=" in line:
                general.setdefault(key, value((line.rsplit("=", 1)[1].split() or [""])[0], path, k + 1))
        if "T O T A L" in line and structure not in masses:
            row = _numbers_in(line.split("T O T A L", 1)[1])
            if len(row) >= 2:
                masses[structure] = [row[-2]]
        if "CENTRE OF GRAVITY" in line and structure not in centres:
            row = _numbers_in(line.split("CENTRE OF GRAVITY", 1)[1])
            if len(row) == 3:
                centres[structure] = row
        if "INERTIA MATRIX" in line and structure in masses and len(masses[structure]) == 1:
            diagonal: list[float] = []
            for step, row_line in enumerate(text[k : k + 8]):
                row = _numbers_in(row_line.split("INERTIA MATRIX")[-1])
                if len(row) == 3:
                    diagonal.append(row[len(diagonal)])
                if len(diagonal) == 3 or step == 7:
                    break
            masses[structure] += diagonal
        if "STIFFNESS MATRIX" in line and structure not in stiffness:
            matrix, _ = _six(text, k + 1, path)
            stiffness[structure] = matrix
        found = re.search(r"WAVE FREQUENCY\s*=\s*(\S+)", line)
        if found and "WAVE PERIOD" in line:
            now = value(found[1], path, k + 1)
        if now and line.strip() in ("ADDED  MASS", "ADDED MASS", "DAMPING") and set((text + [""])[k + 1].strip()) <= {"-", " "}:
            matrix, at = _six(text, k + 1, path)
            name = "damping" if line.strip() == "DAMPING" else "added"
            radiation.setdefault(structure, {}).setdefault(now, {}).setdefault(name, (at, matrix))
        if re.match(r"\s*FROUDE KRYLOV \+ DIFFRACTION FORCES-VARIATION WITH WAVE PERIOD/FREQUENCY", line):
            k, heading = _forces(text, k + 1, path, waves.setdefault(structure, {}), last.get(structure, math.nan))
            last[structure] = heading
        k += 1
    if not radiation:
        raise HydrodynamicsError("the listing has no tables of added mass and damping for each frequency", path)
    count = max(radiation)
    which = _body(body, count, path) + 1
    for name, table in (("added mass and damping", radiation), ("exciting forces", waves)):
        if not table.get(which):
            raise HydrodynamicsError(f"the listing has no {name} of structure {which}", path)
    omega = sorted(radiation[which])
    headings = sorted({heading for own in waves[which].values() for heading in own})
    # The tables of forces have three digits after the point, those of added mass four: they are of the same frequencies.
    waves[which] = {_same(omega, w): own_waves for w, own_waves in waves[which].items()}
    wave_omega = sorted(waves[which])
    nothing = np.full((6, 6), np.nan)
    panel = Panel(
        source=f"AQWA, {path.name}",
        file=path,
        omega=np.array(omega),
        added=np.array([radiation[which][w].get("added", (0, nothing))[1] for w in omega]),
        damping=np.array([radiation[which][w].get("damping", (0, nothing))[1] for w in omega]),
        infinite=None,
        wave_omega=np.array(wave_omega),
        headings_deg=np.array(headings),
        force=np.array([[waves[which][w].get(h, np.full(6, np.nan + 0j)) for h in headings] for w in wave_omega]),
        depth_m=general.get("depth", math.inf),
        gravity_mps2=general.get("gravity", 9.80665),
        water_kgpm3=general.get("water", 1025.0),
        lines={w: next(iter(radiation[which][w].values()))[0] for w in omega},
    )
    panel.restoring = stiffness.get(which)
    own_mass = masses.get(which, [])
    if own_mass and own_mass[0] > 0.0:
        panel.mass_kg = own_mass[0]
        if len(own_mass) == 4:
            roll, pitch, yaw = (math.sqrt(max(x, 0.0) / own_mass[0]) for x in own_mass[1:])
            panel.gyradii_m = (roll, pitch, yaw)
    if which in centres:
        panel.gravity_above_water_m = centres[which][2]
    panel.notes.append("Left out: mean drift, which is not read from the listing; the .AH1 file has that by the far field.")
    _what_is_left(panel, count, which - 1)
    return panel


def _same(omegas: list[float], w: float) -> float:
    """The frequency of the list that is this one but for its last digit."""
    near = omegas[int(np.argmin(np.abs(np.array(omegas) - w)))]
    return near if abs(near - w) < 6e-4 else w


def _numbers_in(line: str) -> list[float]:
    found = []
    for cell in line.split():
        try:
            found.append(number(cell))
        except ValueError:
            continue
    return found


def _six(text: list[str], at: int, path: Path) -> tuple[Array, int]:
    """Six rows named X to RZ, with blank lines between them."""
    rows: list[list[float]] = []
    first = at + 1
    for k in range(at, min(at + 30, len(text))):
        found = re.match(r"\s*(R?[XYZ])\s+(.*)", text[k])
        if found and (row := numbers(found[2])) is not None and len(row) == 6:
            first = first if rows else k + 1
            rows.append(row)
            if len(rows) == 6:
                return np.array(rows), first
    raise HydrodynamicsError("a matrix must have six rows X to RZ of six numbers", path, at)


def _forces(
    text: list[str], at: int, path: Path, table: dict[float, dict[float, Complexes]], heading: float
) -> tuple[int, float]:
    """Forces by frequency and direction on a page: period, frequency, the direction in its first row, and six pairs of amplitude and phase.
    Gives back where the page ends, and its last direction."""
    for k in range(at, len(text)):
        row = numbers(text[k])
        if text[k].startswith("1") and (row is None or len(row) == 1) and k > at + 2:
            return k, heading
        if row is None or len(row) not in (14, 15):
            if row is None and "VARIATION WITH" in text[k]:
                return k - 1, heading
            continue
        if len(row) == 15:
            heading = row.pop(2)
        if math.isnan(heading):
            raise HydrodynamicsError("the first row must have the direction", path, k + 1)
        amplitudes, phases = np.array(row[2::2]), np.radians(row[3::2])
        table.setdefault(_near(table, row[1]), {})[heading] = amplitudes * np.exp(-1j * phases)
    return len(text), heading


def _near(table: dict[float, dict[float, Complexes]], omega: float) -> float:
    """The frequency of the table that is meant: they have three digits after the point."""
    return next((own for own in table if abs(own - omega) < 1e-9), omega)
