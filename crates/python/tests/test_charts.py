"""Charts and surveys to the files of a scenario: made-up layers with the names of S-57, grids, and every mistake."""

import json
import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("pyogrio", reason="pyogrio is not installed")
pytest.importorskip("rasterio", reason="rasterio is not installed")
pytest.importorskip("shapely", reason="shapely is not installed")

from fenderline import charts
from fenderline.charts.__main__ import main

# Of affine, by rasterio itself.
pytestmark = pytest.mark.filterwarnings("ignore:Use `@` matmul:PendingDeprecationWarning")

AREA = "10.00,54.40,10.06,54.44"


def feature(properties: dict[str, Any], kind: str, coordinates: Any) -> dict[str, Any]:
    return {"type": "Feature", "properties": properties, "geometry": {"type": kind, "coordinates": coordinates}}


def layer(folder: Path, name: str, *features: dict[str, Any]) -> Path:
    """A made-up layer as ogr2ogr writes it."""
    file = folder / f"{name}.geojson"
    file.write_text(json.dumps({"type": "FeatureCollection", "name": name, "features": features}), "utf-8")
    return file


def square(west: float, south: float, east: float, north: float) -> list[list[list[float]]]:
    return [[[west, south], [east, south], [east, north], [west, north], [west, south]]]


@pytest.fixture
def made_up(tmp_path: Path) -> list[Path]:
    hole = square(10.02, 54.42, 10.03, 54.43)[0]
    return [
        layer(
            tmp_path,
            "DEPARE",
            feature({"RCID": 7, "DRVAL1": 5.4, "DRVAL2": 9.1, "INFORM": None}, "Polygon", [*square(9.9, 54.41, 10.05, 54.5), hole]),
            feature({"DRVAL1": 0.0, "DRVAL2": 5.4}, "Polygon", square(11.0, 54.41, 11.1, 54.5)),
        ),
        layer(tmp_path, "SOUNDG", feature({"OBJL": 129}, "MultiPoint", [[10.01, 54.42, 7.4], [10.5, 54.42, 3.0]])),
        layer(tmp_path, "DEPCNT", feature({"VALDCO": 5.4}, "LineString", [[9.9, 54.42], [10.1, 54.42]])),
        layer(tmp_path, "BOYLAT", feature({"COLOUR": ["4"], "CATLAM": 1, "OBJNAM": "Gute Tonne ü"}, "Point", [10.02, 54.43])),
        layer(tmp_path, "SEAARE", feature({"OBJNAM": "Bay"}, "Point", [10.02, 54.43])),
    ]


def test_the_area_is_cut_out_with_the_names_of_s57(made_up: list[Path], tmp_path: Path) -> None:
    converted = charts.convert(made_up, tmp_path / "out", area=AREA)
    assert converted.written == {"BOYLAT": 1, "DEPARE": 1, "DEPCNT": 1, "SOUNDG": 1}
    assert converted.outside == {"DEPARE": 1}
    assert converted.not_read == {"SEAARE": 1}
    assert "classes that are not read: 1 SEAARE" in str(converted)
    files = {file.name: file.read_text("utf-8") for file in (tmp_path / "out").iterdir()}
    assert sorted(files) == ["BOYLAT.geojson", "DEPARE.geojson", "DEPCNT.geojson", "SOUNDG.geojson", "chart.toml"]
    depths = json.loads(files["DEPARE.geojson"])
    assert depths["name"] == "DEPARE"
    (area,) = depths["features"]
    assert area["properties"] == {"DRVAL1": 5.4, "DRVAL2": 9.1}
    xs = [x for ring in area["geometry"]["coordinates"] for x, _ in ring]
    assert min(xs) == 10.0 and max(xs) == 10.05 and len(area["geometry"]["coordinates"]) == 2
    (sounding,) = json.loads(files["SOUNDG.geojson"])["features"]
    assert sounding["geometry"] == {"type": "Point", "coordinates": [10.01, 54.42, 7.4]}
    (line,) = json.loads(files["DEPCNT.geojson"])["features"]
    assert line["geometry"]["coordinates"] == [[10.0, 54.42], [10.06, 54.42]]
    (buoy,) = json.loads(files["BOYLAT.geojson"])["features"]
    assert buoy["properties"] == {"COLOUR": ["4"], "CATLAM": 1, "OBJNAM": "Gute Tonne ü"}
    assert 'origin = { latitude = "54.42 deg", longitude = "10.03 deg" }' in files["chart.toml"]
    assert 'chart = "interpolated"' in files["chart.toml"]


