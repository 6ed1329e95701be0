"""Berthing energy, verdict and ledger of a run: as a tree, and as tables of many runs."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import pytest

import fenderline
from fenderline import Scenario, Simulation


def test_the_berthing_energy_is_that_of_the_formula(scenarios: Path) -> None:
    scenario = Scenario.load(scenarios / "worked" / "fleet_ship_broadside.toml")
    simulation = Simulation(scenario)
    assert simulation.berthing is None, "before the first touch"
    simulation.run()
    berthing = simulation.berthing
    assert berthing is not None
    # Published: five fenders with 123.0 kJ each. Cm by UFC 4-152-01, and Ce 1 for the group.
    assert berthing["energy_j"] == pytest.approx(5 * 123.01e3, rel=2e-3)
    assert berthing["fender_energy_j"] == pytest.approx(5 * 123.01e3, rel=2e-3)
    assert berthing["added_mass_by"] == "ufc"
    assert berthing["eccentricity"] == 1.0
    assert berthing["fenders"] == ["f_1", "f_2", "f_3", "f_4", "f_5"]


def test_the_tree_has_verdict_ledger_fenders_and_first_and_later_hits(scenarios: Path) -> None:
    simulation = Simulation(Scenario.load(scenarios / "berth" / "eight_cones_at_5_deg.toml"))
    simulation.run()
    tree = simulation.summary_tree()
    assert tree["verdict"]["key"] == simulation.verdict
    assert tree["energy"]["kinetic_j"] == simulation.energy["kinetic_j"]
    assert tree["berthing"] == simulation.berthing
    fenders = simulation.summary()["fenders"]
    assert [fender["name"] for fender in tree["fenders"]] == fenders["fender"].tolist()
    peaks = [fender["share_of_catalogue_energy"] for fender in tree["fenders"]]
    assert peaks == fenders["share_of_catalogue_energy"].tolist()
    # At 5 degrees she swings in after the first hit.
    berthing = tree["berthing"]
    assert berthing["fender_energy_j"] > 0
    assert berthing["later_at_s"] > berthing["first_touch_s"]
    assert berthing["later_hit"] == 2
    # A later hit takes at least what the fender with the most energy took, where that fender was touched in it alone.
    most = max(tree["fenders"], key=lambda fender: fender["peak_energy_j"])
    if most["peak_energy_at_s"] == berthing["later_at_s"]:
        assert berthing["later_energy_j"] >= most["peak_energy_j"]
    json.dumps(tree)


def test_the_tree_is_that_of_the_program(scenarios: Path, tmp_path: Path) -> None:
    program = os.environ.get("FENDERLINE_PROGRAM")
    if program is None:
        pytest.skip("FENDERLINE_PROGRAM does not say where the program `fenderline` is")
    file = scenarios / "berth" / "eight_cones_at_5_deg.toml"
    subprocess.run([program, "run", file, "--out", tmp_path, "--allow-failures"], check=True)
    of_program = json.loads((tmp_path / "summary.json").read_text("utf-8"))
    for key in ("files", "scenario_file", "notices"):
        del of_program[key]
    simulation = Simulation(Scenario.load(file))
    simulation.run()
    tree = simulation.summary_tree()
    del tree["notices"]
    assert tree == of_program


def test_many_runs_have_their_berthing_energies(scenarios: Path) -> None:
    scenario = Scenario.load(scenarios / "worked" / "fleet_ship_broadside.toml")
    speeds = [0.05, 0.1]
    runs = fenderline.run_many(scenario, {"body.ship.approach.speed_normal": speeds})
    energies = runs.berthings["energy_j"]
    assert runs.berthings["run"].tolist() == [0, 1]
    assert energies[1] / energies[0] == pytest.approx(4.0, rel=1e-9)
    assert runs.berthings["fender_energy_j"] == pytest.approx(energies, rel=5e-3)


def test_a_scenario_without_a_berthing_has_none() -> None:
    simulation = Simulation(fenderline.example("tug_4kn"))
    simulation.run()
    assert simulation.berthing is None
    assert "berthing" not in simulation.summary_tree()
    assert simulation.summary()["berthings"].rows == 0


def test_an_output_interval_makes_fewer_rows(scenarios: Path) -> None:
    scenario = fenderline.example("tug_4kn").with_set({"output.interval": "1 s"})
    results = fenderline.run(scenario)
    assert results["bodies"].rows == 2 * 20
    assert results["energy"].rows == 1 + 20
