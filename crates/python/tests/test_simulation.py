"""Whole simulations: the numbers of `fenderline run`, controls between steps, save and restore."""

import csv
import os
import signal
import subprocess
import threading
from pathlib import Path

import fenderline
import numpy as np
import pytest
from fenderline import Scenario, ScenarioError, Simulation, SimulationError

SHORT = {"time.duration": "120 s"}


@pytest.mark.parametrize(
    ("name", "replaced"),
    [
        ("paper/experiment_2_4kn", {}),
        ("oblique_hit", {}),
        ("paper/experiment_1_step_0.1s", {"time.integrator": "rk4"}),
        ("berth/eight_cones_at_5_deg", {}),
        ("berth/alongside_with_two_tugs", SHORT),
        ("berth/asd_tugs_push_alongside", SHORT),
    ],
)
def test_the_same_bits_as_fenderline_run(
    scenarios: Path, tmp_path: Path, name: str, replaced: dict[str, str]
) -> None:
    program = os.environ.get("FENDERLINE_PROGRAM")
    if program is None:
        pytest.skip("FENDERLINE_PROGRAM does not say where the program `fenderline` is")
    path = scenarios / f"{name}.toml"
    options = [text for key, value in replaced.items() for text in ("--set", f"{key}={value}")]
    subprocess.run(
        [program, "run", path, "--out", tmp_path, *options], check=True, capture_output=True
    )
    results = fenderline.run(Scenario.load(path, replaced))
    written = {file.stem for file in tmp_path.glob("*.csv")}
    assert set(results) == written
    for table in results.values():
        with (tmp_path / f"{table.name}.csv").open(newline="") as file:
            rows = list(csv.reader(file))
        assert rows[0] == list(table)
        assert len(rows) - 1 == table.rows
        for index, column in enumerate(table):
            theirs = [row[index] for row in rows[1:]]
            ours = table[column]
            if ours.dtype == np.float64:
                # The program writes the shortest text that reads back to the same bits.
                # A cell without a value is empty, and not a number in Python.
                empty = np.array([text == "" for text in theirs], dtype=np.bool_)
                assert np.isnan(ours[empty]).all(), column
                given = [float(text) for text in theirs if text != ""]
                expected = np.array(given, dtype=np.float64)
                assert (ours[~empty].view(np.uint64) == expected.view(np.uint64)).all(), column
            elif ours.dtype == np.bool_:
                assert [str(value).lower() for value in ours.tolist()] == theirs, column
            else:
                assert [str(value) for value in ours.tolist()] == theirs, column


def berth(scenarios: Path, **replaced: object) -> Scenario:
    path = scenarios / "berth" / "alongside_with_two_tugs.toml"
    return Scenario.load(path, {"order": [], **replaced})


def test_controls_are_set_between_steps(scenarios: Path) -> None:
    simulation = Simulation(berth(scenarios))
    assert simulation.control_names == [
        "ship.rudder_rad",
        "ship.engine",
        "ship.thruster.bow",
        "tug.forward.force_n",
        "tug.aft.force_n",
    ]
    assert np.isnan(simulation.controls).all()
    simulation.controls[0] = np.deg2rad(20)
    simulation.step(600)
    assert simulation.time_s == pytest.approx(60)
    assert simulation.states[0, 5] > 1e-4
    turning = simulation.states[0, 5]
    simulation.controls[0] = -np.deg2rad(20)
    simulation.step(900)
    assert simulation.states[0, 5] < turning


def test_a_control_equals_the_order(scenarios: Path) -> None:
    by_control, by_order = Simulation(berth(scenarios)), Simulation(berth(scenarios))
    by_control.controls[1:4] = [0.4, -1.0, 2e5]
    by_order.order(vessel="ship", engine=0.4)
    by_order.order(vessel="ship", thruster={"name": "bow", "power": -1})
    by_order.order(tug="forward", push="200 kN")
    by_control.step(300)
    by_order.step(300)
    assert (by_control.states == by_order.states).all()


