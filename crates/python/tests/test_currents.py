"""Currents of hydrodynamic models to the file of a scenario's current: made-up meshes of each kind, known answers, and every mistake."""

import csv
import math
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest

xarray = pytest.importorskip("xarray", reason="xarray is not installed")
pytest.importorskip("netCDF4", reason="netCDF4 is not installed")
pytest.importorskip("rasterio", reason="rasterio is not installed")

from fenderline import charts
from fenderline.charts.__main__ import main

AREA = "10.01,54.41,10.05,54.43"
TIMES = np.array(["2026-05-01T00:00", "2026-05-01T01:00", "2026-05-01T02:00"], dtype="datetime64[ns]")
LON, LAT = np.linspace(10.0, 10.06, 31), np.linspace(54.40, 54.44, 41)


def rows(folder: Path, name: str) -> list[dict[str, float]]:
    with open(folder / f"{name}.csv", encoding="utf-8") as file:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


def at(table: list[dict[str, float]], north_m: float, east_m: float, t_s: float | None = None) -> dict[str, float]:
    (row,) = [row for row in table if row["north_m"] == north_m and row["east_m"] == east_m and (t_s is None or row["t_s"] == t_s)]
    return row


def plane(lat: Any, lon: Any, time: Any = 0.0) -> tuple[Any, Any]:
    """A current that is linear in place and time: to the east and to the north (m/s)."""
    return 0.3 + 10 * (lon - 10.03) + 0.1 * time, -0.2 + 5 * (lat - 54.42) - 0.05 * time


def regular(file: Path, **changes: Any) -> Path:
    u, v = plane(LAT[None, :, None], LON[None, None, :], np.arange(3)[:, None, None])
    dims = ("time", "lat", "lon")
    parts = {"uo": (dims, u + 0 * v), "vo": (dims, v + 0 * u), **changes.pop("parts", {})}
    coordinates = {"time": TIMES, "lat": LAT, "lon": LON, **changes}
    xarray.Dataset(parts, coordinates).to_netcdf(file)
    return file


def test_a_regular_grid_has_its_current_by_place_and_time(tmp_path: Path) -> None:
    converted = charts.convert([], tmp_path / "out", current=regular(tmp_path / "tide.nc"), area=AREA, current_cell_m=100)
    assert converted.current == "tide.csv" and 'file = "tide.csv"' in converted.snippet
    table = rows(tmp_path / "out", "tide")
    metres = math.radians(1) * 6_371_000
    for north_m, east_m, t_s in [(0.0, 0.0, 0.0), (300.0, -500.0, 3600.0), (-800.0, 1200.0, 7200.0)]:
        lat, lon = 54.42 + north_m / metres, 10.03 + east_m / metres / math.cos(math.radians(54.42))
        wanted = plane(lat, lon, t_s / 3600)
        found = at(table, north_m, east_m, t_s)
        # The earth is taken as a ball for what is expected, which is 0.3 % off.
        assert abs(found["east_mps"] - wanted[0]) < 2e-3 and abs(found["north_mps"] - wanted[1]) < 2e-3
    assert "nodes are land" not in str(converted), "the model covers the area"
    later = charts.convert([], tmp_path / "later", current=tmp_path / "tide.nc", area=AREA, current_cell_m=100, current_start="2026-05-01T01:00", current_hours=1)
    times = {row["t_s"] for row in rows(tmp_path / "later", "tide")}
    assert times == {0.0, 3600.0} and "time 0 of the scenario is 2026-05-01 01:00:00" in str(later)
    fenderline = pytest.importorskip("fenderline")
    scenario = tmp_path / "out" / "call.toml"
    scenario.write_text('[time]\nstep = "1 s"\nduration = "1 s"\n[body.ship]\nvessel = "bulk-carrier"\n' + converted.snippet, "utf-8")
    if hasattr(fenderline, "Scenario"):
        fenderline.Scenario.load(scenario)


