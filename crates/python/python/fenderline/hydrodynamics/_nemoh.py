"""Folders of Nemoh 2 and 3."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from pathlib import Path

import numpy as np

from fenderline.hydrodynamics._errors import HydrodynamicsError
from fenderline.hydrodynamics._panel import Panel
from fenderline.hydrodynamics._text import lines, number, numbers, sibling, value
from fenderline.hydrodynamics._waves import Array


class Case:
    """What `Nemoh.cal` says."""

    def __init__(self, path: Path | None) -> None:
        self.path = path
        self.water_kgpm3: float | None = None
        self.gravity_mps2: float | None = None
        self.depth_m: float | None = None
        self.measured_m = (0.0, 0.0)
        """Where the crest is at time 0."""
        self.bodies: list[tuple[str, tuple[float, float, float]]] = []
        """Name of the mesh and point about which it turns."""
        if path is None:
            return
        for index, line in enumerate(lines(path), 1):
            low = line.lower()
            row = _leading(line)
            if "fluid specific volume" in low and row:
                self.water_kgpm3 = row[0]
            elif "gravity" in low and row:
                self.gravity_mps2 = row[0]
            elif "water depth" in low and row:
                self.depth_m = row[0] if row[0] > 0.0 else math.inf
            elif "wave measurement point" in low and len(row) >= 2:
                self.measured_m = (row[0], row[1])
            elif "name of mesh file" in low:
                name = line.split("!")[0].strip().replace("\\", "/").rsplit("/", 1)[-1]
                self.bodies.append((name.rsplit(".", 1)[0], (0.0, 0.0, 0.0)))
            elif re.search(r"!\s*(roll|pitch|yaw) about", low) and self.bodies:
                if len(row) < 7:
                    raise HydrodynamicsError("a motion about a point must have seven numbers", path, index)
                self.bodies[-1] = (self.bodies[-1][0], (row[4], row[5], row[6]))


def read(
    folder: Path,
    *,
    body: int | str | None,
    depth_m: float | None,
    gravity_mps2: float | None,
    water_kgpm3: float | None,
) -> Panel:
    """Reads the folder of a case (with `Nemoh.cal`, `Mesh` and `Results`) or that of its results."""
    if not folder.is_dir():
        raise HydrodynamicsError("there is no such folder", folder)
    results = next((own for own in (folder, sibling(folder, "results")) if own and sibling(own, "RadiationCoefficients.tec")), None)
    if results is None:
        raise HydrodynamicsError("neither here nor in a folder `results` is RadiationCoefficients.tec", folder)
    above = results if results != folder else folder.parent
    case = Case(sibling(folder, "Nemoh.cal") or sibling(above, "Nemoh.cal") or sibling(above.parent, "Nemoh.cal"))
    radiation, exciting = sibling(results, "RadiationCoefficients.tec"), sibling(results, "ExcitationForce.tec")
    assert radiation is not None
    if exciting is None:
        raise HydrodynamicsError("there is no ExcitationForce.tec", results)
    water = _agreed(water_kgpm3, case.water_kgpm3, 1025.0, "water_kgpm3", case.path, 0.005)
    gravity = _agreed(gravity_mps2, case.gravity_mps2, 9.81, "gravity_mps2", case.path, 0.005)
    depth = _agreed(depth_m, case.depth_m, math.inf, "depth_m", case.path, 0.02)

    zones = _zones(radiation)
    count = max(1, len(zones) // 6)
    if len(zones) != 6 * count:
        raise HydrodynamicsError(f"there are {len(zones)} zones, but six motions of each body are needed", radiation)
    which = _chosen(body, count, case, radiation)
    notes: list[str] = []
    if count > 1:
        own = case.bodies[which][0] if which < len(case.bodies) else str(which + 1)
        others = ", ".join(
            case.bodies[k][0] if k < len(case.bodies) else str(k + 1) for k in range(count) if k != which
        )
        notes.append(
            f"Left out: body {others}, and the coupling of body {own} to it; the other bodies are in the forces as if they were held."
        )
    width = 1 + 12 * count
    omega, line_of = _axis(radiation, zones[6 * which], width)
    added, damping = (np.full((len(omega), 6, 6), np.nan) for _ in range(2))
    unit = _unit(radiation)
    for j in range(6):
        zone = zones[6 * which + j]
        for row, (line, values) in enumerate(_whole(radiation, zone, len(omega), width)):
            for i in range(6):
                column = 1 + 2 * (6 * which + i)
                added[row, i, j], damping[row, i, j] = values[column], values[column + 1]
            if abs(unit(values[0]) - omega[row]) > 1e-6 * omega[row]:
                raise HydrodynamicsError("the frequencies are others than those of the first motion", radiation, line)
    waves = _zones(exciting)
    if not waves:
        raise HydrodynamicsError("there is no zone", exciting)
    wave_omega, _ = _axis(exciting, waves[0], width)
    headings = []
    force = np.full((len(wave_omega), len(waves), 6), np.nan + 0j)
    for column, zone in enumerate(waves):
        title, start, _ = zone
        found = re.search(r"beta\s*=\s*([-+.0-9eE]+)", title)
        if not found:
            raise HydrodynamicsError("the title of a zone has no beta", exciting, start)
        headings.append(value(found[1], exciting, start))
        for row, (_, values) in enumerate(_whole(exciting, zone, len(wave_omega), width)):
            for k in range(6):
                at = 1 + 2 * (6 * which + k)
                # Nemoh's e^(-i omega t) is the conjugate.
                force[row, column, k] = values[at] * np.exp(-1j * values[at + 1])
    order, wave_order = np.argsort(omega), np.argsort(wave_omega)
    panel = Panel(
        source=f"Nemoh, {folder.name}",
        file=radiation,
        omega=omega[order],
        added=added[order],
        damping=damping[order],
        infinite=None,
        wave_omega=wave_omega[wave_order],
        headings_deg=np.array(headings),
        force=force[wave_order],
        depth_m=depth,
        gravity_mps2=gravity,
        water_kgpm3=water,
        lines={float(w): line for w, line in zip(omega, line_of, strict=True)},
        notes=notes,
    )
    panel.several = count > 1
    point = case.bodies[which][1] if which < len(case.bodies) else (0.0, 0.0, 0.0)
    x, y = point[0] - case.measured_m[0], point[1] - case.measured_m[1]
    if x or y:
        panel.seen_from(x, y)
        panel.notes.append(f"Moved: phases are counted from the point about which she turns, {x:g} m along x and {y:g} m along y from that of the run.")
    _hydrostatics(panel, [folder, above, results], which, count, point)
    return panel


def _hydrostatics(panel: Panel, folders: list[Path], which: int, count: int, point: tuple[float, float, float]) -> None:
    """`KH.dat` and `Hydrostatics.dat` of the mesh."""
    suffix = "" if count == 1 else f"_{which}"
    for folder in folders:
        mesh = sibling(folder, "mesh") or folder
        stiffness = sibling(mesh, f"KH{suffix}.dat")
        if stiffness is not None and panel.restoring is None:
            matrix = []
            for index, line in enumerate(lines(stiffness), 1):
                row = numbers(line)
                if not line.strip():
                    continue
                if row is None or len(row) != 6:
                    raise HydrodynamicsError("a row must have 6 numbers", stiffness, index)
                matrix.append(row)
            if len(matrix) != 6:
                raise HydrodynamicsError(f"there must be 6 rows, but there are {len(matrix)}", stiffness)
            panel.restoring = np.array(matrix)
        hydrostatics = sibling(mesh, f"Hydrostatics{suffix}.dat")
        if hydrostatics is not None and panel.mass_kg is None:
            text = "\n".join(lines(hydrostatics))
            volume = re.search(r"Displacement\s*=\s*(\S+)", text)
            centre = [re.search(rf"{axis}G\s*=\s*(\S+)", text) for axis in "XYZ"]
            if volume:
                panel.mass_kg = value(volume[1], hydrostatics) * panel.water_kgpm3
            if all(centre):
                x, y, z = (value(own[1], hydrostatics) for own in centre if own)
                panel.gravity_above_water_m = z
                # From the centre of gravity to the point about which she turns: forward, to starboard, up.
                panel.reference_m = (point[0] - x, -(point[1] - y), point[2] - z)


Zone = tuple[str, int, list[tuple[int, list[float]]]]


def _zones(path: Path) -> list[Zone]:
    """The zones of a file for Tecplot: title, line, and rows with their lines. A row may go on in the next line."""
    zones: list[Zone] = []
    for index, line in enumerate(lines(path), 1):
        if line.strip().lower().startswith("zone"):
            zones.append((line, index, []))
        elif zones and line.strip():
            row = numbers(line)
            if row is None:
                raise HydrodynamicsError(f"a row must be numbers, but is {line.strip()[:60]!r}", path, index)
            zones[-1][2].append((index, row))
    return zones


def _whole(path: Path, zone: Zone, count: int, width: int) -> list[tuple[int, list[float]]]:
    """The rows of a zone, each of the full width."""
    found: list[tuple[int, list[float]]] = []
    for line, row in zone[2]:
        if found and len(found[-1][1]) < width:
            found[-1][1].extend(row)
        else:
            found.append((line, list(row)))
    for line, row in found:
        if len(row) != width:
            raise HydrodynamicsError(f"a row must have {width} numbers, but has {len(row)}", path, line)
    if len(found) != count:
        raise HydrodynamicsError(f"the zone has {len(found)} rows, but others have {count}", path, zone[1])
    return found


def _axis(path: Path, zone: Zone, width: int) -> tuple[Array, list[int]]:
    """The frequencies of a zone and their lines."""
    rows = _whole(path, zone, sum(1 for _ in _merged(zone, width)), width)
    unit = _unit(path)
    omega = np.array([unit(row[0]) for _, row in rows])
    if not len(omega) or not (omega > 0.0).all():
        raise HydrodynamicsError("the zone has no frequencies above zero", path, zone[1])
    return omega, [line for line, _ in rows]


def _merged(zone: Zone, width: int) -> list[int]:
    starts, have = [], width
    for line, row in zone[2]:
        if have >= width:
            starts.append(line)
            have = 0
        have += len(row)
    return starts


def _unit(path: Path) -> Callable[[float], float]:
    """From an entry of the first column to the frequency (rad/s): the title of the column says rad/s, Hz or s."""
    with path.open(encoding="utf-8", errors="replace") as file:
        head = "".join(file.readline() for _ in range(2)).split("\n", 1)[0].lower()
    if "hz" in head:
        return lambda value: 2.0 * math.pi * value
    if "rad" not in head and re.search(r"\(\s*s\s*\)", head):
        return lambda value: 2.0 * math.pi / value
    return lambda value: value


def _leading(line: str) -> list[float]:
    """The numbers before a comment."""
    found = []
    for cell in line.split("!")[0].replace(",", " ").split():
        try:
            found.append(number(cell))
        except ValueError:
            break
    return found


def _agreed(given: float | None, found: float | None, default: float, key: str, path: Path | None, near: float) -> float:
    if given is not None and found is not None and not (given == found or abs(given - found) <= near * abs(found)):
        raise HydrodynamicsError(f"{key} is given as {given:g}, but the run has {found:g}", path)
    return given if given is not None else default if found is None else found


def _chosen(body: int | str | None, count: int, case: Case, path: Path) -> int:
    names = [name for name, _ in case.bodies]
    listed = ", ".join(f"{k + 1} ({names[k]})" if k < len(names) else str(k + 1) for k in range(count))
    if body is None:
        if count == 1:
            return 0
        raise HydrodynamicsError(f"the file has {count} bodies: {listed}; say which, as body = 1", path)
    if isinstance(body, str) and body in names[:count]:
        return names.index(body)
    if isinstance(body, int) and 1 <= body <= count:
        return body - 1
    raise HydrodynamicsError(f"there is no body {body!r}; there are {listed}", path)
