"""Electronic navigational charts (S-57), read by GDAL through pyogrio, to the features that the program reads."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from fenderline.charts._area import Area
from fenderline.charts._errors import ChartError, missing

CLASSES = (
    "ACHARE BCNCAR BCNISD BCNLAT BCNSAW BCNSPP BERTHS BOYCAR BOYINB BOYISD BOYLAT BOYSAW BOYSPP BRIDGE BUISGL CBLOHD COALNE DEPARE DEPCNT "
    "DRGARE FAIRWY FLODOC HULKES LIGHTS LNDARE LNDMRK MORFAC M_COVR NAVLNE OBSTRN PONTON RECTRC SLCONS SOUNDG UNSARE UWTROC WRECKS"
).split()
"""The object classes that the program reads."""

RECORD_KEEPING = frozenset(
    "RCID PRIM GRUP RVER AGEN FIDN FIDS LNAM LNAM_REFS FFPT_RIND SORDAT SORIND RECDAT RECIND SCAMAX SCAMIN NTXTDS TXTDSC PICREP".split()
)
"""Attributes that say how a chart was made, or at which scale it shows a feature; they are left out."""

NO_FEATURES = frozenset(["DSID", "IsolatedNode", "ConnectedNode", "Edge", "Face"])
"""GDAL's layers that are no object classes."""

DECIMALS = 7
"""Decimals of a degree: the resolution of S-57 cells, about a centimetre."""

OPTIONS = {"UPDATES": "APPLY", "SPLIT_MULTIPOINT": "OFF", "RETURN_PRIMITIVES": "OFF", "RETURN_LINKAGES": "OFF", "LNAM_REFS": "OFF", "RECODE_BY_DSSI": "ON"}
"""How GDAL opens a cell: with its updates, soundings as points of three coordinates, texts as UTF-8."""


@dataclass
class Cell:
    """The features of a chart by class, as GeoJSON."""

    file: Path
    features: dict[str, list[dict[str, Any]]] = field(default_factory=dict)
    """Features of the classes that the program reads."""
    found: dict[str, int] = field(default_factory=dict)
    """Features in the file, by class, for all classes."""
    about: str = ""
    """Name, edition and update of the cell; empty if the file does not say."""


def is_cell(file: Path) -> bool:
    """Whether a file has the name of an S-57 cell, as ``US4MD81M.000``."""
    return len(file.suffix) == 4 and file.suffix[1:].isdigit()


def read(file: Path, area: Area | None) -> Cell:
    """Reads a cell with its updates, which lie beside it, and cuts the area out."""
    try:
        import pyogrio
    except ImportError as error:
        raise missing("pyogrio") from error
    try:
        import shapely
    except ImportError as error:
        raise missing("shapely") from error
    if not file.is_file():
        raise ChartError("there is no such file", file)
    if is_cell(file) and file.suffix != ".000":
        raise ChartError(f"this is an update: name the cell itself, {file.with_suffix('.000').name}; its updates are applied", file)
    options = OPTIONS if is_cell(file) else {}
    try:
        layers = [str(name) for name, _ in pyogrio.list_layers(file)]
    except Exception as error:
        raise ChartError(f"GDAL cannot read it as a chart: {error}", file) from error
    cell = Cell(file)
    cell.about = _about(pyogrio, file, layers, options)
    box = None if area is None else shapely.box(*area.bounds)
    for layer in sorted(layers):
        if layer in NO_FEATURES:
            continue
        try:
            meta, _, shapes, columns = pyogrio.raw.read(file, layer=layer, **options)
        except Exception as error:
            raise ChartError(f"GDAL cannot read the class {layer}: {error}", file) from error
        count = len(columns[0]) if columns else 0
        cell.found[layer] = count
        if layer not in CLASSES or shapes is None:
            continue
        names = [str(name) for name in meta["fields"]]
        features = []
        for shape, row in zip(shapely.from_wkb(shapes), _rows(names, columns), strict=True):
            geometry = _geometry(shapely, shape, box)
            if geometry is not None:
                features.append({"type": "Feature", "properties": row, "geometry": geometry})
        cell.features[layer] = features
    return cell


def _about(pyogrio: Any, file: Path, layers: list[str], options: dict[str, str]) -> str:
    if "DSID" not in layers:
        return ""
    try:
        meta, _, _, columns = pyogrio.raw.read(file, layer="DSID", **options)
    except Exception:
        return ""
    row = next(_rows([str(name) for name in meta["fields"]], columns), {})
    name, edition, update = (row.get(f"DSID_{key}", "") for key in ("DSNM", "EDTN", "UPDN"))
    scale = row.get("DSPM_CSCL")
    return f"cell {name}, edition {edition}, update {update}" + (f", 1:{scale}" if scale else "")


def _rows(names: list[str], columns: Any) -> Iterator[dict[str, Any]]:
    """The attributes of each feature that are set."""
    for values in zip(*columns, strict=True):
        row = {}
        for name, value in zip(names, values, strict=True):
            plain = _plain(value)
            if plain is not None and name not in RECORD_KEEPING:
                row[name] = plain
        yield row


def _plain(value: Any) -> Any:
    """A value of an attribute as JSON has it; None for one that is not set."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, list):
        items = [item for item in (_plain(item) for item in value) if item is not None]
        return items or None
    if isinstance(value, float):
        if not math.isfinite(value):
            return None
        return int(value) if value == int(value) and abs(value) < 1e15 else value
    if isinstance(value, str):
        return value or None
    return value if isinstance(value, int | bool) else None


def _geometry(shapely: Any, shape: Any, box: Any) -> dict[str, Any] | None:
    """A geometry as GeoJSON, cut by the area; None: nothing is left."""
    if shape is None or shape.is_empty:
        return None
    if box is not None:
        if not shape.intersects(box):
            return None
        if not box.covers(shape):
            shape = _cut(shapely, shape, box)
            if shape is None:
                return None
    return {"type": shape.geom_type, "coordinates": _rounded(shapely.geometry.mapping(shape)["coordinates"])}


def _cut(shapely: Any, shape: Any, box: Any) -> Any:
    """The part of a geometry within a rectangle, of the same dimension; None: nothing is left."""
    kind = shape.geom_type
    parts = [shape.intersection(box)]
    wanted = "Point" if kind.endswith("Point") else "LineString" if kind.endswith("LineString") else "Polygon"
    kept = []
    while parts:
        part = parts.pop(0)
        if part.is_empty:
            continue
        if hasattr(part, "geoms"):
            parts = [*part.geoms, *parts]
        elif part.geom_type == wanted:
            kept.append(part)
    if not kept:
        return None
    if wanted == "LineString":
        # Where lines cross the edge they come in pieces, which are joined again.
        merged = shapely.line_merge(shapely.MultiLineString(kept))
        kept = list(merged.geoms) if hasattr(merged, "geoms") else [merged]
    many = {"Point": shapely.MultiPoint, "LineString": shapely.MultiLineString, "Polygon": shapely.MultiPolygon}[wanted]
    return kept[0] if len(kept) == 1 else many(kept)


def _rounded(coordinates: Any) -> Any:
    if isinstance(coordinates, int | float):
        return round(coordinates, DECIMALS)
    return [_rounded(part) for part in coordinates]