def test_a_scenario_reads_what_was_written(made_up: list[Path], tmp_path: Path) -> None:
    fenderline = pytest.importorskip("fenderline")
    converted = charts.convert(made_up, tmp_path / "out", area=AREA)
    scenario = tmp_path / "out" / "call.toml"
    scenario.write_text(
        '[time]\nstep = "1 s"\nduration = "1 s"\n[body.quay]\nfixed = true\noutline = [[0, 0], [9, 0], [9, 9], [0, 9]]\n' + converted.snippet, "utf-8"
    )
    if hasattr(fenderline, "Scenario"):
        fenderline.Scenario.load(scenario)


def raster(file: Path, values: np.ndarray, crs: str | None, west: float, north: float, cell: float, nodata: float | None = None) -> Path:
    import rasterio

    rows, columns = values.shape
    with rasterio.open(
        file, "w", driver="GTiff", height=rows, width=columns, count=1, dtype="float32", crs=crs, nodata=nodata,
        transform=rasterio.transform.from_origin(west, north, cell, cell),
    ) as data:
        data.write(values.astype("float32"), 1)
    return file


def grid(text: str) -> tuple[dict[str, float], np.ndarray]:
    """Head and values of an ESRI ASCII grid; NaN for no data."""
    lines = text.splitlines()
    head = {key: float(value) for key, value in (line.split() for line in lines[:6])}
    values = np.array([[float(word) for word in line.split()] for line in lines[6:]])
    return head, np.where(values == head["NODATA_value"], np.nan, values)


def test_a_geotiff_becomes_a_grid_in_metres(tmp_path: Path) -> None:
    # A plane in UTM that falls to the east, 20 m cells; EPSG:25832 is UTM about 9 degrees east.
    east = 565_000 + 20 * (np.arange(200) + 0.5)
    values = np.broadcast_to(-5 - 0.01 * (east - 565_000), (200, 200)).copy()
    values[:20, :20] = -9999
    file = raster(tmp_path / "berth.tif", values, "EPSG:25832", 565_000, 6_034_000, 20, -9999)
    converted = charts.convert(file, tmp_path / "out")
    assert converted.surveys == ("berth.asc",)
    assert 'survey = ["berth.asc"]' in converted.snippet and "[chart]" not in converted.snippet
    head, found = grid((tmp_path / "out" / "berth.asc").read_text("utf-8"))
    assert head["cellsize"] == 20
    assert np.isfinite(found).mean() > 0.9
    # Half of it is deeper than the middle.
    assert abs(np.nanmedian(found) + 25) < 0.5
    # The depth falls by 1 cm a metre towards the east.
    slope = np.nanmedian(np.diff(found, axis=1)) / 20
    assert abs(slope + 0.01) < 2e-4


