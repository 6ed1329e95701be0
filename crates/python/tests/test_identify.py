"""Identification: known ships from noisy tracks, what the data cannot tell, bad tracks, the command."""

from __future__ import annotations

import csv
import importlib.util
import math
import os
import subprocess
import sys
import tomllib
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

import fenderline
from fenderline import identify

pytest.importorskip("scipy")


@pytest.fixture(scope="module")
def example(root: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location("identification", root / "examples" / "python" / "identification.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def folder(root: Path) -> Path:
    return root / "examples" / "identification"


@pytest.fixture(scope="module")
def short(folder: Path) -> dict[str, object]:
    """The mapping, for the first five minutes of a track."""
    return tomllib.loads((folder / "mapping.toml").read_text()) | {"end": "2026-05-01T06:05:00Z"}


def test_a_known_ship_is_found_again(example: ModuleType, tmp_path: Path) -> None:
    found = example.fit(7, tmp_path, profiles=False)
    assert found.fitted == list(example.TRUTH)
    for own in found.coefficients:
        truth = example.TRUTH[own.name]
        assert abs(own.factor / truth - 1.0) < 0.02, own
        assert 0.0 < own.deviation < 0.01, own
        # Four standard errors: one seed in 4,000 is outside for each coefficient.
        assert abs(own.factor - truth) < 4.0 * own.deviation, own
    for quality in found.quality:
        assert quality.after_m < 0.2 * quality.before_m and quality.after_deg < 0.2 * quality.before_deg
        # Noise without memory, of 1.5 m to the north and to the east.
        assert quality.inflation < 1.2 and abs(quality.after_m / (1.5 * math.sqrt(2.0)) - 1.0) < 0.1

    found.write(tmp_path / "fitted.toml")
    found.report(tmp_path / "report.html")
    assert "Measured less computed".lower() in (tmp_path / "report.html").read_text().lower()
    table = tomllib.loads((tmp_path / "fitted.toml").read_text())["vessel"]["kvlcc2-fitted"]
    lift = {own.name: own for own in found.coefficients}["rudder.lift_gradient"]
    assert table["rudder"]["lift_gradient"] == pytest.approx(2.747 * lift.factor, rel=1e-8)
    assert any("fitted to turning.csv" in source["source"] for source in table["source"])
    # The scenario with the fitted vessel runs along the track.
    text = 'vessel_files = ["fitted.toml"]\n' + (example.FOLDER / "turning.toml").read_text().replace('"kvlcc2"', '"kvlcc2-fitted"')
    (tmp_path / "turning.toml").write_text(text)
    again = identify.identify(tmp_path / "turning.toml", tmp_path / "turning.csv", ["rudder force"], mapping=example.FOLDER / "mapping.toml", profiles=False)
    assert again.quality[0].before_m < 1.1 * again.quality[0].after_m
    assert again.coefficients[0].factor == pytest.approx(1.0, abs=0.002)


def test_the_program_accepts_the_fitted_vessel(example: ModuleType, folder: Path, tmp_path: Path) -> None:
    program = os.environ.get("FENDERLINE_PROGRAM")
    if program is None:
        pytest.skip("FENDERLINE_PROGRAM names no program")
    vessel = identify.VesselFile(fenderline.Scenario.load(folder / "turning.toml"), "ship")
    text = vessel.written("her", {"rudder.lift_gradient": 1.1, "low_speed.drag": 0.9}, {"rudder.lift_gradient": "a fit", "low_speed.drag": "a fit"})
    (tmp_path / "her.toml").write_text(text)
    (tmp_path / "turning.toml").write_text('vessel_files = ["her.toml"]\n' + (folder / "turning.toml").read_text().replace('"kvlcc2"', '"her"'))
    subprocess.run([program, "check", "turning.toml"], cwd=tmp_path, check=True)
    shown = subprocess.run([program, "vessels", "--file", "her.toml", "her"], cwd=tmp_path, check=True, capture_output=True, text=True).stdout
    assert "3.0217" in shown and "a fit" in shown


def test_what_a_track_cannot_tell_is_named_and_left(folder: Path, short: dict[str, object]) -> None:
    # Area and lift gradient of a rudder are one product; no run of this trial goes astern.
    chosen = ["rudder.lift_gradient", "rudder.area", "propeller.thrust_deduction_astern", "sway_polynomial.n_r"]
    found = identify.identify(folder / "turning.toml", folder / "turning.csv", chosen, mapping=short, profiles=False)
    own = {one.name: one for one in found.coefficients}
    assert own["propeller.thrust_deduction_astern"].refused == "no run depends on it"
    twins = [own["rudder.lift_gradient"], own["rudder.area"]]
    refused = [one for one in twins if one.refused is not None]
    assert len(refused) == 1 and "rudder." in str(refused[0].refused) and "condition number" in str(refused[0].refused)
    assert refused[0].factor == 1.0 and math.isnan(refused[0].deviation)
    assert "sway_polynomial.n_r" in found.fitted and len(found.fitted) == 2
    assert refused[0].name in found.table() and "not told" in found.table()
    assert all(path not in found.factors() for path in refused[0].values)


def test_a_weak_coefficient_is_profiled(folder: Path, short: dict[str, object]) -> None:
    found = identify.identify(
        folder / "turning.toml", folder / "turning.csv", {"sway_polynomial.n_vvr": (0.8, 1.25)}, mapping=short, limits=identify.Limits(weak=0.0)
    )
    own = found.coefficients[0]
    if own.refused is None:
        assert own.profile is not None and own.band[0] < own.factor < own.band[1]
    else:
        assert "bound" in own.refused


def test_an_estimated_ship_gets_the_numbers_that_the_program_took(tmp_path: Path) -> None:
    text = """
        [time]
        step = "1 s"
        duration = "5 min"
        [vessel.mine]
        length_bp = "175 m"
        beam = "25.4 m"
        draught = "8.5 m"
        block_coefficient = 0.5617
        propeller = { diameter = "6.533 m", full = "120 rpm" }
        rudder = { area = "33.0376 m^2", span = "7.7583 m" }
        [body.ship]
        vessel = "mine"
        outline = [[-87, -10], [-70, -12.7], [45, -12.7], [70, -8], [87, 0], [70, 8], [45, 12.7], [-70, 12.7], [-87, 10]]
        running = 0.8
        velocity = { surge = "12 kn" }
        [[order]]
        vessel = "ship"
        rudder = "20 deg"
        """
    scenario = fenderline.Scenario(text)
    names = identify.coefficients(scenario)
    assert {"drift_polynomial.y_b", "low_speed.drag", "rudder.lift_gradient", "added_mass.sway", "propeller.wake"} <= set(names)
    vessel = identify.VesselFile(scenario, "ship")
    # Every number written out: she goes as before.
    written = vessel.scenario_with(vessel.changed(dict.fromkeys(vessel.values, 1.0)), {})
    runs = []
    for own in (scenario, written):
        simulation = fenderline.Simulation(own)
        simulation.run()
        runs.append(simulation.states.copy())
    np.testing.assert_allclose(runs[0], runs[1], rtol=1e-6, atol=1e-9)


HEAD = "time [s],north [m],east [m],heading [deg]\n"


def rows(change: Callable[[list[list[str]]], None] = lambda cells: None) -> str:
    cells = [[f"{2 * row}", f"{12 * row}", "0", "0.5"] for row in range(40)]
    change(cells)
    return HEAD + "\n".join(",".join(row) for row in cells) + "\n"


def put(row: int, column: int, text: str) -> str:
    def change(cells: list[list[str]]) -> None:
        cells[row][column] = text

    return rows(change)


@pytest.mark.parametrize(
    ("text", "line", "words"),
    [
        (put(6, 1, "nan"), 8, "no reading"),
        (put(6, 3, ""), 8, "empty"),
        (put(6, 2, "abc"), 8, "no number"),
        (put(6, 0, "8"), 8, "before the row before"),
        (put(6, 0, "10"), 8, "repeats"),
        (put(39, 0, "1e3"), 41, "no reading for"),
        (put(20, 1, "900"), 22, "another ship"),
        (HEAD + "0,0,0,0\n", None, "at least 10"),
        ("", None, "no rows"),
        ("a,b\n1,2\n", None, "no column for the time"),
        (rows().replace("heading [deg]", "heading [kn]"), None, "unit"),
        (HEAD + "0,0,0\n", 2, "cells"),
    ],
)
def test_a_bad_track_is_named_with_file_and_line(tmp_path: Path, text: str, line: int | None, words: str) -> None:
    path = tmp_path / "track.csv"
    path.write_text(text)
    with pytest.raises(identify.TrackError, match=words) as caught:
        identify.read_track(path)
    assert caught.value.line == line and caught.value.file == str(path)
    assert str(path) in str(caught.value)


def test_two_ships_in_a_file(tmp_path: Path) -> None:
    lines = rows().splitlines()
    text = "\n".join([f"mmsi,{lines[0]}", *(f"{211 + (row % 2)},{line}" for row, line in enumerate(lines[1:]))])
    (tmp_path / "track.csv").write_text(text)
    with pytest.raises(identify.TrackError, match="more than one ship: 211, 212") as caught:
        identify.read_track(tmp_path / "track.csv")
    assert caught.value.line == 3
    assert len(identify.read_track(tmp_path / "track.csv", {"ship": "212"})) == 20
    with pytest.raises(identify.TrackError, match="no ship '7'"):
        identify.read_track(tmp_path / "track.csv", {"ship": "7"})


def test_a_track_of_another_berth(folder: Path, tmp_path: Path) -> None:
    (tmp_path / "track.csv").write_text(rows(lambda cells: [*map(lambda row: row.__setitem__(2, "9000"), cells)].clear()))
    with pytest.raises(identify.TrackError, match="another berth") as caught:
        identify.identify(folder / "turning.toml", tmp_path / "track.csv", ["rudder force"])
    assert caught.value.line == 2


def test_units_and_mappings(tmp_path: Path) -> None:
    plain = tmp_path / "plain.csv"
    plain.write_text(rows())
    wanted = identify.read_track(plain)
    feet = tmp_path / "feet.txt"
    with plain.open() as file:
        cells = list(csv.reader(file))[1:]
    feet.write_text("of a receiver\n" + "\n".join(f"{float(t) / 60:.9f} {-float(n) / 0.3048:.6f} {e} {math.radians(float(h)):.9f} x" for t, n, e, h in cells))
    mapping = {
        "skip_lines": 1,
        "names": ["t", "a", "b", "c", "d"],
        "columns": {
            "time": {"column": "t", "unit": "min"},
            "north": {"column": "a", "unit": "ft", "factor": -1},
            "east": "b",
            "heading": {"column": "c", "unit": "rad"},
        },
        "start": "4 s",
    }
    track = identify.read_track(feet, mapping)
    np.testing.assert_allclose(track.time_s, wanted.time_s[2:] - 4.0, atol=1e-6)
    np.testing.assert_allclose(track.north_m, wanted.north_m[2:], atol=1e-5)
    np.testing.assert_allclose(track.heading_rad, wanted.heading_rad[2:], atol=1e-8)
    assert track.lines[0] == 4
    # A model: lengths by the scale, times by its root.
    model = identify.read_track(feet, mapping | {"scale": 4.0})
    np.testing.assert_allclose(model.time_s, track.time_s / 2.0)
    np.testing.assert_allclose(model.north_m, track.north_m / 4.0)
    for key, value in {"colums": {}, "start": "4 kn", "antenna": [1], "scale": -1, "repeated": "last", "columns": {"depth": "a"}}.items():
        with pytest.raises(identify.TrackError):
            identify.read_track(feet, mapping | {key: value})


def test_latitude_and_longitude_go_where_a_library_for_maps_says(tmp_path: Path) -> None:
    warp = pytest.importorskip("rasterio.warp")
    origin = (53.9, 7.6)
    latitudes = origin[0] + np.linspace(0.0, 0.03, 40)
    longitudes = origin[1] + np.linspace(0.0, -0.05, 40)
    path = tmp_path / "track.csv"
    path.write_text("time,lat,lon,heading\n" + "\n".join(f"{20 * row},{la:.9f},{lo:.9f},0" for row, (la, lo) in enumerate(zip(latitudes, longitudes, strict=True))))
    track = identify.read_track(path, {"origin": list(origin)})
    # Transverse Mercator about the origin differs from the plane by the third power of the distance: 2 mm at 5 km.
    projection = f"+proj=tmerc +lat_0={origin[0]} +lon_0={origin[1]} +ellps=WGS84 +units=m"
    east, north = warp.transform("EPSG:4326", projection, longitudes.tolist(), latitudes.tolist())
    np.testing.assert_allclose(track.north_m, north, atol=0.005)
    np.testing.assert_allclose(track.east_m, east, atol=0.005)
    # A ship that heads for true north west of the origin heads to the west of the plane's north, by the convergence of the meridians.
    np.testing.assert_allclose(track.heading_rad, -np.radians(longitudes - origin[1]) * math.sin(math.radians(origin[0])), atol=1e-6)


@pytest.mark.parametrize(
    ("fit", "words"),
    [
        (["rudder.lift_gradiant"], "did you mean 'rudder.lift_gradient'"),
        ({"rudder force": (1.1, 2.0)}, "both sides of 1"),
        (["rudder force", "rudder.lift_gradient"], "two factors"),
        ([], "no coefficient"),
    ],
)
def test_a_bad_choice_is_refused(folder: Path, fit: identify.Chosen, words: str) -> None:
    with pytest.raises(identify.IdentifyError, match=words):
        identify.identify(folder / "turning.toml", folder / "turning.csv", fit, mapping=folder / "mapping.toml")


def test_the_command(folder: Path, tmp_path: Path) -> None:
    command = [sys.executable, "-m", "fenderline.identify"]
    given = ["turning.toml", "turning.csv", "--mapping", "mapping.toml", "--fit", "rudder force=0.8:1.3", "-o", str(tmp_path / "fitted.toml"), "--report", str(tmp_path / "r.html")]
    done = subprocess.run([*command, *given], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "rudder force" in done.stdout and "rows, " in done.stderr
    assert "kvlcc2-fitted" in tomllib.loads((tmp_path / "fitted.toml").read_text())["vessel"]
    assert "<svg" in (tmp_path / "r.html").read_text()
    bad = subprocess.run([*command, "turning.toml", "mapping.toml", "--fit", "rudder force"], cwd=folder, capture_output=True, text=True)
    assert bad.returncode == 2 and bad.stderr.startswith("error: mapping.toml")
