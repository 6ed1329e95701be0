"""Measured tracks: CSV files of time, place and heading, with the units of their columns in a mapping."""

from __future__ import annotations

import csv
import math
import os
import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from fenderline.identify import _units
from fenderline.identify._errors import TrackError

Floats = npt.NDArray[np.float64]
#: A mapping: a path of a TOML file, or the table itself.
AnyMapping = str | os.PathLike[str] | Mapping[str, Any]

#: The dimension of each quantity of a track, and the usual names of its column.
_USUAL: dict[str, tuple[str, tuple[str, ...]]] = {
    "time": ("time", ("time", "t", "times", "utc", "timestamp", "datetime")),
    "north": ("length", ("north", "northing", "x")),
    "east": ("length", ("east", "easting", "y")),
    "latitude": ("angle", ("latitude", "lat")),
    "longitude": ("angle", ("longitude", "lon", "long", "lng")),
    "heading": ("angle", ("heading", "hdg", "hdt", "psi")),
    "ship": ("", ("mmsi", "ship", "vessel", "name")),
}
_KEYS = {"columns", "controls", "names", "separator", "skip_lines", "lost", "start", "end", "origin", "antenna", "longest_gap", "spacing", "fastest", "scale", "ship", "repeated"}
#: Half-axes of the ellipsoid WGS 84 (m), squared eccentricity.
_A_M, _E2 = 6378137.0, 6.69437999014e-3
_MOST_BYTES = 64 << 20


@dataclass(frozen=True)
class Track:
    """A measured track: where an antenna on board was at each time, and the heading."""

    file: str
    """The file, for messages."""
    lines: npt.NDArray[np.int64]
    """Line of the file of each row."""
    time_s: Floats
    """Time of the scenario (s), increasing."""
    north_m: Floats
    """Place of the antenna (m)."""
    east_m: Floats
    """Place of the antenna (m)."""
    heading_rad: Floats
    """Heading, clockwise from north, without jumps at a full turn (rad)."""
    controls: dict[str, Floats] = field(default_factory=dict)
    """Measured orders by the name of the control, as in ``Fleet.control_names``."""
    antenna_m: tuple[float, float] = (0.0, 0.0)
    """Place of the antenna forward and to starboard of midship (m)."""
    is_placed: bool = True
    """Whether the places belong to the axes of the scenario; else the track begins where the scenario begins."""
    remarks: tuple[str, ...] = ()
    """What was guessed and left out."""

    def __len__(self) -> int:
        return len(self.time_s)

    def moved(self, north_m: float, east_m: float) -> Track:
        """The track moved by a distance."""
        return replace(self, north_m=self.north_m + north_m, east_m=self.east_m + east_m, is_placed=True)


def read_track(path: str | os.PathLike[str], mapping: AnyMapping | None = None) -> Track:
    """Reads a track from a CSV file.

    Columns with usual names (``time``, ``north`` and ``east`` or ``latitude`` and ``longitude``, ``heading``) are found, with a unit in
    brackets as in ``north [ft]``; without a unit a time is in seconds, a length in metres, an angle in degrees. For all else there is the
    mapping, a TOML file or a table with these keys:

    - ``columns``: for each quantity the column's name, or ``{ column = "x", unit = "ft", factor = -1 }``;
    - ``controls``: likewise for measured orders, such as ``"ship.rudder_rad" = { column = "rudder", unit = "deg" }``;
    - ``names``: the names of the columns of a file without a head line; ``skip_lines``: lines above; ``separator``;
    - ``lost``: cells that mean "no reading": rows with such a cell are left out;
    - ``start``, ``end``: first and last time that is used, in the time of the file; ``start`` is time 0 of the scenario;
    - ``spacing``: least time between two rows that are used, for logs with many rows a second;
    - ``origin``: latitude and longitude of the scenario's origin (degrees);
    - ``antenna``: place forward and to starboard of midship;
    - ``longest_gap`` (60 s) and ``fastest`` (20 m/s): a longer gap or a faster ship is an error;
    - ``scale``: a model's scale, by which a track in full scale is made one of the model (Froude's law);
    - ``ship``: the ship whose rows are used, where a column ``ship`` has several; ``repeated = "first"``: of rows with one time the first is used.

    Raises :class:`TrackError`, with file and line.
    """
    return _Reader(str(path), _mapping(mapping, str(path))).track()