def test_a_steady_current_has_no_column_of_time_and_land_has_none(tmp_path: Path) -> None:
    u, v = plane(LAT[:, None], LON[None, :])
    u = u + 0 * v
    u[:, LON > 10.045] = np.nan
    data = xarray.Dataset({"u": (("lat", "lon"), u), "v": (("lat", "lon"), v + 0 * u)}, {"lat": LAT, "lon": LON})
    data.to_netcdf(tmp_path / "tide.nc")
    converted = charts.convert([], tmp_path / "out", current=tmp_path / "tide.nc", area=AREA, current_cell_m=100)
    table = rows(tmp_path / "out", "tide")
    assert "t_s" not in table[0]
    assert at(table, 0.0, 1200.0) == {"north_m": 0.0, "east_m": 1200.0, "north_mps": 0.0, "east_mps": 0.0}
    assert "nodes are land, holes, or dry at some time: the current is zero there" in str(converted)


def curved(turn_rad: float) -> tuple[Any, Any]:
    """Longitude and latitude of a grid whose first direction is turned from east, against the clock."""
    along, across = np.meshgrid(np.linspace(-4000, 4000, 41), np.linspace(-4000, 4000, 37))
    east_m = along * math.cos(turn_rad) - across * math.sin(turn_rad)
    north_m = along * math.sin(turn_rad) + across * math.cos(turn_rad)
    metres = math.radians(1) * 6_371_000
    lat = 54.42 + north_m / metres
    return 10.03 + east_m / metres / np.cos(np.radians(lat)), lat


def test_components_along_a_curvilinear_grid_are_turned(tmp_path: Path) -> None:
    lon, lat = curved(0.5)
    ones = np.ones(lon.shape)
    dims = ("m", "n")
    coordinates = {"lon": (dims, lon, {"units": "degrees_east"}), "lat": (dims, lat, {"units": "degrees_north"})}
    file = tmp_path / "tide.nc"
    xarray.Dataset({"u": (dims, 0.5 * ones), "v": (dims, 0 * ones)}, coordinates).to_netcdf(file)
    with pytest.raises(charts.ChartError, match="give --current-axes east, or grid"):
        charts.convert([], tmp_path / "out", current=file, area=AREA)
    turned = charts.convert([], tmp_path / "out", current=file, area=AREA, current_axes="grid", current_cell_m=200)
    assert "along the lines of the grid, turned to east and north by the direction of the lines" in str(turned)
    found = at(rows(tmp_path / "out", "tide"), 0.0, 0.0)
    assert abs(found["east_mps"] - 0.5 * math.cos(0.5)) < 2e-3 and abs(found["north_mps"] - 0.5 * math.sin(0.5)) < 2e-3
    charts.convert([], tmp_path / "plain", current=file, area=AREA, current_axes="east", current_cell_m=200)
    assert at(rows(tmp_path / "plain", "tide"), 0.0, 0.0)["east_mps"] == 0.5


def test_a_grid_of_roms_is_averaged_and_turned_by_its_angle(tmp_path: Path) -> None:
    lon, lat = curved(0.3)
    lines, columns = lon.shape
    mask = np.ones(lon.shape)
    mask[:, 24:] = 0
    u = np.full((1, 2, lines, columns - 1), 0.4)
    v = np.full((1, 2, lines - 1, columns), 0.1)
    u[:, 1], v[:, 1] = 0.8, 0.2
    data = xarray.Dataset(
        {
            "u": (("ocean_time", "s_rho", "eta_u", "xi_u"), u),
            "v": (("ocean_time", "s_rho", "eta_v", "xi_v"), v),
            "angle": (("eta_rho", "xi_rho"), np.full(lon.shape, 0.3), {"units": "radians"}),
            "mask_rho": (("eta_rho", "xi_rho"), mask),
        },
        {"ocean_time": TIMES[:1], "lon_rho": (("eta_rho", "xi_rho"), lon), "lat_rho": (("eta_rho", "xi_rho"), lat)},
    )
    data.to_netcdf(tmp_path / "roms.nc")
    with pytest.raises(charts.ChartError, match=r"u has 2 values of s_rho: choose one with --current-layer, 0 to 1"):
        charts.convert([], tmp_path / "out", current=tmp_path / "roms.nc", area=AREA)
    converted = charts.convert([], tmp_path / "out", current=tmp_path / "roms.nc", area=AREA, current_layer=1, current_cell_m=200)
    assert "averaged at its inner points (rho)" in str(converted) and "by its variable angle" in str(converted)
    found = at(rows(tmp_path / "out", "roms"), 0.0, 0.0, 0.0)
    assert abs(found["east_mps"] - (0.8 * math.cos(0.3) - 0.2 * math.sin(0.3))) < 1e-3
    assert abs(found["north_mps"] - (0.8 * math.sin(0.3) + 0.2 * math.cos(0.3))) < 1e-3
    assert "nodes are land" in str(converted)


