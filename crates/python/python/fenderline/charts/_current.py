"""Currents of hydrodynamic models, to the CSV file of a scenario's current: by time and place, in metres about the origin.

Regular and curvilinear grids and triangular meshes all become triangles between the nodes of the model, in metres. Within a triangle the current
is linear. Where the model has no water there is no triangle, and the current is zero.
"""

from __future__ import annotations

import datetime
import math
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from fenderline.charts import _selafin
from fenderline.charts._area import Area
from fenderline.charts._errors import ChartError, missing

MOST_ROWS = 400_000
"""Most rows of a file: it then has less than the 16 MiB that the program reads."""
FASTEST_MPS = 15.0
"""Fastest current that the program reads (m/s)."""
PAIRS = (
    ("u", "v"), ("ubar", "vbar"), ("ucx", "ucy"), ("mesh2d_ucx", "mesh2d_ucy"), ("mesh2d_ucxa", "mesh2d_ucya"), ("uo", "vo"), ("u_eastward", "v_northward"),
    ("water_u", "water_v"), ("eastward_velocity", "northward_velocity"), ("VELOCITY U", "VELOCITY V"), ("VITESSE U", "VITESSE V"),
)
"""Names of the components in known models, first and second."""


@dataclass
class Model:
    """A current as its file has it."""

    names: tuple[str, str]
    """Names of the components."""
    x: Any
    """First coordinates of the nodes."""
    y: Any
    """Second coordinates of the nodes."""
    triangles: Any
    """Nodes of each triangle."""
    times: list[datetime.datetime] | None
    """Times; none: a steady current."""
    u: Any
    """Component along the first coordinate, by time and node (m/s); NaN: no water."""
    v: Any
    """Component along the second coordinate."""
    degrees: bool
    """Whether the coordinates are longitude and latitude."""
    told: list[str] = field(default_factory=list)
    """How it was read."""


@dataclass
class Current:
    """A current by time and place, in metres about the origin."""

    file: Path
    text: str
    """The CSV file."""
    told: list[str]
    """How it was read."""


@dataclass(frozen=True)
class Choices:
    """What the user chose."""

    variables: tuple[str, str] | None = None
    axes: str | None = None
    """``"east"`` or ``"grid"``."""
    layer: int | None = None
    start: datetime.datetime | None = None
    hours: float | None = None
    cell_m: float | None = None
    crs: str | None = None