def _mapping(given: AnyMapping | None, file: str) -> Mapping[str, Any]:
    if given is None:
        return {}
    name, table = file, given
    if not isinstance(given, Mapping):
        name = os.fspath(given)
        try:
            table = tomllib.loads(Path(given).read_text("utf-8"))
        except OSError as error:
            raise TrackError(f"the mapping cannot be read: {error.strerror}", name) from None
        except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
            raise TrackError(f"the mapping is not TOML: {error}", name) from None
    assert isinstance(table, Mapping)
    for key in table:
        if key not in _KEYS:
            raise TrackError(f"{key!r} is not a key of a mapping; there are: {', '.join(sorted(_KEYS))}", name)
    return table


class _Reader:
    def __init__(self, file: str, mapping: Mapping[str, Any]) -> None:
        self.file = file
        self.mapping = mapping
        self.remarks: list[str] = []

    def wrong(self, message: str, line: int | None = None) -> TrackError:
        return TrackError(message, self.file, line)

    def quantity(self, key: str, dimension: str, default: float) -> float:
        given = self.mapping.get(key)
        if given is None:
            return default
        value = _units.quantity(given, dimension)
        if value is None:
            raise self.wrong(f"`{key}` of the mapping is {given!r}, which is no {dimension}: write it as \"60 s\" or a number in SI units")
        return value

    def bound(self, key: str, default: float) -> float:
        """A time of the file: seconds, or a date where the file has dates."""
        given = self.mapping.get(key)
        try:
            # A plain number, as 20260501, is no date.
            date = datetime.fromisoformat(given if isinstance(given, str) else "")
        except ValueError:
            return self.quantity(key, "time", default)
        return (date if date.tzinfo else date.replace(tzinfo=UTC)).timestamp()

    # The file.

    def rows(self) -> tuple[list[str], list[tuple[int, list[str]]]]:
        """Names of the columns, and line and cells of each row."""
        try:
            if os.path.getsize(self.file) > _MOST_BYTES:
                raise self.wrong(f"the file is larger than {_MOST_BYTES >> 20} MiB")
            text = Path(self.file).read_text("utf-8-sig")
        except OSError as error:
            raise self.wrong(f"the file cannot be read: {error.strerror}") from None
        except UnicodeDecodeError as error:
            raise self.wrong(f"the file is not a text in UTF-8: byte {error.start}") from None
        skipped = self.mapping.get("skip_lines", 0)
        if not isinstance(skipped, int) or skipped < 0:
            raise self.wrong(f"`skip_lines` of the mapping is {skipped!r}, and must be a whole number")
        numbered = [(line, row) for line, row in enumerate(text.splitlines(), 1) if line > skipped and row.strip() and not row.lstrip().startswith("#")]
        if not numbered:
            raise self.wrong("the file has no rows")
        cut = self.cutter(numbered[0][1])
        names = self.mapping.get("names")
        if names is None:
            names = [name.strip() for name in cut(numbered[0][1])]
            numbered = numbered[1:]
        elif not isinstance(names, list) or not all(isinstance(name, str) for name in names):
            raise self.wrong("`names` of the mapping must be a list of texts")
        rows = []
        for line, row in numbered:
            cells = cut(row)
            if len(cells) < len(names):
                raise self.wrong(f"the row has {len(cells)} cells, but there are {len(names)} columns", line)
            rows.append((line, cells))
        return names, rows

    def cutter(self, first: str) -> Any:
        """How a row is cut into cells."""
        separator = self.mapping.get("separator")
        if separator is None:
            separator = max([",", ";", "\t"], key=first.count)
            if first.count(separator) == 0:
                separator = " "
        if separator == " ":
            return str.split
        if not isinstance(separator, str) or len(separator) != 1:
            raise self.wrong(f"`separator` of the mapping is {separator!r}, and must be one character")
        return lambda row: next(csv.reader([row], delimiter=separator, skipinitialspace=True))

    # The columns.

    def column(self, quantity: str, given: object, names: list[str], dimension: str) -> tuple[int, float] | None:
        """Place of a quantity's column, and the SI value of its unit."""
        unit, by, name = None, 1.0, given
        if isinstance(given, Mapping):
            for key in given:
                if key not in ("column", "unit", "factor"):
                    raise self.wrong(f"column `{quantity}` of the mapping has the key {key!r}; there are: column, unit, factor")
            name, unit, by = given.get("column"), given.get("unit"), given.get("factor", 1.0)
        if given is not None:
            if not isinstance(name, str) or not isinstance(by, int | float) or not math.isfinite(by) or by == 0.0:
                raise self.wrong(f"column `{quantity}` of the mapping is {given!r}: write a name, or {{ column = \"x\", unit = \"m\" }}")
            if name not in names:
                raise self.wrong(f"there is no column {name!r} for `{quantity}`; there are: {', '.join(names)}")
            place = names.index(name)
        else:
            bare = [_bare(name) for name in names]
            found = [place for place, name in enumerate(bare) if name in _USUAL[quantity][1]]
            if not found:
                return None
            place = found[0]
            self.remarks.append(f"column {names[place]!r} is taken for the {quantity}")
        if dimension == "":
            return place, 1.0
        if unit is None:
            bracket = re.search(r"[\[(]\s*([^\])]+?)\s*[\])]", names[place])
            suffix = re.search(r"_(m|s|deg|rad|ft)$", names[place])
            unit = bracket[1] if bracket else suffix[1] if suffix else next(iter(_units.UNITS[dimension]))
        of = _units.factor(str(unit), dimension)
        if of is None:
            known = ", ".join(_units.UNITS[dimension])
            raise self.wrong(f"the unit of column {names[place]!r} is {unit!r}, which is no {dimension}; there are: {known}")
        return place, of * float(by)

    def number(self, cells: list[str], place: int, names: list[str], line: int) -> float:
        cell = cells[place].strip()
        try:
            value = float(cell)
        except ValueError:
            if cell == "":
                raise self.wrong(f"column {names[place]!r} is empty; if that means no reading, write lost = [\"\"] into the mapping", line) from None
            raise self.wrong(f"column {names[place]!r} is {cell!r}, which is no number", line) from None
        if not math.isfinite(value):
            raise self.wrong(f"column {names[place]!r} is {cell}, which is no reading", line)
        return value

    def moment(self, cells: list[str], place: int, names: list[str], line: int, of: float) -> float:
        cell = cells[place].strip()
        try:
            return self.number(cells, place, names, line) * of
        except TrackError:
            try:
                date = datetime.fromisoformat(cell)
            except ValueError:
                raise self.wrong(f"column {names[place]!r} is {cell!r}, which is neither a number nor a time as 2026-05-01T06:00:00Z", line) from None
        return (date if date.tzinfo else date.replace(tzinfo=UTC)).timestamp()

    # The track.

    def track(self) -> Track:
        names, rows = self.rows()
        columns = self.mapping.get("columns", {})
        if not isinstance(columns, Mapping):
            raise self.wrong("`columns` of the mapping must be a table")
        for quantity in columns:
            if quantity not in _USUAL:
                raise self.wrong(f"`columns` of the mapping has {quantity!r}; there are: {', '.join(_USUAL)}")
        at = {quantity: self.column(quantity, columns.get(quantity), names, _USUAL[quantity][0]) for quantity in _USUAL}
        time, heading, ship = at["time"], at["heading"], at["ship"]
        is_earth = at["north"] is None and at["east"] is None
        first, second = (at["latitude"], at["longitude"]) if is_earth else (at["north"], at["east"])
        missing = [name for name, found in (("time", time), ("heading", heading), ("latitude" if is_earth else "north", first), ("longitude" if is_earth else "east", second)) if found is None]
        if time is None or heading is None or first is None or second is None:
            raise self.wrong(f"no column for the {' and the '.join(missing)}; there are: {', '.join(names)}. Name the columns in a mapping")
        controls = {}
        for name, given in dict(self.mapping.get("controls", {})).items():
            dimension = "angle" if name.endswith("_rad") else "share"
            found = self.column(name, given, names, dimension)
            assert found is not None
            controls[name] = found
        used = [time, heading, first, second, *controls.values()]
        rows = self.kept(rows, [place for place, _ in used], ship)

        values = np.empty((len(rows), 4 + len(controls)))
        for row, (line, cells) in enumerate(rows):
            values[row, 0] = self.moment(cells, time[0], names, line, time[1])
            for column, (place, of) in enumerate(used[1:], 1):
                values[row, column] = self.number(cells, place, names, line) * of
        lines = np.array([line for line, _ in rows], dtype=np.int64)
        lines, values = self.in_time(lines, values)
        time_s, turned = values[:, 0], np.unwrap(values[:, 1])
        places, is_placed = values[:, 2:4], True
        if is_earth:
            places, turn, is_placed = self.on_plane(lines, places)
            turned = turned + turn
        scale = self.mapping.get("scale", 1.0)
        if isinstance(scale, bool) or not isinstance(scale, int | float) or not 0.0 < scale < 1e4:
            raise self.wrong(f"`scale` of the mapping is {scale!r}, and must be a number above 0")
        self.refuse_jumps(lines, time_s, places)
        antenna = self.mapping.get("antenna", [0.0, 0.0])
        aboard = [_units.quantity(value, "length") for value in antenna] if isinstance(antenna, list) else []
        if len(aboard) != 2 or aboard[0] is None or aboard[1] is None:
            raise self.wrong(f"`antenna` of the mapping is {antenna!r}: write it as [\"-40 m\", \"2 m\"], forward and to starboard of midship")
        self.remarks.append(f"{len(rows)} rows, {len(lines)} used")
        return Track(
            file=self.file,
            lines=lines,
            time_s=time_s / math.sqrt(scale),
            north_m=places[:, 0] / scale,
            east_m=places[:, 1] / scale,
            heading_rad=turned,
            controls={name: values[:, 4 + index] for index, name in enumerate(controls)},
            antenna_m=(aboard[0] / scale, aboard[1] / scale),
            is_placed=is_placed,
            remarks=tuple(self.remarks),
        )

    def kept(self, rows: list[tuple[int, list[str]]], places: list[int], ship: tuple[int, float] | None) -> list[tuple[int, list[str]]]:
        """The rows of the ship that have readings."""
        lost = self.mapping.get("lost", [])
        kept = [(line, cells) for line, cells in rows if not any(cells[place].strip() in lost for place in places)]
        if len(kept) < len(rows):
            self.remarks.append(f"{len(rows) - len(kept)} rows without a reading are left out")
        if ship is not None:
            wanted = self.mapping.get("ship")
            wanted = None if wanted is None else str(wanted)
            seen: dict[str, int] = {}
            for line, cells in kept:
                seen.setdefault(cells[ship[0]].strip(), line)
            if wanted is None and len(seen) > 1:
                other, line = list(seen.items())[1]
                raise self.wrong(f"the file has more than one ship: {', '.join(seen)}; {other} begins here. Choose one by `ship` of the mapping", line)
            if wanted is not None and wanted not in seen:
                raise self.wrong(f"the file has no ship {wanted!r}; there are: {', '.join(seen)}")
            if wanted is not None:
                kept = [(line, cells) for line, cells in kept if cells[ship[0]].strip() == wanted]
        if len(kept) < 10:
            raise self.wrong(f"the track has {len(kept)} rows with readings; at least 10 are needed")
        return kept

    def in_time(self, lines: npt.NDArray[np.int64], values: Floats) -> tuple[npt.NDArray[np.int64], Floats]:
        """The rows between `start` and `end`, with time 0 at `start`; refuses times that do not increase, and long gaps."""
        repeated = self.mapping.get("repeated", "refuse")
        if repeated not in ("refuse", "first"):
            raise self.wrong(f"`repeated` of the mapping is {repeated!r}; there are: \"first\", \"refuse\"")
        if repeated == "first":
            is_new = np.concatenate([[True], np.diff(values[:, 0]) != 0.0])
            if not is_new.all():
                self.remarks.append(f"{np.count_nonzero(~is_new)} rows repeat the time of the row before and are left out")
            lines, values = lines[is_new], values[is_new]
        steps = np.diff(values[:, 0])
        back = np.flatnonzero(steps <= 0.0)
        if len(back):
            row = int(back[0]) + 1
            word = "repeats the time of" if steps[row - 1] == 0.0 else f"is {-steps[row - 1]:g} s before"
            raise self.wrong(f"the time of the row {word} the row before", int(lines[row]))
        start, end = self.bound("start", float(values[0, 0])), self.bound("end", math.inf)
        is_used = (values[:, 0] >= start) & (values[:, 0] <= end)
        if np.count_nonzero(is_used) < 10:
            raise self.wrong(f"{np.count_nonzero(is_used)} rows are between `start` and `end` of the mapping; at least 10 are needed")
        lines, values = lines[is_used], values[is_used]
        longest = self.quantity("longest_gap", "time", 60.0)
        gaps = np.flatnonzero(np.diff(values[:, 0]) > longest)
        if len(gaps):
            row = int(gaps[0]) + 1
            gap = values[row, 0] - values[row - 1, 0]
            raise self.wrong(f"before this row there is no reading for {gap:.4g} s; `longest_gap` of the mapping allows {longest:g} s", int(lines[row]))
        spacing = self.quantity("spacing", "time", 0.0)
        if spacing > 0.0:
            kept, last = [], -math.inf
            for row, time in enumerate(values[:, 0].tolist()):
                # A row that is early by the rounding of its time is in time.
                if time - last > spacing * 0.999:
                    kept.append(row)
                    last = time
            lines, values = lines[kept], values[kept]
            if len(lines) < 10:
                raise self.wrong(f"{len(lines)} rows are left by `spacing` of the mapping; at least 10 are needed")
        values = values.copy()
        values[:, 0] -= start
        return lines, values

    def on_plane(self, lines: npt.NDArray[np.int64], places: Floats) -> tuple[Floats, Floats, bool]:
        """Places on the plane that touches the earth at the origin, the angle from true north to the plane's north, and whether the
        origin is the scenario's."""
        bad = np.flatnonzero((np.abs(places[:, 0]) > 1.5) | (np.abs(places[:, 1]) > 2.0 * math.pi))
        if len(bad):
            raise self.wrong(f"latitude and longitude are {math.degrees(places[bad[0], 0]):.6g}° and {math.degrees(places[bad[0], 1]):.6g}°", int(lines[bad[0]]))
        given = self.mapping.get("origin")
        if given is None:
            origin = places[0]
        elif not isinstance(given, list) or len(given) != 2 or not all(isinstance(value, int | float) for value in given):
            raise self.wrong(f"`origin` of the mapping is {given!r}: write latitude and longitude in degrees, as [53.5, 9.9]")
        else:
            origin = np.radians(np.asarray(given, dtype=float))
        east_by = places[:, 1] - origin[1]
        sines, cosines = np.sin(places[:, 0]), np.cos(places[:, 0])
        across = _A_M / np.sqrt(1.0 - _E2 * sines**2)
        own = _A_M / math.sqrt(1.0 - _E2 * math.sin(origin[0]) ** 2)
        out, up = across * cosines, (1.0 - _E2) * (across * sines - own * math.sin(origin[0]))
        along = out * np.cos(east_by) - own * math.cos(origin[0])
        north = up * math.cos(origin[0]) - along * math.sin(origin[0])
        east = out * np.sin(east_by)
        far = np.flatnonzero(np.hypot(north, east) > 1e5)
        if len(far):
            raise self.wrong("the place is more than 100 km from the origin: another port, or another ship", int(lines[far[0]]))
        # A meridian east of the origin leans to the west on the plane of the northern half.
        return np.column_stack([north, east]), -east_by * math.sin(origin[0]), given is not None

    def refuse_jumps(self, lines: npt.NDArray[np.int64], time_s: Floats, places: Floats) -> None:
        fastest = self.mapping.get("fastest", 20.0)
        if isinstance(fastest, bool) or not isinstance(fastest, int | float) or not fastest > 0.0:
            raise self.wrong(f"`fastest` of the mapping is {fastest!r}, and must be a speed in m/s")
        steps = np.hypot(np.diff(places[:, 0]), np.diff(places[:, 1]))
        # The noise of a receiver is some metres, also between rows that are close in time.
        jumps = np.flatnonzero(steps > fastest * np.diff(time_s) + 30.0)
        if len(jumps):
            row = int(jumps[0]) + 1
            raise self.wrong(
                f"the place is {steps[row - 1]:.4g} m from that of the row before, {time_s[row] - time_s[row - 1]:.3g} s later: another ship, or a reading gone wrong",
                int(lines[row]),
            )


def _bare(name: str) -> str:
    """A column's name without its unit.

    >>> _bare("North [m]"), _bare("heading_deg")
    ('north', 'heading')
    """
    bare = re.sub(r"[\[(].*", "", name).strip().lower()
    return re.sub(r"_(m|s|deg|rad|ft)$", "", bare)