def mesh(file: Path, at_faces: bool) -> Path:
    """A mesh of UGRID as Delft3D FM writes it: squares, of which half are cut into triangles; faces count from 1."""
    lon, lat = np.meshgrid(np.linspace(10.0, 10.06, 31), np.linspace(54.40, 54.44, 31))
    index = np.arange(31 * 31).reshape(31, 31)
    faces = []
    for line in range(30):
        for column in range(30):
            a, b, c, d = index[line, column], index[line, column + 1], index[line + 1, column + 1], index[line + 1, column]
            faces += [[a, b, c, d]] if (line + column) % 2 else [[a, b, c, -2], [a, c, d, -2]]
    ring = np.array(faces) + 1
    x, y = lon.ravel(), lat.ravel()
    if at_faces:
        known = ring > 0
        lat_of, lon_of = (np.where(known, of[np.maximum(ring - 1, 0)], 0).sum(1) / known.sum(1) for of in (y, x))
        u, v = plane(lat_of, lon_of)
    else:
        u, v = plane(y, x)
    place = "mesh2d_nFaces" if at_faces else "mesh2d_nNodes"
    topology = {
        "cf_role": "mesh_topology", "topology_dimension": 2, "node_coordinates": "mesh2d_node_x mesh2d_node_y", "face_dimension": "mesh2d_nFaces",
        "face_node_connectivity": "mesh2d_face_nodes",
    }
    time = np.stack([u, 2 * u, 3 * u])
    xarray.Dataset(
        {
            "mesh2d": ((), 0, topology),
            "mesh2d_node_x": ("mesh2d_nNodes", x, {"standard_name": "longitude", "units": "degrees_east"}),
            "mesh2d_node_y": ("mesh2d_nNodes", y, {"standard_name": "latitude", "units": "degrees_north"}),
            "mesh2d_face_nodes": (("mesh2d_nFaces", "mesh2d_nMax_face_nodes"), np.where(ring > 0, ring, -999).astype("int32"), {"start_index": 1}),
            "mesh2d_ucx": (("time", place), time, {"location": "face" if at_faces else "node"}),
            "mesh2d_ucy": (("time", place), np.stack([v, v, v]), {"location": "face" if at_faces else "node"}),
        },
        {"time": TIMES},
    ).to_netcdf(file)
    return file


@pytest.mark.parametrize("at_faces", [False, True])
def test_a_triangular_mesh_of_ugrid_is_read(tmp_path: Path, at_faces: bool) -> None:
    converted = charts.convert([], tmp_path / "out", current=mesh(tmp_path / "fm.nc", at_faces), area=AREA, current_cell_m=150)
    assert ("averaged at the nodes" in str(converted)) == at_faces
    table = rows(tmp_path / "out", "fm")
    # The mean of faces of unlike sizes is half a cell of 0.002 degrees off at most: 0.01 m/s.
    tolerance = 0.011 if at_faces else 2e-4
    wanted = plane(54.42, 10.03)
    found = at(table, 0.0, 0.0, 3600.0)
    assert abs(found["east_mps"] - 2 * wanted[0]) < 2 * tolerance and abs(found["north_mps"] - wanted[1]) < tolerance


