"""Files of WAMIT, and of HAMS, which writes the same."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from pathlib import Path

import numpy as np

from fenderline.hydrodynamics._check import CLEAR, FAR, SHALLOW, best_depth, contradiction, metres
from fenderline.hydrodynamics._errors import HydrodynamicsError
from fenderline.hydrodynamics._panel import Panel
from fenderline.hydrodynamics._text import index_of, lines, numbers, rows, sibling, value
from fenderline.hydrodynamics._waves import Array, frequency_radps

#: What the first column may be, by WAMIT's number IPEROUT (5 is HAMS's alone).
COLUMNS = {
    1: "period",
    2: "frequency",
    3: "deep wave number",
    4: "wave number",
    5: "wave length",
}
#: HAMS numbers them in another way (Output_frequency_type of its ControlFile.in).
HAMS_COLUMNS = {
    1: "deep wave number",
    2: "wave number",
    3: "frequency",
    4: "period",
    5: "wave length",
}


def base_of(path: str | Path) -> Path:
    """The stem of a set of files. A dot in the stem is a part of it; the end of one of the files is not."""
    base = Path(path)
    ends = {".1", ".2", ".3", ".4", ".8", ".9", ".hst", ".out"}
    if base.suffix.lower() in ends and base.is_file() and not with_end(base, ".1").is_file():
        return base.with_suffix("")
    return base


def with_end(base: Path, end: str) -> Path:
    """A file of the set, whatever the case of its end."""
    plain = base.with_name(base.name + end)
    return plain if plain.is_file() else (sibling(base.parent, plain.name) or plain)


class Run:
    """What `.out`, `.cfg` and `.gdf` say of the run."""

    def __init__(self, base: Path) -> None:
        self.length_m: tuple[float, Path, int] | None = None
        self.gravity_mps2: tuple[float, Path, int] | None = None
        self.depth_m: tuple[float, Path, int] | None = None
        self.water_kgpm3: tuple[float, Path, int] | None = None
        self.column: tuple[str, Path, int | None] | None = None
        self.bodies: list[tuple[str, float, tuple[float, float, float, float]]] = []
        """Name, volume (m³), and place and turn of each body."""
        self.centres: list[tuple[float, float, float]] = []
        """Centre of gravity of each body in her axes."""
        self.waves: list[tuple[float, float]] = []
        """Periods and wave numbers of the run."""
        self.out: Path | None = None
        out = with_end(base, ".out")
        if out.is_file():
            self._out(out)
        gdf = with_end(base, ".gdf")
        if gdf.is_file() and self.length_m is None:
            head = lines(gdf)[1:2]
            row = numbers(" ".join(head[0].split()[:2])) if head else None
            if row and len(row) == 2:
                self.length_m = (row[0], gdf, 2)
        for config in (with_end(base, ".cfg"), base.parent / "config.wam"):
            if config.is_file() and (self.column is None or self.column[2] is None):
                self._config(config)

    def _out(self, out: Path) -> None:
        here = (0.0, 0.0, 0.0, 0.0)
        name, floats = "", (0.0, 0.0)
        for index, line in enumerate(lines(out), 1):
            found = re.search(r"Gravity:\s+(\S+)\s+Length scale:\s+(\S+)", line)
            if found:
                self.gravity_mps2 = (value(found[1], out, index), out, index)
                self.length_m = (value(found[2], out, index), out, index)
            found = re.search(r"Water depth:\s+(\S+)", line)
            if found:
                depth = math.inf if found[1].lower().startswith("inf") else value(found[1], out, index)
                self.depth_m = (depth, out, index)
            found = re.search(r"Water density:\s+(\S+)", line)
            if found:
                self.water_kgpm3 = (value(found[1], out, index), out, index)
            found = re.search(r"Geometric Data File:\s+(\S+)", line)
            if found:
                name = found[1].rsplit(".", 1)[0]
            found = re.search(r"BODY PARAMETERS:|Body number: N=\s*(\d+)", line)
            if found:
                here = (0.0, 0.0, 0.0, 0.0)
            values = dict(re.findall(r"([XYZ]BODY|PHIBODY)\s*=\s*([-+.0-9Ee]+)", line))
            if values:
                x, y, z, turn = (value(values.get(key, "0"), out, index) for key in ("XBODY", "YBODY", "ZBODY", "PHIBODY"))
                here = (x, y, z, turn)
            found = re.search(r"Volumes \(VOLX,VOLY,VOLZ\):\s+(\S+)\s+(\S+)\s+(\S+)", line)
            if found:
                self.bodies.append((name, value(found[3], out, index), here))
            found = re.search(r"Center of Buoyancy\s+\(Xb,Yb,Zb\):\s+(\S+)\s+(\S+)", line)
            if found:
                floats = (value(found[1], out, index), value(found[2], out, index))
            found = re.search(r"Center of Gravity\s+\(Xg,Yg,Zg\):(.*)", line)
            if found and (centre := numbers(found[1])) is not None and len(centre) in (1, 3):
                # WAMIT prints the height alone where the centre of gravity is above that of buoyancy (first form of its .frc).
                self.centres.append((*floats, centre[0]) if len(centre) == 1 else (centre[0], centre[1], centre[2]))
            found = re.search(r"Wave period \(sec\)\s*=\s*(\S+)\s+Wavenumber \(kL\)\s*=\s*(\S+)", line)
            if found:
                self.waves.append((value(found[1], out, index), value(found[2], out, index)))
        self.out = out

    def column_of(self, values: list[float]) -> str | None:
        """What the values of a first column are, by the list of `.out`."""
        for column, own in (
            ("period", [period for period, _ in self.waves]),
            ("frequency", [2.0 * math.pi / period for period, _ in self.waves if period > 0.0]),
            ("wave number", [number for _, number in self.waves]),
        ):
            if own and all(min(abs(entry - other) for other in own) < 1e-4 * entry for entry in values):
                return column
        return None

    def _config(self, config: Path) -> None:
        # Without the key, WAMIT writes periods (its manual, section 4.7). But the file of HAMS or of another program has no such key.
        for index, line in enumerate(lines(config), 1):
            found = re.match(r"\s*(IPEROUT|IPERIO)\s*=\s*(\d+)", line.split("!")[0], re.IGNORECASE)
            if found:
                column = COLUMNS.get(int(found[2]))
                if column is None:
                    raise HydrodynamicsError(f"{found[1]} must be 1 to 4, but is {found[2]}", config, index)
                self.column = (column, config, index)


def read(
    base: Path,
    *,
    body: int | str | None,
    length_m: float | None,
    depth_m: float | None,
    gravity_mps2: float | None,
    water_kgpm3: float | None,
    first_column: str | None,
    body_at_m: tuple[float, float, float] | None,
    run: Run | None = None,
    told: str = "",
) -> Panel:
    """Reads a set of files. What is not given is taken from `.out`; what contradicts `.out` is an error."""
    radiation = with_end(base, ".1")
    if not radiation.is_file():
        raise HydrodynamicsError("there is no such file (added mass and damping)", radiation)
    forces = next((f for f in (with_end(base, ".3"), with_end(base, ".2")) if f.is_file()), None)
    if forces is None:
        raise HydrodynamicsError("there is no file of exciting forces (.3 or .2)", with_end(base, ".3"))
    own = Run(base) if run is None else run
    length = agreed(length_m, own.length_m, 1.0, "length_m", "length scale", 0.001)
    gravity = agreed(gravity_mps2, own.gravity_mps2, 9.80665, "gravity_mps2", "gravity", 0.005)
    water = agreed(water_kgpm3, own.water_kgpm3, 1025.0, "water_kgpm3", "density of the water", 0.005)
    depth = agreed(depth_m, own.depth_m, math.inf, "depth_m", "depth", 0.02)

    first = Table(radiation)
    modes = first.modes()
    panels = Table(forces)
    which, count = chosen(body, modes, own, radiation)
    notes: list[str] = []
    offset = 6 * which
    if count > 1:
        others = [name for k, name in enumerate(names(own, count)) if k != which]
        notes.append(
            f"Left out: body {', '.join(others)}, and the coupling of body {names(own, count)[which]} to it; the other bodies "
            "are in the forces as if they were held."
        )

    # Rows with the limits have four numbers, or a damping that means nothing.
    keys = sorted({key for key in first.first if key > 0})
    matrix = {key: (np.full((6, 6), np.nan), np.full((6, 6), np.nan)) for key in first.first}
    seen = np.zeros((6, 6), bool)
    for line, row in first.rows:
        i, j = (index_of(row[k], 6 * count, "a motion", radiation, line) - 1 - offset for k in (1, 2))
        if 0 <= i < 6 and 0 <= j < 6:
            added, damping = matrix[row[0]]
            added[i, j], damping[i, j] = row[3], row[4] if len(row) == 5 else math.nan
            if row[0] > 0 and len(row) != 5:
                raise HydrodynamicsError("the damping is missing", radiation, line)
            seen[i, j] = True
    mirrored = [(i, j) for i in range(6) for j in range(6) if not seen[i, j] and seen[j, i]]
    if mirrored:
        pairs = ", ".join(f"{i + 1}{j + 1}" for i, j in mirrored)
        notes.append(f"Filled: the entries {pairs} of added mass and damping are not in {radiation.name}; their mirror entries are taken.")
    for added, damping in matrix.values():
        for i, j in mirrored:
            added[i, j], damping[i, j] = added[j, i], damping[j, i]
        for i in range(6):
            for j in range(6):
                if not seen[i, j] and not seen[j, i]:
                    added[i, j] = damping[i, j] = 0.0
    if not keys:
        raise HydrodynamicsError("the file has no frequency but the limits", radiation)

    if first_column and first_column not in COLUMNS.values():
        raise HydrodynamicsError(f"first_column is {first_column!r}, but must be one of: {', '.join(COLUMNS.values())}")
    kind, by = first_column, "as given"
    listed = own.column_of(keys)
    if kind and listed and kind != listed:
        raise HydrodynamicsError(
            f"first_column is given as {kind!r}, but the values are the {listed}s of {own.out.name if own.out else 'the listing'}", radiation, 1
        )
    if not kind and (kind := listed):
        by = f"{own.out.name if own.out else 'the listing'} has the same values"
    elif not kind and own.column:
        kind, by = own.column[0], f"{own.column[1].name} says so"
    by = told or by

    def panel(column: str) -> Panel:
        return build(
            column, base, radiation, forces, keys, matrix, first, panels, offset, count,
            length, depth, gravity, water, list(notes),
        )  # fmt: skip

    if kind:
        column, made = kind, panel(kind)
        if column != "period":
            made.notes.append(f"The first column of {radiation.name} is the {column}: {by}.")
        contradicted(panel, column, radiation, by)
    else:
        column, reason = recognised(panel, list(COLUMNS.values()), radiation)
        made = panel(column)
        if column != "period":
            made.notes.append(f"Supposed: the first column of {radiation.name} is the {column}: {reason}.")
    made.several = count > 1
    read_drift(made, base, which, count, column, length)
    place = body_at_m
    if own.bodies and which < len(own.bodies):
        x, y, _, turn = own.bodies[which][2]
        if place is None:
            place = (x, y, turn)
        made.mass_kg = own.bodies[which][1] * water
    if place is not None and place != (0.0, 0.0, 0.0):
        made.seen_from(place[0], place[1])
        made.turned(place[2])
        made.notes.append(
            f"Moved: phases are counted from the body's origin, {place[0]:g} m along x and {place[1]:g} m along y from that of the run"
            + (f", and headings from her bow, turned by {place[2]:g} degrees." if place[2] else ".")
        )
    if len(own.centres) == count and len(own.bodies) == count:
        x, y, z = own.centres[which]
        made.gravity_above_water_m = z + own.bodies[which][2][2]
        # From the centre of gravity to the origin of the body: forward, to starboard, up.
        made.reference_m = (-x, y, -z)
    stiffness = with_end(base, ".hst")
    if stiffness.is_file():
        made.restoring = restoring(stiffness, which, count, water * gravity, length)
    return made


def build(
    column: str,
    base: Path,
    radiation: Path,
    forces: Path,
    keys: list[float],
    matrix: dict[float, tuple[Array, Array]],
    first: Table,
    waves: Table,
    offset: int,
    count: int,
    length: float,
    depth: float,
    gravity: float,
    water: float,
    notes: list[str],
) -> Panel:
    """The data, if the first column is of this kind."""
    omega_of = {key: omega(column, key, length, depth, gravity) for key in keys}
    ordered = sorted(keys, key=lambda key: omega_of[key])
    powers = np.array([[3 + (i > 2) + (j > 2) for j in range(6)] for i in range(6)])
    scale = water * length**powers
    # Of a column of periods, zero is infinite frequency and a negative number zero frequency; of the others the other way round.
    limit = [key for key in matrix if (key == 0 if column in ("period", "wave length") else key < 0)]
    infinite = matrix[limit[0]][0] * scale if limit else None
    if infinite is not None and not np.isfinite(infinite).all():
        notes.append("Left out: the row of infinite frequency has a value that is not a number.")
        infinite = None
    wave_keys = sorted({key for key in waves.first if key > 0}, key=lambda key: omega(column, key, length, depth, gravity))
    headings = sorted({row[1] for _, row in waves.rows})
    force = np.full((len(wave_keys), len(headings), 6), np.nan + 0j)
    place = {key: k for k, key in enumerate(wave_keys)}
    at = {heading: k for k, heading in enumerate(headings)}
    lever = np.array([2, 2, 2, 3, 3, 3])
    for line, row in waves.rows:
        if row[0] <= 0:
            continue
        k = index_of(row[2], 6 * count, "a motion", forces, line) - 1 - offset
        if 0 <= k < 6:
            force[place[row[0]], at[row[1]], k] = water * gravity * length ** lever[k] * complex(row[5], row[6])
    for k in range(6):
        if np.isnan(force[:, :, k]).all():
            force[:, :, k] = 0.0
            notes.append(f"Filled: {forces.name} has no exciting force of motion {k + 1}; it is taken as zero.")
    return Panel(
        source=f"WAMIT, {base.name}",
        file=radiation,
        omega=np.array([omega_of[key] for key in ordered]),
        added=np.array([matrix[key][0] * scale for key in ordered]),
        damping=np.array([matrix[key][1] * scale * omega_of[key] for key in ordered]),
        infinite=infinite,
        wave_omega=np.array([omega(column, key, length, depth, gravity) for key in wave_keys]),
        headings_deg=np.array(headings),
        force=force,
        depth_m=depth,
        gravity_mps2=gravity,
        water_kgpm3=water,
        lines={omega_of[key]: first.first[key] for key in keys},
        notes=notes,
    )


class Table:
    """The rows of a file, and the line of the first row of each entry of its first column."""

    def __init__(self, path: Path) -> None:
        end = path.suffix
        widths = {".1": (4, 5), ".8": (8,), ".9": (8,)}.get(end.lower(), (7,))
        self.path = path
        self.rows = list(rows(path, widths))
        self.first: dict[float, int] = {}
        for line, row in self.rows:
            if not math.isfinite(row[0]):
                raise HydrodynamicsError("the first number is not finite", path, line)
            self.first.setdefault(row[0], line)

    def modes(self) -> int:
        """The number of the highest motion; ninety-nine bodies at most."""
        return max(index_of(row[k], 6 * 99, "a motion", self.path, line) for line, row in self.rows for k in (1, 2))


def omega(column: str, value: float, length_m: float, depth_m: float, gravity_mps2: float) -> float:
    """The frequency of an entry of the first column (rad/s)."""
    if column == "period":
        return 2.0 * math.pi / value
    if column == "frequency":
        return value
    if column == "wave length":
        return frequency_radps(2.0 * math.pi / (value * length_m), depth_m, gravity_mps2)
    return frequency_radps(value / length_m, math.inf if column == "deep wave number" else depth_m, gravity_mps2)


def agreed(
    given: float | None, found: tuple[float, Path, int] | None, default: float, key: str, what: str, near: float
) -> float:
    """A number of the run: as given, by the files, or the default; given and files must agree."""
    if given is not None and not given > 0.0:
        raise HydrodynamicsError(f"{key} must be above 0, but is {given:g}")
    if found is None:
        return default if given is None else given
    own, path, line = found
    if not own > 0.0:
        raise HydrodynamicsError(f"the {what} must be above 0, but is {own:g}", path, line)
    if given is not None and not (given == own or abs(given - own) <= near * abs(own)):
        raise HydrodynamicsError(f"{key} is given as {given:g}, but the {what} of the run is {own:g}", path, line)
    return own if given is None else given


def names(run: Run, count: int) -> list[str]:
    """Names of the bodies."""
    if len(run.bodies) == count:
        return [f"{k + 1} ({body[0]})" if body[0] else str(k + 1) for k, body in enumerate(run.bodies)]
    return [str(k + 1) for k in range(count)]


def chosen(body: int | str | None, modes: int, run: Run, path: Path) -> tuple[int, int]:
    """The index of the body that was asked for, and how many there are."""
    count = (modes + 5) // 6
    if count == 1:
        if body not in (None, 1):
            raise HydrodynamicsError(f"body is {body!r}, but the file has one body", path)
        return 0, 1
    known = names(run, count)
    if body is None:
        listed = ", ".join(known)
        raise HydrodynamicsError(f"the file has {count} bodies: {listed}; say which, as body = 1", path)
    if isinstance(body, str):
        for k, (name, _, _) in enumerate(run.bodies):
            if name == body:
                return k, count
    elif 1 <= body <= count:
        return body - 1, count
    raise HydrodynamicsError(f"there is no body {body!r}; there are {', '.join(known)}", path)


def restoring(path: Path, which: int, count: int, specific_npm3: float, length_m: float) -> Array:
    """The restoring of a body (`.hst`): of C33 by ρgL², C34 and C35 by ρgL³, the others by ρgL⁴."""
    matrix = np.zeros((6, 6))
    for line, row in rows(path, (3,)):
        i, j = (index_of(row[k], 6 * count, "a motion", path, line) - 1 - 6 * which for k in (0, 1))
        if 0 <= i < 6 and 0 <= j < 6:
            if not math.isfinite(row[2]):
                raise HydrodynamicsError("the restoring is not a number", path, line)
            matrix[i, j] = row[2] * specific_npm3 * length_m ** (2 + (i > 2) + (j > 2))
    # WAMIT writes all entries or the upper half.
    for i in range(6):
        for j in range(i):
            if matrix[i, j] == 0.0 and i in (3, 4) and j in (2, 3):
                matrix[i, j] = matrix[j, i]
    return matrix


def read_drift(panel: Panel, base: Path, which: int, count: int, column: str, length: float) -> None:
    """Mean drift of `.8` (by the momentum far away) or `.9` (by the pressure)."""
    for end in (".8", ".9"):
        path = with_end(base, end)
        if not path.is_file():
            continue
        if end == ".8" and count > 1:
            panel.notes.append(f"Left out: the mean drift of {path.name} is that of all bodies together.")
            continue
        drift = np.full((len(panel.wave_omega), len(panel.headings_deg), 3), np.nan)
        headings = list(panel.headings_deg)
        found = False
        scale = panel.water_kgpm3 * panel.gravity_mps2
        for line, row in rows(path, (8,)):
            k = int(abs(row[3])) - 1 - 6 * which
            if row[0] <= 0 or row[1] != row[2] or k not in (0, 1, 5):
                continue
            w = omega(column, row[0], length, panel.depth_m, panel.gravity_mps2)
            near = int(np.argmin(np.abs(panel.wave_omega - w)))
            at = [m for m, heading in enumerate(headings) if abs(heading - row[1]) < 1e-3]
            if abs(panel.wave_omega[near] / w - 1.0) > 1e-4 or not at:
                continue
            drift[near, at[0], (0, 1, 5).index(k)] = scale * length ** (1 + (k > 2)) * row[6]
            found = True
        if found:
            panel.drift = drift
            return
        panel.notes.append(f"Left out: {path.name} has no mean drift at the frequencies and headings of the exciting forces.")


def recognised(panel: Callable[[str], Panel], columns: list[str], path: Path) -> tuple[str, str]:
    """What the first column is, by Haskind's relation."""
    ask = 'give first_column, as first_column = "period"'
    known = [(off[0], column) for column in columns if (off := contradiction(panel(column))) is not None]
    if not known:
        raise HydrodynamicsError(
            "nothing says what the first column is (a period, a frequency, a wave number), and the headings are too few for damping and exciting "
            f"forces to tell: {ask}",
            path,
        )
    found = sorted(known)
    best, column = found[0]
    rest = found[1:]
    if rest and {column, rest[0][1]} == {"deep wave number", "wave number"} and rest[0][0] - best < 1e-6:
        # In deep water they are the same.
        column, rest = "wave number", rest[1:]
    if best > FAR:
        depths = [(off[0], off[1], name) for name in columns if (off := best_depth(panel(name))) is not None]
        near, depth, name = min(depths, default=(math.inf, math.inf, ""))
        if near < SHALLOW:
            raise HydrodynamicsError(
                f"the depth is taken as {metres(panel(name).depth_m, 6)}, but damping and exciting forces contradict each other then (Haskind's "
                f"relation), whatever the first column is taken for; in about {metres(depth, 2)}, with the {name} in the first column, they agree "
                f"within {100 * (math.exp(near) - 1):.0f} %",
                path,
                1,
            )
        raise HydrodynamicsError(
            "damping and exciting forces contradict each other (Haskind's relation) whatever the first column is taken for; taken as "
            + ", ".join(f"{name}: by a factor of {math.exp(off):.2g}" for off, name in found)
            + ". Are length_m, depth_m and the files of one run?",
            path,
            1,
        )
    is_clear = not rest or rest[0][0] - best >= CLEAR or (best < 0.05 and rest[0][0] > 3.0 * 0.05)
    if not is_clear:
        raise HydrodynamicsError(
            f"nothing says what the first column is, and it may be the {column} or the {rest[0][1]}: {ask}", path
        )
    other = f"; as {rest[0][1]} they are off by a factor of {math.exp(rest[0][0]):.2g}" if rest else ""
    return column, f"damping and exciting forces agree within {100 * (math.exp(best) - 1):.0f} % then (Haskind's relation){other}"


def contradicted(panel: Callable[[str], Panel], column: str, path: Path, by: str) -> None:
    """An error if the first column cannot be what it is said to be."""
    own = contradiction(panel(column))
    if own is not None and own[0] <= FAR:
        return
    others = [(contradiction(panel(name)), name) for name in COLUMNS.values() if name != column]
    best = min(((off[0], name) for off, name in others if off is not None), default=(math.inf, ""))
    if best[0] < FAR and (own is None or best[0] < 0.5 * own[0]):
        words = (
            "the waves would be shorter than the headings resolve"
            if own is None
            else f"damping and exciting forces are off by a factor of {math.exp(own[0]):.2g} (Haskind's relation)"
        )
        raise HydrodynamicsError(
            f"the first column is taken for the {column} ({by}), but then {words}; as {best[1]} damping and exciting forces agree within "
            f"{100 * (math.exp(best[0]) - 1):.0f} %",
            path,
            1,
        )