def read(file: Path, area: Area | None, origin: tuple[float, float] | None, choices: Choices) -> tuple[Current, Area]:
    """Reads a current, and brings it to a grid in metres north and east of the origin."""
    import numpy as np

    try:
        import rasterio.warp
    except ImportError as error:
        raise missing("rasterio") from error
    if not file.is_file():
        raise ChartError("there is no such file", file)
    model = _of_selafin(file, choices) if file.suffix.lower() in _selafin.SUFFIXES else _of_netcdf(file, choices)
    if model.degrees and not choices.crs:
        system: Any = "EPSG:4326"
    elif choices.crs:
        try:
            system = rasterio.crs.CRS.from_user_input(choices.crs)
        except Exception as error:
            raise ChartError(f"{choices.crs!r} is not a coordinate system: {error}") from error
    else:
        raise ChartError("it does not say its coordinate system: give one with --crs, such as EPSG:32618", file)
    _check_speeds(file, model)
    xs, ys = (np.asarray(axis, dtype="float64") for axis in (model.x, model.y))
    used = np.isfinite(xs) & np.isfinite(ys)
    if not used.any():
        raise ChartError("its nodes have no coordinates", file)
    lon, lat = xs.copy(), ys.copy()
    if not model.degrees or choices.crs:
        where = rasterio.warp.transform(system, "EPSG:4326", xs[used].tolist(), ys[used].tolist())
        lon[used], lat[used] = where[0], where[1]
    else:
        lon = np.where(lon > 180, lon - 360, lon)
    if np.abs(lat[used]).max() > 90:
        raise ChartError(f"a latitude is {float(np.abs(lat[used]).max()):g} degrees: its longitude and latitude look swapped", file)
    bounds = [float(edge) for edge in (lon[used].min(), lat[used].min(), lon[used].max(), lat[used].max())]
    if area is None:
        area = Area(*bounds).checked()
    else:
        _check_area(file, area, bounds)
    latitude, longitude = origin or area.origin
    metres = f"+proj=tmerc +lat_0={latitude} +lon_0={longitude} +k=1 +x_0=0 +y_0=0 +ellps=WGS84 +units=m +no_defs"
    near = used & (np.abs(lon - longitude) < 10) & (np.abs(lat - latitude) < 10)
    east_m, north_m = np.full(xs.shape, np.nan), np.full(xs.shape, np.nan)
    placed = rasterio.warp.transform("EPSG:4326", metres, lon[near].tolist(), lat[near].tolist())
    east_m[near], north_m[near] = placed[0], placed[1]
    triangles = model.triangles[np.isfinite(east_m[model.triangles]).all(axis=1)]
    low_e, low_n, high_e, high_n = rasterio.warp.transform_bounds("EPSG:4326", metres, *area.bounds)
    times_s, u, v = _in_time(file, model, choices)
    corners = np.stack([east_m[triangles], north_m[triangles]], axis=-1)
    inside = (corners[:, :, 0].max(1) >= low_e) & (corners[:, :, 0].min(1) <= high_e) & (corners[:, :, 1].max(1) >= low_n) & (corners[:, :, 1].min(1) <= high_n)
    triangles, corners = triangles[inside], corners[inside]
    if not len(triangles):
        raise ChartError(f"no cell of the model lies in the area {area}", file)
    cell_m = choices.cell_m or _own_cell_m(corners)
    north = _axis(low_n, high_n, cell_m)
    east = _axis(low_e, high_e, cell_m)
    rows = len(north) * len(east) * len(times_s)
    if rows > MOST_ROWS:
        raise ChartError(
            f"with cells of {cell_m:g} m and {len(times_s)} times it has {rows} rows, but at most {MOST_ROWS} are written: "
            f"cut it with --area or --current-hours, or take --current-cell {math.ceil(cell_m * math.sqrt(rows / MOST_ROWS) * 1.05)}",
            file,
        )
    u, v = _turned(rasterio.warp, system if (not model.degrees or choices.crs) else "EPSG:4326", metres, (xs, ys, east_m, north_m), (u, v), triangles)
    on_grid = _linear(triangles, corners, (u, v), (north, east))
    dry = np.isnan(on_grid[0]).any(axis=0) | np.isnan(on_grid[1]).any(axis=0)
    if np.isnan(on_grid[0]).all():
        raise ChartError(f"it has no current in the area {area}: no place there has water at any time", file)
    told = [*model.told, f"metres from latitude {latitude}, longitude {longitude}", f"components {model.names[0]} and {model.names[1]}; {len(north)} by {len(east)} nodes to the north and east, {cell_m:g} m from each other"]
    if model.times:
        told.append(f"time 0 of the scenario is {(choices.start or model.times[0]).isoformat(sep=' ')}; the file covers {times_s[0]:g} to {times_s[-1]:g} s of the scenario")
    if dry.any():
        told.append(f"{int(dry.sum())} of {dry.size} nodes are land, holes, or dry at some time: the current is zero there")
    return Current(file, _text(times_s if model.times else None, north, east, np.nan_to_num(on_grid)), told), area


def _axis(low: float, high: float, cell_m: float) -> Any:
    """Whole cells within an extent (m), at least one."""
    import numpy as np

    first = math.ceil(low / cell_m - 1e-6)
    return cell_m * np.arange(first, max(math.floor(high / cell_m + 1e-6), first + 1) + 1)


def _own_cell_m(corners: Any) -> float:
    """The median side of the triangles, rounded to two digits (m)."""
    import numpy as np

    sides = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    cell_m = max(float(np.median(sides.min(axis=1))), 1.0)
    return round(cell_m, 1 - math.floor(math.log10(cell_m)))


def _check_speeds(file: Path, model: Model) -> None:
    import numpy as np

    for name, values in zip(model.names, (model.u, model.v), strict=True):
        if np.isinf(values).any():
            raise ChartError(f"{name} has infinite values", file)
        most = float(np.nanmax(np.abs(values))) if np.isfinite(values).any() else math.nan
        if math.isnan(most):
            raise ChartError(f"{name} has no data", file)
        if most > FASTEST_MPS:
            raise ChartError(f"{name} has a value of {most:g} m/s: a fill value that the file does not name, or another unit than m/s", file)