def selafin(file: Path, eight: bool = False, date: bool = True) -> Path:
    """A result of TELEMAC-2D in UTM zone 32, with a current of 1 m/s along the northings."""
    x, y = np.meshgrid(np.linspace(564_000, 572_000, 21), np.linspace(6_028_000, 6_036_000, 21))
    index = np.arange(441).reshape(21, 21)
    corners = [part.ravel() for part in (index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1])]
    elements = np.concatenate([np.stack([corners[0], corners[1], corners[2]], 1), np.stack([corners[0], corners[2], corners[3]], 1)]) + 1
    number = ">f8" if eight else ">f4"
    out = b""

    def record(data: bytes) -> None:
        nonlocal out
        out += struct.pack(">i", len(data)) + data + struct.pack(">i", len(data))

    record(b"A made-up estuary".ljust(72) + (b"SERAFIND" if eight else b"SERAFIN "))
    record(struct.pack(">2i", 3, 0))
    for name in (b"VELOCITY U      M/S", b"VELOCITY V      M/S", b"WATER DEPTH     M"):
        record(name.ljust(32))
    # The origin of the mesh is kept apart from the coordinates.
    record(struct.pack(">10i", 1, 0, 500_000, 6_000_000, 0, 0, 0, 0, 0, int(date)))
    if date:
        record(struct.pack(">6i", 2026, 5, 1, 0, 0, 0))
    record(struct.pack(">4i", len(elements), 441, 3, 1))
    record(elements.astype(">i4").tobytes())
    record(np.zeros(441, ">i4").tobytes())
    record((x.ravel() - 500_000).astype(number).tobytes())
    record((y.ravel() - 6_000_000).astype(number).tobytes())
    for time_s in (0.0, 600.0):
        record(np.array([time_s], number).tobytes())
        for value in (0.0, 1.0, 12.0):
            record(np.full(441, value, number).tobytes())
    file.write_bytes(out)
    return file


@pytest.mark.parametrize("eight", [False, True])
def test_a_result_of_telemac_is_read_and_turned_to_the_scenarios_north(tmp_path: Path, eight: bool) -> None:
    converted = charts.convert([], tmp_path / "out", current=selafin(tmp_path / "r2d.slf", eight), area=AREA, crs="EPSG:25832", current_cell_m=200)
    assert "SELAFIN: 800 triangles, 441 nodes" in str(converted)
    table = rows(tmp_path / "out", "r2d")
    assert {row["t_s"] for row in table} == {0.0, 600.0}
    # The convergence of the meridians, 1.03 degrees east of the zone's middle: the northings run to the east of north there.
    turn = math.radians(1.03) * math.sin(math.radians(54.42))
    found = at(table, 0.0, 0.0, 600.0)
    assert abs(found["east_mps"] - math.sin(turn)) < 2e-4 and abs(found["north_mps"] - math.cos(turn)) < 2e-4
    undated = charts.convert([], tmp_path / "undated", current=selafin(tmp_path / "r.slf", eight, date=False), area=AREA, crs="EPSG:25832", current_cell_m=200)
    assert "it has no date" in str(undated)


