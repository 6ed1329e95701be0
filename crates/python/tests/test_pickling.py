"""Pickles and copies: scenarios, simulations, engines and results, and the tools that send them to other processes."""

import copy
import functools
import math
import multiprocessing
import pickle
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Any

import fenderline
import numpy as np
import pytest
from fenderline import Engine, Error, Scenario, ScenarioError, Simulation, _pickling

TUG = fenderline.example("tug_4kn").with_set({"time.duration": "8 s"})
SPEEDS = [0.5, 1.0, 1.5, 2.0]


def through_pickle(thing: Any) -> Any:
    return pickle.loads(pickle.dumps(thing))


COPIES = pytest.mark.parametrize("again", [through_pickle, copy.copy, copy.deepcopy])


@COPIES
def test_a_scenario(again: Any) -> None:
    one = TUG.with_set({"time.step": "0.05 s"})
    other = again(one)
    assert other == one
    assert hash(other) == hash(one)
    assert (other.step_s, other.name, other.tree()) == (0.05, one.name, one.tree())
    assert other.with_set(["time.step=0.1 s"]) != one


def test_a_pickled_scenario_brings_its_files(scenarios: Path, tmp_path: Path) -> None:
    folder = scenarios / "environment"
    for name in ("across_a_tidal_stream.toml", "tidal_stream.csv", "veering_wind.csv"):
        (tmp_path / name).write_bytes((folder / name).read_bytes())
    file = tmp_path / "across_a_tidal_stream.toml"
    scenario = Scenario.load(file)
    pickled = pickle.dumps(scenario)
    (tmp_path / "tidal_stream.csv").unlink()
    again = pickle.loads(pickled)
    assert again == scenario
    assert again.with_set({"time.step": "0.2 s"}).step_s == 0.2
    with pytest.raises(ScenarioError, match=r"tidal_stream\.csv"):
        Scenario.load(file)


@COPIES
@pytest.mark.parametrize("record", [False, True])
def test_a_simulation_goes_on_to_the_same_bits(again: Any, record: bool) -> None:
    one = Simulation(fenderline.example("docking"), record=record)
    one.controls[1] = -0.5
    one.step(10)
    one.controls[1] = 0.3
    one.external_wrenches[0] = [1e5, -2e4, 1e6]
    one.order(vessel="ship", rudder="-10 deg")
    one.step(20)
    # Inputs that the next step reads.
    one.controls[2] = 0.4
    one.external_wrenches[0] = 0.0
    other = again(one)
    assert other.scenario == one.scenario
    assert other.events == one.events
    for _ in range(3):
        assert (other.states == one.states).all()
        assert (other.wrenches == one.wrenches).all()
        assert other.time_s == one.time_s
        other.step(40)
        one.step(40)
    assert other.summary_tree() == one.summary_tree()
    # A copy of a copy has all inputs too.
    assert (again(other).states == one.states).all()
    if record:
        ours, theirs = one.results(), other.results()
        for name, table in ours.items():
            for column in table:
                # The first step of the energy ledger has no rates: NaN equals NaN here.
                np.testing.assert_array_equal(table[column], theirs[name][column])


@COPIES
def test_a_fleet_says_what_to_send_in_its_place(again: Any) -> None:
    fleet = fenderline.Fleet(TUG, [{}, {}])
    with pytest.raises(TypeError, match="send the scenario and the variants"):
        again(fleet)


def test_a_saved_state_goes_to_another_process() -> None:
    one = Simulation(TUG)
    one.step(30)
    state = through_pickle(one.save())
    one.step(20)
    other = Simulation(through_pickle(TUG))
    other.restore(state)
    other.step(20)
    assert (other.states == one.states).all()


@COPIES
@pytest.mark.parametrize("host", ["direct", "cosimulation"])
def test_an_engine_goes_on_to_the_same_bits(again: Any, host: Any) -> None:
    scenario = TUG.with_set({"contact.method": "coupled"})
    delay = 2 if host == "cosimulation" else 0
    one = Engine(scenario, host=host, delay_steps=delay)
    one.states[1, 1] = -38.5
    for _ in range(3):
        one.step(0.1)
    other = again(one)
    assert other.uses_loads == one.uses_loads
    for _ in range(3):
        assert one.wrenches.any()
        assert (other.wrenches == one.wrenches).all()
        assert (other.contacts == one.contacts).all()
        one.step(0.1)
        other.step(0.1)


@COPIES
def test_results(again: Any) -> None:
    results = fenderline.run(TUG)
    other = again(results)
    assert list(other) == list(results)
    for name, table in results.items():
        assert other[name].columns["t_s"].unit == "s"
        for column in table:
            np.testing.assert_array_equal(other[name][column], table[column])
    with pytest.raises(ValueError, match="read-only"):
        other["bodies"]["x_m"][0] = 0.0
    runs = again(fenderline.run_many(TUG, [{}, {}]))
    assert runs.verdicts["verdict"].tolist() == ["not_rated", "not_rated"]


def test_pickles_of_another_version_are_refused() -> None:
    _, (_, parts) = Simulation(TUG).__reduce__()
    with pytest.raises(Error, match=r"pickled by fenderline 0\.0\.1"):
        _pickling.simulation("0.0.1", parts)


def test_an_error_of_another_process_keeps_its_place() -> None:
    with pytest.raises(ScenarioError) as raised:
        fenderline.run_many(TUG, [{}, {"time.step": "1 t"}])
    error = through_pickle(raised.value)
    assert (error.run, error.key, str(error)) == (1, "time.step", str(raised.value))


def last_states(scenario: Scenario, speed: float) -> list[list[float]]:
    """One variant; workers of other processes import it from here."""
    simulation = Simulation(scenario.with_set({"body.tug.velocity.surge": speed}))
    simulation.run()
    states: list[list[float]] = simulation.states.tolist()
    return states


@functools.cache
def expected() -> list[list[list[float]]]:
    variants = {"body.tug.velocity.surge": SPEEDS}
    states: list[list[list[float]]] = fenderline.run_many(TUG, variants).states.tolist()
    assert all(math.isfinite(number) for run in states for body in run for number in body)
    return states


def test_a_pool_of_processes() -> None:
    spawned = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(2, mp_context=spawned) as pool:
        assert list(pool.map(last_states, [TUG] * len(SPEEDS), SPEEDS)) == expected()


def test_joblib() -> None:
    joblib = pytest.importorskip("joblib", reason="joblib is not installed")
    each = (joblib.delayed(last_states)(TUG, speed) for speed in SPEEDS)
    assert joblib.Parallel(n_jobs=2)(each) == expected()


def test_dask() -> None:
    dask = pytest.importorskip("dask", reason="Dask is not installed")
    each = [dask.delayed(last_states)(dask.delayed(TUG), speed) for speed in SPEEDS]
    assert list(dask.compute(*each, scheduler="processes", num_workers=2)) == expected()


@pytest.mark.filterwarnings("ignore")
def test_ray(ray: Any) -> None:
    def states(scenario: Scenario, speed: float) -> Any:
        # Not `last_states`: Ray's workers cannot import this file.
        simulation = Simulation(scenario.with_set({"body.tug.velocity.surge": speed}))
        simulation.run()
        return simulation.states.tolist()

    remote = ray.remote(states)
    scenario = ray.put(TUG)
    assert ray.get([remote.remote(scenario, speed) for speed in SPEEDS]) == expected()
