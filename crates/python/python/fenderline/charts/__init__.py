"""Electronic charts, surveys and currents to the files that a scenario names.

``python -m fenderline.charts US4MD81M.000 --area "-76.42,38.36,-76.35,38.42" -o cove/`` reads the cell with its updates and writes one
GeoJSON file for each class, with the names of S-57, and ``chart.toml``: the tables ``[chart]`` and ``[environment.bottom]`` of a scenario.
A survey (GeoTIFF, BAG, NetCDF) is written as an ESRI ASCII grid in metres east and north of the origin. The current of a hydrodynamic model
(NetCDF on regular, curvilinear and triangular meshes, SELAFIN) is written as the CSV file of ``[environment.current]``, by time and place.

:func:`convert` does the same from Python. What cannot be converted is a :class:`ChartError`.

The extra ``charts`` has what this needs: ``pip install "fenderline[charts]"``. GDAL comes with pyogrio, and with GDAL the reader of S-57. The files
are not for navigation.
"""

from __future__ import annotations

import datetime
import os
import shutil
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from fenderline.charts import _current, _s57, _survey
from fenderline.charts._area import Area
from fenderline.charts._errors import ChartError
from fenderline.charts._write import layer_text, snippet

__all__ = ["Area", "ChartError", "Converted", "convert"]


@dataclass(frozen=True)
class Converted:
    """What was written."""

    folder: Path
    """The folder with the files."""
    snippet: str
    """The tables for the scenario, as in ``chart.toml``."""
    written: dict[str, int]
    """Features that were written, by class."""
    outside: dict[str, int]
    """Features of the classes that are read, but lie outside the area, by class."""
    not_read: dict[str, int]
    """Features of classes that are not read, by class."""
    surveys: tuple[str, ...]
    """Names of the surveys' files."""
    current: str | None = None
    """Name of the current's file."""
    current_told: tuple[str, ...] = ()
    """How the current was read."""

    def __str__(self) -> str:
        def listed(of: dict[str, int]) -> str:
            return ", ".join(f"{count} {name}" for name, count in of.items()) or "none"

        lines = [f"written to {self.folder}: {listed(self.written)}" if self.written else f"written to {self.folder}"]
        if self.surveys:
            lines.append(f"surveys: {', '.join(self.surveys)}")
        if self.current:
            lines.append(f"current: {self.current}")
            lines += [f"  {told}" for told in self.current_told]
        if self.outside:
            lines.append(f"outside the area: {listed(self.outside)}")
        if self.not_read:
            lines.append(f"classes that are not read: {listed(self.not_read)}")
        return "\n".join(lines)


def convert(
    files: Sequence[str | Path] | str | Path,
    folder: str | Path,
    *,
    area: Area | str | None = None,
    origin: tuple[float, float] | None = None,
    cell_m: float | None = None,
    crs: str | None = None,
    variable: str | None = None,
    current: str | Path | None = None,
    current_variables: tuple[str, str] | None = None,
    current_axes: str | None = None,
    current_layer: int | None = None,
    current_start: datetime.datetime | str | None = None,
    current_hours: float | None = None,
    current_cell_m: float | None = None,
) -> Converted:
    """Converts charts, surveys and a current into a new folder, which then is complete or absent.

    Parameters
    ----------
    files
        Cells of S-57 (``.000``; updates beside them are applied), other files with layers that are named as the classes of S-57, and surveys
        (``.tif``, ``.bag``, ``.nc``).
    folder
        The folder to make. It must not exist, or be empty.
    area
        What is cut out: west, south, east, north (degrees), or ``"W,S,E,N"``. All of the first survey, or of the charts, if left out.
    origin
        Latitude and longitude of the scenario's origin (degrees); the middle of the area if left out.
    cell_m, crs, variable
        Of surveys: side of a cell (m), coordinate system where the file does not say it (also of the current), and variable of a NetCDF file.
    current
        The current of a hydrodynamic model: NetCDF (regular, curvilinear, UGRID) or SELAFIN (``.slf``). No other file is needed then.
    current_variables
        Names of the two components, where the converter does not know them.
    current_axes
        Of a curvilinear grid: ``"east"`` if the components are to the east and north, ``"grid"`` if they are along the lines of the grid.
    current_layer
        Which layer of a current by depth is taken, counted from 0 in the order of the file.
    current_start, current_hours
        The time in the file that is time 0 of the scenario (its first time if left out), and how long the file must cover from then on.
    current_cell_m
        Distance of the nodes of the current that is written (m).
    """
    paths = [Path(file) for file in ([files] if isinstance(files, str | Path) else files)]
    if not paths and current is None:
        raise ChartError("there is no file to convert")
    if isinstance(area, str):
        area = Area.of(area)
    if cell_m is not None and not 0.1 <= cell_m <= 10_000:
        raise ChartError(f"a cell is from 0.1 to 10000 m, but is {cell_m:g} m")
    choices = _current_choices(current, current_variables, current_axes, current_layer, current_start, current_hours, current_cell_m, crs)
    target = Path(folder)
    if target.exists() and (not target.is_dir() or any(target.iterdir())):
        raise ChartError("it exists already, and is not an empty folder", target)
    cells = [_s57.read(path, area) for path in paths if not _survey.is_survey(path)]
    features: dict[str, list[dict[str, object]]] = {}
    found: dict[str, int] = {}
    for cell in cells:
        for layer, of_layer in cell.features.items():
            features.setdefault(layer, []).extend(of_layer)
        for layer, count in cell.found.items():
            found[layer] = found.get(layer, 0) + count
    if cells and not any(layer in _s57.CLASSES for layer in found):
        raise ChartError("it has no class of S-57 that is read, such as DEPARE", cells[0].file)
    if cells and not any(features.values()):
        raise ChartError(f"nothing of the chart lies in the area {area}", cells[0].file)
    if area is None and cells:
        area = _bounds(features)
    texts: dict[str, str] = {f"{layer}.geojson": layer_text(layer, features[layer]) for layer in _s57.CLASSES if features.get(layer)}
    charts, surveys = tuple(texts), []
    for path in paths:
        if _survey.is_survey(path):
            grid, area = _survey.read(path, area, origin, cell_m, crs, variable)
            name = f"{path.stem}.asc"
            if name in texts:
                raise ChartError(f"two surveys have the name {path.stem}", path)
            texts[name] = grid.text()
            surveys.append(name)
    flow = None
    if current is not None:
        flow, area = _current.read(Path(current), area, origin, choices)
        if f"{flow.file.stem}.csv" in texts:
            raise ChartError(f"two files have the name {flow.file.stem}", flow.file)
        texts[f"{flow.file.stem}.csv"] = flow.text
    assert area is not None
    about = [cell.about or cell.file.name for cell in cells]
    text = snippet(area, origin or area.origin, charts, surveys, about, (f"{flow.file.stem}.csv", flow.told) if flow else None)
    texts["chart.toml"] = text
    _write(target, texts)
    written = {layer: len(features[layer]) for layer in _s57.CLASSES if features.get(layer)}
    outside = {layer: found[layer] - written.get(layer, 0) for layer in _s57.CLASSES if found.get(layer, 0) > written.get(layer, 0)}
    not_read = {layer: count for layer, count in sorted(found.items()) if layer not in _s57.CLASSES and count}
    of_current = (f"{flow.file.stem}.csv", tuple(flow.told)) if flow else (None, ())
    return Converted(target, text, written, outside, not_read, tuple(surveys), *of_current)