def test_mistakes_are_errors_of_ours(tmp_path: Path) -> None:
    out = tmp_path / "out"
    good = regular(tmp_path / "good.nc")
    dims = ("time", "lat", "lon")
    shape = (3, len(LAT), len(LON))
    swapped = regular(tmp_path / "swapped.nc", lat=np.linspace(10.0, 10.06, 41), lon=np.linspace(54.40, 54.44, 31))
    beyond = regular(tmp_path / "beyond.nc", lat=np.linspace(100.0, 100.1, 41))
    filled = regular(tmp_path / "filled.nc", parts={"uo": (dims, np.full(shape, 9999.0))})
    empty = regular(tmp_path / "empty.nc", parts={"uo": (dims, np.full(shape, np.nan))})
    back = regular(tmp_path / "back.nc", time=TIMES[::-1])
    unknown = regular(tmp_path / "unknown.nc", parts={})
    xarray.open_dataset(unknown).load().rename({"uo": "a", "vo": "b"}).to_netcdf(tmp_path / "names.nc")
    holes = regular(tmp_path / "holes.nc", parts={"uo": (dims, np.where((LON > 10.055) & np.ones(shape, bool), 0.1, np.nan))})
    (tmp_path / "text.nc").write_text("no grid", "utf-8")
    (tmp_path / "text.slf").write_text("no mesh", "utf-8")
    cut = tmp_path / "cut.slf"
    cut.write_bytes(selafin(tmp_path / "whole.slf").read_bytes()[:-100])
    mistakes: list[tuple[Any, dict[str, Any], str]] = [
        (tmp_path / "absent.nc", {}, "there is no such file"),
        (tmp_path / "text.nc", {}, "xarray cannot read it"),
        (tmp_path / "text.slf", {}, "it is not SELAFIN, or it is cut off"),
        (cut, {"crs": "EPSG:25832"}, "or it is cut off: the record of the values of WATER DEPTH"),
        (tmp_path / "whole.slf", {}, "does not say its coordinate system"),
        (tmp_path / "whole.slf", {"crs": "EPSG:0"}, "is not a coordinate system"),
        (tmp_path / "names.nc", {}, "name two with --current-variables, of a, b"),
        (good, {"current_variables": ("uo", "w")}, "it has no variable 'w'; its variables are uo, vo"),
        (good, {"current_start": "2026-04-30T23:00"}, r"it covers 2026-05-01 00:00:00 to 2026-05-01 02:00:00, but 2026-04-30 23:00:00 to"),
        (good, {"current_hours": 3.0}, r"to 2026-05-01 02:00:00, but 2026-05-01 00:00:00 to 2026-05-01 03:00:00 is needed"),
        (good, {"current_start": "tomorrow"}, "is a time such as"),
        (good, {"current_hours": -1.0}, "are positive"),
        (good, {"area": "20,54,20.1,54.1"}, "it lies outside the area 20,54,20.1,54.1: it covers 10.0000,54.4000,10.0600,54.4400"),
        (good, {"area": "10.01,54.41,10.2,54.43"}, "it covers only a part of the area"),
        (good, {"current_axes": "grid"}, "its grid is regular"),
        (good, {"current_axes": "sideways"}, "are east or grid"),
        (good, {"current_cell_m": 1.0}, r"but at most 400000 are written: .* take --current-cell \d+"),
        (swapped, {}, "its longitude and latitude look swapped"),
        (beyond, {}, "a latitude is 100.1 degrees: its longitude and latitude look swapped"),
        (filled, {}, "uo has a value of 9999 m/s: a fill value that the file does not name"),
        (empty, {}, "uo has no data"),
        (back, {}, "its times do not increase"),
        (holes, {}, "no place there has water at any time"),
        (None, {"current_hours": 1.0}, "but no current"),
    ]
    for file, keys, reason in mistakes:
        with pytest.raises(charts.ChartError, match=reason):
            charts.convert([] if file else ["a.000"], out, **{"current": file, "area": AREA, **keys})
        assert not out.exists(), reason


def test_the_command_says_how_it_read_a_current(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = str(regular(tmp_path / "tide.nc"))
    assert main(["--current", file, "--area", AREA, "--current-variables", "uo,vo", "--current-cell", "250", "-o", str(tmp_path / "out")]) == 0
    said = capsys.readouterr().out
    assert "current: tide.csv" in said and "components uo and vo" in said and "regular grid of 41 by 31 points" in said
    assert main(["--current", file, "--area", AREA, "--current-start", "2027-01-01", "-o", str(tmp_path / "other")]) == 2
    assert "error:" in capsys.readouterr().err