def _check_area(file: Path, area: Area, bounds: list[float]) -> None:
    west, south, east, north = bounds
    slack = [0.05 * (east - west), 0.05 * (north - south)]
    covers = ",".join(f"{edge:.4f}" for edge in bounds)
    apart = area.east <= west or area.west >= east or area.north <= south or area.south >= north
    if apart and area.east > south and area.west < north and area.north > west and area.south < east:
        raise ChartError(f"its longitude and latitude look swapped: it covers {covers}, and the area is {area}", file)
    if apart:
        raise ChartError(f"it lies outside the area {area}: it covers {covers}", file)
    if area.west < west - slack[0] or area.east > east + slack[0] or area.south < south - slack[1] or area.north > north + slack[1]:
        raise ChartError(f"it covers only a part of the area {area}, {covers}: cut the area with --area", file)


def _in_time(file: Path, model: Model, choices: Choices) -> tuple[list[float], Any, Any]:
    """Times of the scenario (s) that are needed, and the components at them."""
    if not model.times:
        if choices.start is not None or choices.hours is not None:
            raise ChartError("it has no times, so that --current-start and --current-hours have no effect", file)
        return [0.0], model.u, model.v
    first, last = model.times[0], model.times[-1]
    start = choices.start or first
    if any(later <= earlier for earlier, later in zip(model.times, model.times[1:], strict=False)):
        raise ChartError("its times do not increase", file)
    end = last if choices.hours is None else start + datetime.timedelta(hours=choices.hours)
    if start < first or start > last or end > last:
        raise ChartError(f"it covers {first.isoformat(sep=' ')} to {last.isoformat(sep=' ')}, but {start.isoformat(sep=' ')} to {end.isoformat(sep=' ')} is needed", file)
    times_s = [(time - start).total_seconds() for time in model.times]
    low = max(index for index, time_s in enumerate(times_s) if time_s <= 0)
    high = min(index for index, time in enumerate(model.times) if time >= end)
    kept = slice(low, high + 1)
    return times_s[kept], model.u[kept], model.v[kept]


def _turned(warp: Any, system: Any, metres: str, places: tuple[Any, Any, Any, Any], components: tuple[Any, Any], triangles: Any) -> tuple[Any, Any]:
    """Components to the east and to the north of the scenario: the model's second axis is turned against north where its nodes are."""
    import numpy as np

    xs, ys, east_m, north_m = places
    nodes = np.unique(triangles)
    # A step of about 10 m along the second axis: the model's north.
    is_degrees = str(system) == "EPSG:4326" or bool(getattr(system, "is_geographic", False))
    step = 1e-4 if is_degrees else 10.0
    there_e, there_n = warp.transform(system, metres, xs[nodes].tolist(), (ys[nodes] + step).tolist())
    angle = np.zeros(xs.shape)
    angle[nodes] = np.arctan2(np.asarray(there_e) - east_m[nodes], np.asarray(there_n) - north_m[nodes])
    u, v = components
    return u * np.cos(angle) + v * np.sin(angle), v * np.cos(angle) - u * np.sin(angle)


