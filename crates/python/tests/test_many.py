"""Many runs: the order of the variants, the same bits for any number of threads, mistakes with their run."""

import threading

import fenderline
import numpy as np
import pytest
from fenderline import Fleet, ScenarioError, Simulation, SimulationError

SCENARIO = fenderline.example("tug_4kn").with_set({"time.duration": "8 s"})


def speeds(count: int) -> dict[str, np.ndarray]:
    return {
        "body.tug.velocity.surge": np.linspace(0.5, 3.0, count),
        "body.tug.heading": np.linspace(1.2, 1.9, count),
    }


def test_the_same_bits_for_any_number_of_threads() -> None:
    one = fenderline.run_many(SCENARIO, speeds(40), threads=1)
    for threads in (2, 3, 8):
        many = fenderline.run_many(SCENARIO, speeds(40), threads=threads)
        assert (one.states == many.states).all()
        for name in one.pairs:
            assert one.pairs[name].tolist() == many.pairs[name].tolist()


def test_each_run_equals_a_simulation() -> None:
    runs = fenderline.run_many(SCENARIO, speeds(5))
    columns = {key: value.tolist() for key, value in speeds(5).items()}
    for index in range(5):
        simulation = Simulation(SCENARIO.with_set({k: v[index] for k, v in columns.items()}))
        simulation.run()
        assert (simulation.states == runs.states[index]).all()
        pair = simulation.summary()["pairs"]
        mine = runs.pairs["run"] == index
        assert runs.pairs["peak_depth_m"][mine].tolist() == pair["peak_depth_m"].tolist()
        assert runs.verdicts["verdict"][index] == simulation.verdict == "not_rated"
        found = simulation.summary()["findings"]["text"].tolist()
        assert runs.findings["text"][runs.findings["run"] == index].tolist() == found
        assert found == ["ship and tug touched; no permissible load is known for them"]


def test_a_mistake_names_its_run() -> None:
    sets = [{}, {"body.tug.velocity.surge": "1 kn"}, {"body.tug.velocity.surge": "1 t"}]
    with pytest.raises(ScenarioError) as raised:
        fenderline.run_many(SCENARIO, sets)
    assert raised.value.__notes__ == ["in run 2"]
    with pytest.raises(SimulationError, match="other bodies"):
        fenderline.run_many(
            SCENARIO,
            [{"body": {"a": {"outline": [[0, 0], [1, 0], [1, 1]], "fixed": True}}, "pair": []}],
        )


def test_other_python_threads_run_meanwhile() -> None:
    seen = 0
    done = threading.Event()

    def count() -> None:
        nonlocal seen
        while not done.wait(0.001):
            seen += 1

    thread = threading.Thread(target=count)
    thread.start()
    fenderline.run_many(SCENARIO, speeds(2000))
    done.set()
    thread.join()
    assert seen >= 3


def test_a_fleet_equals_its_simulations() -> None:
    scenario = fenderline.example("docking")
    sets = [{"body.ship.velocity.surge": speed} for speed in (0.5, 1.0, 1.5)]
    for threads in (1, 2):
        fleet = Fleet(scenario, sets, threads=threads)
        singles = [Simulation(scenario.with_set(own)) for own in sets]
        assert fleet.control_names == singles[0].control_names
        for step in range(100):
            fleet.controls[:, :] = 0.01 * step
            fleet.step()
            for single in singles:
                single.controls[:] = 0.01 * step
                single.step()
        for index, single in enumerate(singles):
            assert (fleet.states[index] == single.states).all()
        assert (fleet.times_s == 100.0).all()
        fleet.reset([1], [sets[2]])
        assert fleet.times_s.tolist() == [100.0, 0.0, 100.0]
        assert np.isnan(fleet.controls[1]).all()
        with pytest.raises(IndexError):
            fleet.reset([3], [{}])
        with pytest.raises(ValueError, match="the numbers of variants and indices differ"):
            fleet.reset([0, 1], [{}])