def _current_choices(
    current: str | Path | None,
    variables: tuple[str, str] | None,
    axes: str | None,
    layer: int | None,
    start: datetime.datetime | str | None,
    hours: float | None,
    cell_m: float | None,
    crs: str | None,
) -> _current.Choices:
    """What was chosen for the current, checked."""
    if current is None and any(given is not None for given in (variables, axes, layer, start, hours, cell_m)):
        raise ChartError("a choice for a current is given, but no current")
    if axes not in (None, "east", "grid"):
        raise ChartError(f"the axes of a current are east or grid, but are {axes!r}")
    if variables is not None and len(variables) != 2:
        raise ChartError("a current has two variables: to the east and to the north")
    if hours is not None and not 0 < hours < 1e6:
        raise ChartError(f"the hours of a current are positive, but are {hours:g}")
    if cell_m is not None and not 1 <= cell_m <= 100_000:
        raise ChartError(f"the cell of a current is from 1 to 100000 m, but is {cell_m:g} m")
    if isinstance(start, str):
        try:
            start = datetime.datetime.fromisoformat(start)
        except ValueError:
            raise ChartError(f"the start of a current is a time such as 2026-05-01T06:00, but is {start!r}") from None
    if start is not None and start.tzinfo is not None:
        start = start.astimezone(datetime.timezone.utc).replace(tzinfo=None)
    return _current.Choices(variables, axes, layer, start, hours, cell_m, crs)


def _bounds(features: dict[str, list[dict[str, object]]]) -> Area:
    """The rectangle around all features."""
    low, high = [180.0, 90.0], [-180.0, -90.0]

    def widen(coordinates: object) -> None:
        assert isinstance(coordinates, list)
        if coordinates and isinstance(coordinates[0], int | float):
            for axis in (0, 1):
                low[axis], high[axis] = min(low[axis], coordinates[axis]), max(high[axis], coordinates[axis])
        else:
            for part in coordinates:
                widen(part)

    for of_layer in features.values():
        for feature in of_layer:
            geometry = feature["geometry"]
            assert isinstance(geometry, dict)
            widen(geometry["coordinates"])
    return Area(low[0], low[1], high[0], high[1]).checked()


def _write(target: Path, texts: dict[str, str]) -> None:
    """Writes all files into a folder beside the target, which then gets its name."""
    try:
        parent = target.resolve().parent
        parent.mkdir(parents=True, exist_ok=True)
        beside = Path(tempfile.mkdtemp(prefix=".charts-", dir=parent))
        try:
            for name, text in texts.items():
                (beside / name).write_text(text, encoding="utf-8", newline="\n")
            beside.chmod(0o755)
            if target.exists():
                target.rmdir()
            os.replace(beside, target)
        except BaseException:
            shutil.rmtree(beside, ignore_errors=True)
            raise
    except OSError as error:
        raise ChartError(f"it cannot be written: {error.strerror or error}", target) from error