def _linear(triangles: Any, corners: Any, components: tuple[Any, Any], axes: tuple[Any, Any]) -> Any:
    """Components by time, north and east; NaN outside of all triangles with water."""
    import numpy as np

    u, v = components
    north, east = axes
    cell_m = float(north[1] - north[0])
    found = np.full((2, u.shape[0], len(north), len(east)), np.nan)
    tiny = 1e-9
    for nodes, corner in zip(triangles, corners, strict=True):
        (x0, y0), (x1, y1), (x2, y2) = corner
        twice = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
        if abs(twice) < 1e-6:
            continue
        columns = slice(max(math.ceil((min(x0, x1, x2) - east[0]) / cell_m - tiny), 0), min(math.floor((max(x0, x1, x2) - east[0]) / cell_m + tiny), len(east) - 1) + 1)
        lines = slice(max(math.ceil((min(y0, y1, y2) - north[0]) / cell_m - tiny), 0), min(math.floor((max(y0, y1, y2) - north[0]) / cell_m + tiny), len(north) - 1) + 1)
        if columns.start >= columns.stop or lines.start >= lines.stop:
            continue
        at_x, at_y = np.meshgrid(east[columns], north[lines])
        one = ((at_x - x0) * (y2 - y0) - (x2 - x0) * (at_y - y0)) / twice
        two = ((x1 - x0) * (at_y - y0) - (at_x - x0) * (y1 - y0)) / twice
        inside = (one >= -tiny) & (two >= -tiny) & (one + two <= 1 + tiny)
        if not inside.any():
            continue
        weights = np.stack([1 - one - two, one, two])
        for part, values in enumerate((u, v)):
            here = np.tensordot(values[:, nodes], weights, axes=1)
            patch = found[part, :, lines, columns]
            np.copyto(patch, here, where=inside & ~np.isnan(here))
    return found


def _text(times_s: list[float] | None, north: Any, east: Any, current: Any) -> str:
    """The CSV file: one row for each time and place."""
    lines = [("t_s," if times_s else "") + "north_m,east_m,north_mps,east_mps"]
    for index, time_s in enumerate(times_s or [0.0]):
        before = f"{time_s:g}," if times_s and time_s == round(time_s) and abs(time_s) < 1e6 else f"{time_s!r}," if times_s else ""
        for line, north_m in enumerate(north):
            for column, east_m in enumerate(east):
                v, u = (f"{value:.4f}".rstrip("0").rstrip(".") for value in (current[1, index, line, column] + 0.0, current[0, index, line, column] + 0.0))
                lines.append(f"{before}{north_m:g},{east_m:g},{'0' if v == '-0' else v},{'0' if u == '-0' else u}")
    return "\n".join(lines) + "\n"


def _names(file: Path, known: list[str], chosen: tuple[str, str] | None) -> tuple[str, str]:
    """The components' names: those chosen, or the first known pair."""
    listed = ", ".join(known) or "none"
    if chosen is not None:
        for name in chosen:
            if name not in known:
                raise ChartError(f"it has no variable {name!r}; its variables are {listed}", file)
        return chosen
    pairs = [pair for pair in PAIRS if all(name in known for name in pair)]
    if not pairs:
        raise ChartError(f"it has no components of a current under a name that is known: name two with --current-variables, of {listed}", file)
    return pairs[0]


def _of_selafin(file: Path, choices: Choices) -> Model:
    import numpy as np

    result = _selafin.read(file)
    names = _names(file, result.names, choices.variables)
    if not result.times_s:
        raise ChartError("it has no times", file)
    u, v = (np.array([values[result.names.index(name)] for values in result.values], dtype="float64") for name in names)
    start = result.start or datetime.datetime(1900, 1, 1)
    times = [start + datetime.timedelta(seconds=time_s) for time_s in result.times_s]
    told = [f"SELAFIN: {len(result.triangles)} triangles, {len(result.x)} nodes"]
    if result.start is None:
        told.append("it has no date: its time 0 counts as 1900-01-01")
    return Model(names, result.x, result.y, result.triangles, times, u, v, False, told)


def _of_netcdf(file: Path, choices: Choices) -> Model:
    try:
        import xarray
    except ImportError as error:
        raise missing("xarray") from error
    try:
        data = xarray.open_dataset(file)
    except Exception as error:
        raise ChartError(f"xarray cannot read it: {error}", file) from error
    with data:
        mesh = next((str(name) for name, one in data.variables.items() if one.attrs.get("cf_role") == "mesh_topology"), None)
        known = [str(name) for name, one in data.data_vars.items() if one.dtype.kind == "f" and one.ndim >= 1]
        names = _names(file, known, choices.variables)
        for name in names:
            if 0 in data[name].shape:
                raise ChartError(f"{name} has no values", file)
        u, v = (_plane(file, data[name], choices.layer) for name in names)
        times = _times(file, data, u)
        if mesh is not None:
            model = _of_mesh(file, data, mesh, names, (u, v))
        else:
            model = _of_grid(file, data, names, (u, v), choices.axes)
        model.times = times
        return model