def test_a_wrong_order_names_its_key(scenarios: Path) -> None:
    simulation = Simulation(berth(scenarios))
    with pytest.raises(ScenarioError) as raised:
        simulation.order(vessel="ship", ruder="5 deg")
    assert raised.value.key == "order.ruder"
    with pytest.raises(ScenarioError, match="no body"):
        simulation.order(vessel="shp", rudder=0)


def test_invalid_controls_and_wrenches_are_refused(scenarios: Path) -> None:
    simulation = Simulation(berth(scenarios))
    simulation.controls[1] = np.inf
    with pytest.raises(SimulationError, match=r"ship\.engine must be between -1 and 1"):
        simulation.step()
    simulation.controls[1] = 0.0
    simulation.external_wrenches[0, 0] = np.nan
    with pytest.raises(SimulationError, match="external wrench on ship"):
        simulation.step()
    assert simulation.time_s == 0.0


def test_external_forces_push(scenarios: Path) -> None:
    one, other = Simulation(berth(scenarios)), Simulation(berth(scenarios))
    one.external_wrenches[0] = [1e6, 0.0, 0.0]
    one.step(100)
    other.step(100)
    assert one.states[0, 3] > other.states[0, 3]


def test_save_restore_and_copy(scenarios: Path) -> None:
    simulation = Simulation(berth(scenarios))
    simulation.controls[:2] = [0.1, 0.3]
    simulation.step(100)
    saved, copy = simulation.save(), simulation.copy()
    ends: list[np.ndarray] = []
    for run in (simulation, copy, simulation):
        if ends and run is simulation:
            run.restore(saved)
            assert run.time_s == pytest.approx(10)
        run.controls[0] = -0.2
        run.step(100)
        ends.append(run.states.copy())
    assert (ends[0] == ends[1]).all()
    assert (ends[0] == ends[2]).all()
    equal = Simulation(berth(scenarios))
    equal.restore(saved)
    equal.controls[0] = -0.2
    equal.step(100)
    assert (equal.states == ends[0]).all()
    with pytest.raises(SimulationError, match="another scenario"):
        Simulation(berth(scenarios, **{"time.step": "0.05 s"})).restore(saved)


def test_a_recorded_simulation_gives_its_tables_once(scenarios: Path) -> None:
    simulation = Simulation(fenderline.example("tug_4kn"), record=True)
    with pytest.raises(SimulationError, match="recorded cannot be saved"):
        simulation.save()
    simulation.run(until_s=5.0)
    results = simulation.results()
    assert results["bodies"].rows == 2 * 50
    with pytest.raises(SimulationError, match="the simulation has no recording"):
        simulation.results()


def test_the_summary_has_pairs_and_fenders(scenarios: Path) -> None:
    simulation = Simulation(Scenario.load(scenarios / "berth" / "eight_cones_at_5_deg.toml"))
    simulation.run()
    assert simulation.is_done
    summary = simulation.summary()
    assert summary["pairs"].rows == 1
    fenders = summary["fenders"]
    assert fenders.rows > 0
    assert (fenders["share_of_rated_energy"] > 0).all()
    assert simulation.energy["kinetic_j"] >= 0


def test_a_scenario_with_a_provider_is_refused(scenarios: Path) -> None:
    scenario = Scenario.load(scenarios / "provider" / "drag_in_python.toml")
    with pytest.raises(SimulationError, match="provider"):
        Simulation(scenario)


def test_events_have_names() -> None:
    simulation = Simulation(fenderline.example("tug_4kn"))
    simulation.run()
    kinds = [event.kind for event in simulation.events]
    assert kinds == ["contact_began", "contact_ended"]


@pytest.mark.usefixtures("interruptible")
def test_an_interrupt_stops_a_long_run(scenarios: Path) -> None:
    simulation = Simulation(berth(scenarios))
    timer = threading.Timer(0.2, signal.raise_signal, [signal.SIGINT])
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        simulation.step(10**9)
    timer.join()
    assert 0 < simulation.time_s < 1e7
    here = simulation.states.copy()
    simulation.restore(simulation.save())
    assert (simulation.states == here).all()
