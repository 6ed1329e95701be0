"""Surveys as grids: GeoTIFF and BAG by rasterio, NetCDF by xarray, to an ESRI ASCII grid in metres about the origin."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from fenderline.charts._area import Area
from fenderline.charts._errors import ChartError, missing

MOST_NODES = 2_000_000
"""Most nodes of a grid: its file then has at most 16 MB, which is what the program reads."""

RASTERS = (".tif", ".tiff", ".bag", ".vrt", ".img")
NETCDF = (".nc", ".nc4", ".cdf")
NO_DATA = -32767.0


@dataclass
class Source:
    """A grid as its file has it."""

    values: Any
    """Depths or heights, by rows from the first (m); NaN: no data."""
    transform: Any
    """From columns and rows to coordinates."""
    crs: Any
    """The coordinate system."""


@dataclass
class Grid:
    """A survey in metres about the origin."""

    file: Path
    cell_m: float
    corner_m: tuple[float, float]
    """West and south edge (m)."""
    values: Any
    """By rows from the north; NaN: no data (m)."""

    def text(self) -> str:
        """The grid as ESRI ASCII."""
        import numpy as np

        rows, columns = self.values.shape
        head = (
            f"ncols {columns}\nnrows {rows}\nxllcorner {self.corner_m[0]:.3f}\nyllcorner {self.corner_m[1]:.3f}\n"
            f"cellsize {self.cell_m:g}\nNODATA_value {NO_DATA:.0f}\n"
        )
        shown = np.where(np.isfinite(self.values), self.values, NO_DATA)
        lines = (" ".join(f"{value:.2f}".removesuffix(".00") for value in row) for row in shown)
        return head + "\n".join(lines) + "\n"


def is_survey(file: Path) -> bool:
    """Whether a file has the name of a survey that is converted."""
    return file.suffix.lower() in RASTERS + NETCDF


def read(file: Path, area: Area | None, origin: tuple[float, float] | None, cell_m: float | None, crs: str | None, variable: str | None) -> tuple[Grid, Area]:
    """Reads a survey, and brings it to metres east and north of the origin, by the transverse Mercator projection through the origin."""
    try:
        import rasterio
        import rasterio.warp
    except ImportError as error:
        raise missing("rasterio") from error
    import numpy as np

    if not file.is_file():
        raise ChartError("there is no such file", file)
    source = _of_netcdf(file, crs, variable) if file.suffix.lower() in NETCDF else _of_raster(rasterio, file, crs)
    if not np.isfinite(source.values).any():
        raise ChartError("it has no data", file)
    rows, columns = source.values.shape
    corners = [_at(source.transform, *at) for at in ((0, 0), (columns, 0), (0, rows), (columns, rows))]
    xs, ys = [corner[0] for corner in corners], [corner[1] for corner in corners]
    try:
        west, south, east, north = rasterio.warp.transform_bounds(source.crs, "EPSG:4326", min(xs), min(ys), max(xs), max(ys))
    except Exception as error:
        raise ChartError(f"its coordinates cannot be brought to longitude and latitude: {error}", file) from error
    if area is None:
        area = Area(west, south, east, north).checked()
    elif area.east <= west or area.west >= east or area.north <= south or area.south >= north:
        raise ChartError(f"it lies outside the area {area}: it covers {west:.4f},{south:.4f},{east:.4f},{north:.4f}", file)
    latitude, longitude = origin or area.origin
    metres = f"+proj=tmerc +lat_0={latitude} +lon_0={longitude} +k=1 +x_0=0 +y_0=0 +ellps=WGS84 +units=m +no_defs"
    low_x, low_y, high_x, high_y = rasterio.warp.transform_bounds("EPSG:4326", metres, max(west, area.west), max(south, area.south), min(east, area.east), min(north, area.north))
    if cell_m is None:
        cell_m = _own_cell_m(rasterio, source, metres)
    # Whole cells, so that two surveys of an area have the same nodes.
    low_x, low_y = (math.floor(value / cell_m) * cell_m for value in (low_x, low_y))
    size = [max(2, math.ceil((high - low) / cell_m)) for low, high in ((low_x, high_x), (low_y, high_y))]
    if size[0] * size[1] > MOST_NODES:
        least_m = cell_m * math.sqrt(size[0] * size[1] / MOST_NODES)
        raise ChartError(f"with cells of {cell_m:g} m it has {size[0] * size[1]} nodes, but at most {MOST_NODES} are written: cut it with --area, or take --cell {math.ceil(least_m)}", file)
    values = np.full((size[1], size[0]), np.nan, dtype="float64")
    transform = rasterio.Affine(cell_m, 0.0, low_x, 0.0, -cell_m, low_y + size[1] * cell_m)
    rasterio.warp.reproject(
        source.values.astype("float64"),
        values,
        src_transform=source.transform,
        src_crs=source.crs,
        src_nodata=np.nan,
        dst_transform=transform,
        dst_crs=metres,
        dst_nodata=np.nan,
        resampling=rasterio.warp.Resampling.bilinear,
    )
    if not np.isfinite(values).any():
        raise ChartError(f"it has no data in the area {area}", file)
    return Grid(file, cell_m, (low_x, low_y), values), area


def _at(transform: Any, column: float, row: float) -> tuple[float, float]:
    """Coordinates of a column and a row."""
    return transform.a * column + transform.b * row + transform.c, transform.d * column + transform.e * row + transform.f


def _own_cell_m(rasterio: Any, source: Source, metres: str) -> float:
    """Side of a cell as the file has it, rounded to two digits (m)."""
    rows, columns = source.values.shape
    middle = _at(source.transform, columns / 2, rows / 2)
    beside = _at(source.transform, columns / 2 + 1, rows / 2 + 1)
    xs, ys = rasterio.warp.transform(source.crs, metres, [middle[0], beside[0]], [middle[1], beside[1]])
    cell_m = float(min(abs(xs[1] - xs[0]), abs(ys[1] - ys[0])))
    digits = 1 - math.floor(math.log10(cell_m))
    return max(0.1, round(cell_m, digits))


def _of_raster(rasterio: Any, file: Path, crs: str | None) -> Source:
    import numpy as np

    try:
        with rasterio.open(file) as data:
            values = data.read(1, masked=True).astype("float64").filled(np.nan)
            own_crs, transform = data.crs, data.transform
    except Exception as error:
        raise ChartError(f"rasterio cannot read it: {error}", file) from error
    system = _system(rasterio, crs) if crs else own_crs
    if system is None:
        raise ChartError("it does not say its coordinate system: give one with --crs, such as EPSG:32618", file)
    return Source(values, transform, system)


def _system(rasterio: Any, crs: str) -> Any:
    try:
        return rasterio.crs.CRS.from_user_input(crs)
    except Exception as error:
        raise ChartError(f"{crs!r} is not a coordinate system: {error}") from error


def _of_netcdf(file: Path, crs: str | None, variable: str | None) -> Source:
    import numpy as np
    import rasterio

    try:
        import xarray
    except ImportError as error:
        raise missing("xarray") from error
    try:
        with xarray.open_dataset(file) as data:
            planes = [str(name) for name, one in data.data_vars.items() if one.squeeze().ndim == 2 and one.dtype.kind in "fiu"]
            if variable is None and len(planes) != 1:
                raise ChartError(f"it has {len(planes)} variables of two dimensions ({', '.join(planes) or 'none'}): name one with --variable", file)
            name = variable or planes[0]
            if name not in data.data_vars or name not in planes:
                raise ChartError(f"it has no variable {name!r} of two dimensions, but {', '.join(planes) or 'none'}", file)
            plane = data[name].squeeze().load()
            y_name, x_name = (str(dimension) for dimension in plane.dims)
            if x_name.lower() in ("lat", "latitude", "y") and y_name.lower() in ("lon", "longitude", "x"):
                plane, (y_name, x_name) = plane.transpose(), (x_name, y_name)
            if x_name not in plane.coords or y_name not in plane.coords:
                raise ChartError(f"{name!r} has no coordinates for {y_name} and {x_name}: grids with coordinates in two dimensions are not read", file)
            xs, ys = (np.asarray(plane.coords[of].values, dtype="float64") for of in (x_name, y_name))
            values = np.asarray(plane.values, dtype="float64")
    except ChartError:
        raise
    except Exception as error:
        raise ChartError(f"xarray cannot read it: {error}", file) from error
    steps = []
    for of, axis in ((x_name, xs), (y_name, ys)):
        if len(axis) < 2:
            raise ChartError(f"{of} has fewer than two values", file)
        step = (axis[-1] - axis[0]) / (len(axis) - 1)
        if step == 0 or not np.allclose(np.diff(axis), step, rtol=1e-3):
            raise ChartError(f"the steps of {of} are not equal: such a grid is not read", file)
        steps.append(step)
    are_degrees = all(word in of.lower() for word, of in (("lon", x_name), ("lat", y_name)))
    if crs is None and not are_degrees:
        raise ChartError("it does not say its coordinate system: give one with --crs, such as EPSG:32618", file)
    system = _system(rasterio, crs or "EPSG:4326")
    return Source(values, rasterio.Affine(steps[0], 0.0, xs[0] - steps[0] / 2, 0.0, steps[1], ys[0] - steps[1] / 2), system)