def _time_of(one: Any) -> str | None:
    """The dimension of time, if there is one."""
    for dimension in one.dims:
        is_time = dimension in one.coords and (one.coords[dimension].dtype.kind == "M" or "cftime" in str(type(one.coords[dimension].values.flat[0])))
        if is_time or "time" in str(dimension).lower():
            return str(dimension)
    return None


def _plane(file: Path, one: Any, layer: int | None) -> Any:
    """A component with a dimension of time and those of a plane alone."""
    one = one.squeeze([dimension for dimension in one.dims if one.sizes[dimension] == 1 and dimension != _time_of(one)])
    levels = [str(dimension) for dimension in one.dims if any(word in str(dimension).lower() for word in ("s_rho", "depth", "lev", "layer", "sigma", "kmax"))]
    for dimension in levels:
        count = one.sizes[dimension]
        if layer is None:
            raise ChartError(f"{one.name} has {count} values of {dimension}: choose one with --current-layer, 0 to {count - 1}, or components that are averaged over the depth", file)
        if not 0 <= layer < count:
            raise ChartError(f"layer {layer} is none of the {count} of {dimension}, 0 to {count - 1}", file)
        one = one.isel({dimension: layer})
    return one.load()


def _times(file: Path, data: Any, one: Any) -> list[datetime.datetime] | None:
    """The times of a component; none if it has no time."""
    import numpy as np

    name = _time_of(one)
    if name is None:
        return None
    if name in one.coords:
        values = one.coords[name].values
    else:
        of_name = [str(key) for key, coordinate in data.variables.items() if coordinate.dims == (name,) and coordinate.dtype.kind == "M"]
        if not of_name:
            raise ChartError(f"its dimension {name} has no times", file)
        values = data[of_name[0]].values
    if values.dtype.kind == "M":
        if np.isnat(values).any():
            raise ChartError(f"a time of {name} is missing", file)
        return [datetime.datetime(1970, 1, 1) + datetime.timedelta(microseconds=int(value)) for value in values.astype("datetime64[us]").astype("int64")]
    if "cftime" in str(type(values.flat[0])):
        return [datetime.datetime(value.year, value.month, value.day, value.hour, value.minute, value.second, value.microsecond) for value in values]
    raise ChartError(f"the units of {name} are no times since a date", file)


def _by_time(one: Any) -> Any:
    """Values with time as the first axis, and the rest of the axes as they are."""
    import numpy as np

    name = _time_of(one)
    values = one.transpose(name, ...).values if name else one.values[None]
    return np.asarray(values, dtype="float64")


def _of_mesh(file: Path, data: Any, mesh: str, names: tuple[str, str], components: tuple[Any, Any]) -> Model:
    """A mesh of UGRID, such as that of Delft3D FM: values at nodes, or at faces, which are then averaged at the nodes."""
    import numpy as np

    topology = data[mesh].attrs
    try:
        x_name, y_name = topology["node_coordinates"].split()
        faces = data[topology["face_node_connectivity"]]
        xs, ys = (np.asarray(data[name].values, dtype="float64") for name in (x_name, y_name))
    except (KeyError, ValueError) as error:
        raise ChartError(f"its mesh {mesh} has no node_coordinates or no face_node_connectivity: {error}", file) from error
    first = int(faces.attrs.get("start_index", 0))
    ring = np.asarray(faces.values, dtype="float64")
    if ring.shape[0] != data.sizes.get(topology.get("face_dimension", str(faces.dims[0])), ring.shape[0]):
        ring = ring.T
    ring = np.where(np.isfinite(ring) & (ring >= first), ring - first, -1).astype("int64")
    if ring.max() >= len(xs):
        raise ChartError(f"a face names a node that is not of its {len(xs)} nodes", file)
    triangles = np.concatenate([ring[:, [0, corner, corner + 1]][ring[:, corner + 1] >= 0] for corner in range(1, ring.shape[1] - 1)])
    values = []
    at = ""
    for name, one in zip(names, components, strict=True):
        plain = _by_time(one)
        if plain.ndim != 2 or plain.shape[1] not in (len(xs), len(ring)):
            raise ChartError(f"{name} is neither at the nodes nor at the faces of the mesh, but has the dimensions {', '.join(map(str, one.dims))}", file)
        at = str(one.attrs.get("location", "face" if plain.shape[1] == len(ring) and len(ring) != len(xs) else "node"))
        values.append(_faces_at_nodes(plain, ring, len(xs)) if at == "face" else plain)
    degrees = _are_degrees(data[x_name], data[y_name])
    told = [f"mesh {mesh}: {len(ring)} faces, {len(xs)} nodes" + (", values at faces averaged at the nodes" if at == "face" else "")]
    return Model(names, xs, ys, triangles, None, values[0], values[1], degrees, told)