def test_a_netcdf_grid_of_heights_is_read_by_longitude_and_latitude(tmp_path: Path) -> None:
    xarray = pytest.importorskip("xarray")
    pytest.importorskip("netCDF4")
    lat, lon = np.linspace(54.40, 54.44, 81), np.linspace(10.0, 10.06, 61)
    heights = -10 - 100 * (lat[:, None] - 54.42) + 0 * lon
    xarray.Dataset({"elevation": (("lat", "lon"), heights)}, {"lat": lat, "lon": lon}).to_netcdf(tmp_path / "bay.nc")
    converted = charts.convert(tmp_path / "bay.nc", tmp_path / "out", area="10.01,54.41,10.05,54.43", cell_m=50)
    head, found = grid((tmp_path / "out" / "bay.asc").read_text("utf-8"))
    assert converted.surveys == ("bay.asc",) and head["cellsize"] == 50
    middle = found[found.shape[0] // 2, found.shape[1] // 2]
    assert abs(middle + 10) < 0.1
    assert found[0, 5] < found[-1, 5], "the first row is the northern one"


def test_mistakes_are_errors_of_ours(made_up: list[Path], tmp_path: Path) -> None:
    out = tmp_path / "out"
    plane = np.full((10, 10), 5.0)
    without = raster(tmp_path / "nowhere.tif", plane, None, 565_000, 6_034_000, 5)
    empty = raster(tmp_path / "empty.tif", np.full((10, 10), np.nan), "EPSG:4326", 10.0, 54.44, 0.001)
    (tmp_path / "text.000").write_text("no chart", "utf-8")
    other = layer(tmp_path, "roads", feature({}, "Point", [10, 54]))
    mistakes: list[tuple[Any, dict[str, Any], str]] = [
        ([], {}, "no file"),
        (tmp_path / "absent.000", {}, "there is no such file"),
        (tmp_path / "absent.tif", {}, "there is no such file"),
        (tmp_path / "text.000", {}, "GDAL cannot read it"),
        (other, {}, "no class of S-57"),
        (made_up, {"area": "1,2,3"}, "the area is west, south, east, north"),
        (made_up, {"area": "10,54,9,55"}, "is empty"),
        (made_up, {"area": "54,200,55,201"}, "longitudes are within 180"),
        (made_up, {"area": "0,50,9,60"}, "larger than 200 km"),
        (made_up, {"area": "20,54,20.1,54.1"}, "nothing of the chart lies in the area"),
        (without, {}, "does not say its coordinate system"),
        (without, {"crs": "EPSG:0"}, "is not a coordinate system"),
        (empty, {}, "it has no data"),
        (empty, {"cell_m": 0.01}, "a cell is from 0.1"),
    ]
    for files, keys, reason in mistakes:
        with pytest.raises(charts.ChartError, match=reason) as caught:
            charts.convert(files, out, **keys)
        assert isinstance(caught.value, ValueError)
        assert not out.exists(), reason
    update = tmp_path / "text.001"
    update.write_text("no chart", "utf-8")
    with pytest.raises(charts.ChartError, match=r"this is an update: name the cell itself, text\.000"):
        charts.convert(update, out)


def test_a_folder_with_files_is_not_touched(made_up: list[Path], tmp_path: Path) -> None:
    out = tmp_path / "out"
    out.mkdir()
    (out / "mine.txt").write_text("mine", "utf-8")
    with pytest.raises(charts.ChartError, match="exists already"):
        charts.convert(made_up, out, area=AREA)
    assert [file.name for file in out.iterdir()] == ["mine.txt"]
    assert not list(tmp_path.glob(".charts-*"))


def test_the_command_says_what_it_did_or_what_is_wrong(made_up: list[Path], tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    files = [str(file) for file in made_up]
    assert main([*files, "--area", AREA, "--origin", "54.41,10.02", "-o", str(tmp_path / "out")]) == 0
    said = capsys.readouterr().out
    assert "1 DEPARE" in said and "chart.toml" in said
    assert 'latitude = "54.41 deg"' in (tmp_path / "out" / "chart.toml").read_text("utf-8")
    assert main([*files, "--area", "-10,0,-11,1", "-o", str(tmp_path / "other")]) == 2
    assert "error: the area" in capsys.readouterr().err


@pytest.mark.skipif("FENDERLINE_ENC_CELL" not in os.environ, reason="FENDERLINE_ENC_CELL names no cell: US4MD81M.000 with three updates")
def test_a_real_cell_has_its_counts(tmp_path: Path) -> None:
    converted = charts.convert(os.environ["FENDERLINE_ENC_CELL"], tmp_path / "out")
    known = {"DEPARE": 525, "DEPCNT": 566, "SOUNDG": 56, "COALNE": 1826, "SLCONS": 666, "LNDARE": 183, "DRGARE": 7, "BOYLAT": 71, "BRIDGE": 51, "OBSTRN": 219, "M_COVR": 2}
    assert {name: converted.written[name] for name in known} == known
    assert converted.outside == {}
    assert "edition 31, update 3" in converted.snippet