def _faces_at_nodes(values: Any, ring: Any, nodes: int) -> Any:
    """The mean of the faces with water around each node."""
    import numpy as np

    sums, counts = np.zeros((values.shape[0], nodes)), np.zeros((values.shape[0], nodes))
    for corner in range(ring.shape[1]):
        of = ring[:, corner] >= 0
        known = np.isfinite(values[:, of])
        for time in range(values.shape[0]):
            np.add.at(sums[time], ring[of, corner], np.where(known[time], values[time, of], 0.0))
            np.add.at(counts[time], ring[of, corner], known[time])
    return np.where(counts > 0, sums / np.maximum(counts, 1), np.nan)


def _are_degrees(x: Any, y: Any) -> bool:
    """Whether two coordinates are longitude and latitude."""

    def of(one: Any, words: tuple[str, ...]) -> bool:
        said = f"{one.attrs.get('standard_name', '')} {one.attrs.get('units', '')} {one.name}".lower()
        return any(word in said for word in words)

    return of(x, ("lon", "degrees_e", "degree_e")) and of(y, ("lat", "degrees_n", "degree_n"))


def _of_grid(file: Path, data: Any, names: tuple[str, str], components: tuple[Any, Any], axes: str | None) -> Model:
    """A regular or a curvilinear grid."""
    import numpy as np

    u, v = components
    told = []
    if u.dims != v.dims:
        xs, ys, u_values, v_values = _of_roms(file, data, names, components)
        told.append("grid of ROMS: the components of both staggered grids are averaged at its inner points (rho)")
        is_curved, degrees = True, True
    else:
        x, y = _coordinates(file, data, u)
        is_curved, degrees = x.ndim == 2, _are_degrees(x, y)
        u_values, v_values = _by_time(u), _by_time(v)
        plane = [dimension for dimension in u.dims if dimension != _time_of(u)]
        if is_curved:
            xs, ys = (np.asarray(axis.transpose(*plane).values, dtype="float64") for axis in (x, y))
        else:
            if plane == [x.dims[0], y.dims[0]]:
                u_values, v_values = u_values.transpose(0, 2, 1), v_values.transpose(0, 2, 1)
            xs, ys = (np.asarray(axis, dtype="float64") for axis in np.meshgrid(x.values, y.values))
    if min(xs.shape) < 2:
        raise ChartError("its grid has fewer than two lines", file)
    said = " ".join(str(one.attrs.get("standard_name", "")) + " " + str(name) for one, name in zip((u, v), names, strict=True)).lower()
    is_east = "eastward" in said and "northward" in said
    if is_curved and not is_east and axes is None and u.dims == v.dims:
        raise ChartError(f"{names[0]} and {names[1]} do not say whether they are to the east and north or along the lines of the curvilinear grid: give --current-axes east, or grid", file)
    if is_curved and (axes == "grid" or (axes is None and u.dims != v.dims)):
        angle, how = _grid_angle(data, xs, ys, degrees)
        u_values, v_values = u_values * np.cos(angle) - v_values * np.sin(angle), u_values * np.sin(angle) + v_values * np.cos(angle)
        told.append(f"components along the lines of the grid, turned to east and north {how}")
    elif axes == "grid":
        raise ChartError("its grid is regular: --current-axes grid has no effect", file)
    lines, columns = xs.shape
    index = np.arange(lines * columns).reshape(lines, columns)
    corners = [part.ravel() for part in (index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1])]
    triangles = np.concatenate([np.stack([corners[0], corners[1], corners[2]], axis=1), np.stack([corners[0], corners[2], corners[3]], axis=1)])
    told.insert(0, f"{'curvilinear' if is_curved else 'regular'} grid of {lines} by {columns} points")
    flat = [values.reshape(values.shape[0], -1) for values in (u_values, v_values)]
    return Model(names, xs.ravel(), ys.ravel(), triangles, None, flat[0], flat[1], degrees, told)


def _coordinates(file: Path, data: Any, one: Any) -> tuple[Any, Any]:
    """The coordinates of a component: of its dimensions, or in two dimensions."""
    plane = [str(dimension) for dimension in one.dims if dimension != _time_of(one)]
    if len(plane) != 2:
        raise ChartError(f"{one.name} has the dimensions {', '.join(map(str, one.dims))}: a time and two of place are read", file)
    named = [data[key] for key in (*one.coords, *str(one.attrs.get("coordinates", "")).split()) if key in data.variables]
    for rank in (2, 1):
        for words in (("lon", "lat"), ("x", "y")):
            found = []
            for axis, word in enumerate(words):
                standard = (("longitude", "latitude"), ("projection_x_coordinate", "projection_y_coordinate"))[words == ("x", "y")][axis]
                found += [of for of in named if of.ndim == rank and set(of.dims) <= set(plane) and (of.attrs.get("standard_name") == standard or str(of.name).lower().startswith(word))][:1]
            if len(found) == 2 and (rank == 2 or found[0].dims != found[1].dims):
                return found[0], found[1]
    raise ChartError(f"{one.name} has no coordinates for {' and '.join(plane)} that are known: longitude and latitude, or x and y", file)


def _of_roms(file: Path, data: Any, names: tuple[str, str], components: tuple[Any, Any]) -> tuple[Any, Any, Any, Any]:
    """Both components of ROMS at the inner points of the grid (rho), along its lines."""
    import numpy as np

    u, v = components
    wants = [name for name in ("lon_rho", "lat_rho") if name not in data.variables]
    if wants or not any("xi_u" in str(dimension) for dimension in u.dims) or not any("eta_v" in str(dimension) for dimension in v.dims):
        raise ChartError(f"{names[0]} and {names[1]} have different dimensions ({', '.join(map(str, u.dims))}; {', '.join(map(str, v.dims))}), and it is not a grid of ROMS with lon_rho and lat_rho", file)
    lon, lat = (np.asarray(data[name].values, dtype="float64") for name in ("lon_rho", "lat_rho"))
    along, across = _by_time(u), _by_time(v)
    lines, columns = lon.shape
    if along.shape[1:] != (lines, columns - 1) or across.shape[1:] != (lines - 1, columns):
        raise ChartError(f"{names[0]} and {names[1]} do not fit the {lines} by {columns} points of lon_rho", file)
    inner = slice(1, -1)
    u_values = 0.5 * (along[:, inner, :-1] + along[:, inner, 1:])
    v_values = 0.5 * (across[:, :-1, inner] + across[:, 1:, inner])
    if "mask_rho" in data.variables:
        water = np.asarray(data["mask_rho"].values)[inner, inner] > 0.5
        u_values, v_values = np.where(water, u_values, np.nan), np.where(water, v_values, np.nan)
    return lon[inner, inner], lat[inner, inner], u_values, v_values


def _grid_angle(data: Any, xs: Any, ys: Any, degrees: bool) -> tuple[Any, str]:
    """Angle of the grid's first direction (along its columns) from east, against the clock (rad), and where it is from."""
    import numpy as np

    if "angle" in data.variables:
        angle = np.asarray(data["angle"].squeeze().values, dtype="float64")
        if "deg" in str(data["angle"].attrs.get("units", "")).lower():
            angle = np.radians(angle)
        if angle.shape == tuple(side + 2 for side in xs.shape):
            angle = angle[1:-1, 1:-1]
        if angle.shape == xs.shape:
            return angle, "by its variable angle"
    shrinks = np.cos(np.radians(ys)) if degrees else 1.0
    return np.arctan2(np.gradient(ys, axis=1), np.gradient(xs, axis=1) * shrinks), "by the direction of the lines between its points"
