"""Many runs: the order of the variants, the same bits for any number of threads, mistakes with their run."""

import signal
import sys
import threading
import time
from pathlib import Path
from typing import Any

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
    for threads in (2, 3, 8, 100):
        many = fenderline.run_many(SCENARIO, speeds(40), threads=threads)
        assert (one.states == many.states).all()
        assert_same_tables(one, many)


def assert_same_tables(one: fenderline.Runs, other: fenderline.Runs) -> None:
    for table in ("pairs", "fenders", "dolphins", "berthings", "verdicts", "findings"):
        own, others = getattr(one, table), getattr(other, table)
        assert list(own) == list(others)
        for name in own:
            np.testing.assert_array_equal(own[name], others[name], err_msg=f"{table} {name}")


def test_runs_that_differ_in_what_they_touch_have_the_same_tables_for_any_number_of_threads(
    scenarios: Path,
) -> None:
    # Each run has other fenders, findings and verdicts, and some have none.
    path = scenarios / "berth" / "eight_cones_at_5_deg.toml"
    sets = [
        {"time.duration": f"{seconds} s", "body.ship.velocity.sway": speed}
        for seconds in (1, 15)
        for speed in (0.1, 0.16, 0.2, 0.25)
    ]
    one = fenderline.run_many(path, sets, threads=1)
    assert len({*one.findings["text"]}) > 2
    assert len({*one.fenders["fender"]}) > 1
    assert {*one.fenders["run"]} < {*range(8)}
    for threads in (2, 8):
        assert_same_tables(one, fenderline.run_many(path, sets, threads=threads))


def test_columns_of_any_kind_equal_dictionaries() -> None:
    columns: dict[str, Any] = {
        "body.tug.velocity.surge": np.array([0.5, 1.0, 1.0, 2.0])[::-1],
        "body.tug.heading": ["85 deg", 1.5, np.float64(1.6), np.float32(1.5)],
        "body.tug.position": np.array([[0, -41], [1, -41], [0.5, -42], [0, -40]]),
        "time.duration": np.array([3, 4, 5, 6]),
    }
    sets = [{key: values[run] for key, values in columns.items()} for run in range(4)]
    by_columns, by_sets = fenderline.run_many(SCENARIO, columns), fenderline.run_many(SCENARIO, sets)
    assert (by_columns.states == by_sets.states).all()
    assert_same_tables(by_columns, by_sets)
    assert by_columns.variants[0]["body.tug.velocity.surge"] == 2.0
    assert fenderline.run_many(SCENARIO, {}).states.shape == (0, 2, 6)


def test_a_mistake_in_a_column_names_its_run() -> None:
    with pytest.raises(ScenarioError, match="^run 1: ") as raised:
        fenderline.run_many(SCENARIO, {"body.tug.velocity.surge": np.array([1.0, np.nan, 1.0])})
    assert (raised.value.run, raised.value.key) == (1, "body.tug.velocity.surge")
    with pytest.raises(ScenarioError, match="^run 0: .*is not a key"):
        fenderline.run_many(SCENARIO, {"body..surge": [1.0, 2.0]})
    with pytest.raises(TypeError, match="^run 1: set cannot be used"):
        fenderline.run_many(SCENARIO, {"time.step": [0.1, {1}]})


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
        (sentence,) = found
        assert sentence.startswith("ship and tug touched with at most ")


def test_variants_of_the_start_and_of_other_keys_in_any_order_equal_simulations() -> None:
    # Runs that differ in their start alone share one simulation; the others have their own.
    sets: list[dict[str, Any]] = [
        {"body.tug.velocity.surge": "3 kn"},
        {"material.paper.stiffness": "1 MN/m^2"},
        {},
        {"body.tug.velocity": {"surge": 1.0}, "body.tug.heading": "85 deg"},
        {"material.paper.stiffness": "1 MN/m^2", "body.tug.position": [1, -41]},
        {"body.tug.velocity.surge": "3 kn"},
    ]
    runs = fenderline.run_many(SCENARIO, sets, threads=1)
    fleet = Fleet(SCENARIO, [{}] * len(sets))
    fleet.step(100)
    fleet.reset(list(range(len(sets))), sets)
    fleet.reset([0, 1], [sets[1], sets[0]])
    fleet.reset([0, 1], sets[:2])
    fleet.step(80)
    for index, own in enumerate(sets):
        simulation = Simulation(SCENARIO.with_set(own))
        simulation.run()
        assert (simulation.states == runs.states[index]).all()
        assert (simulation.states == fleet.states[index]).all()


def test_a_mistake_names_its_run() -> None:
    sets = [{}, {"body.tug.velocity.surge": "1 kn"}, {"body.tug.velocity.surge": "1 t"}]
    for threads in (1, 4):
        with pytest.raises(ScenarioError, match="^run 2: error: `body.tug.velocity.surge`") as raised:
            fenderline.run_many(SCENARIO, [*sets, *sets], threads=threads)
        assert (raised.value.run, raised.value.key) == (2, "body.tug.velocity.surge")
    with pytest.raises(SimulationError, match="^run 0: .*other bodies"):
        fenderline.run_many(
            SCENARIO,
            [{"body": {"a": {"outline": [[0, 0], [1, 0], [1, 1]], "fixed": True}}, "pair": []}],
        )
    with pytest.raises(TypeError, match="^run 1: set cannot be used"):
        fenderline.run_many(SCENARIO, [{}, {"time.step": {1}}])
    with pytest.raises(ValueError, match="one value per run"):
        fenderline.run_many(SCENARIO, {"time.step": [0.1], "time.duration": [1.0, 2.0]})


LONG = SCENARIO.with_set({"time.duration": "5000000 s"})


@pytest.mark.usefixtures("interruptible")
@pytest.mark.parametrize("runs", [1, 500])
@pytest.mark.parametrize("threads", [1, 3])
def test_an_interrupt_stops_many_runs_at_once(threads: int, runs: int) -> None:
    raised_s: list[float] = []

    def interrupt() -> None:
        raised_s.append(time.monotonic())
        signal.raise_signal(signal.SIGINT)

    timer = threading.Timer(0.3, interrupt)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        fenderline.run_many(LONG, [{}] * runs, threads=threads)
    late_s = time.monotonic() - raised_s[0]
    timer.join()
    print(f"noticed after {late_s:.3f} s")
    # Looked for each 0.02 s; a machine that is busy with other work takes longer.
    assert late_s < 1.0


def test_progress_is_told() -> None:
    told: list[tuple[int, int]] = []
    fenderline.run_many(
        SCENARIO, speeds(20_000), progress=lambda done, total: told.append((done, total))
    )
    assert told[-1] == (20_000, 20_000)
    assert [done for done, _ in told] == sorted(done for done, _ in told)
    assert len(told) >= 2
    assert fenderline.run_many(SCENARIO, [], progress=lambda *_: None).states.shape == (0, 2, 6)


def test_an_exception_of_progress_stops_the_runs() -> None:
    def stop(done: int, total: int) -> None:
        raise RuntimeError(f"enough after {done}")

    with pytest.raises(RuntimeError, match="enough after"):
        fenderline.run_many(SCENARIO, speeds(5000), progress=stop)


def test_progress_as_a_bar(capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("tqdm", reason="tqdm is not installed")
    fenderline.run_many(SCENARIO, speeds(20), progress=True)
    assert "20/20" in capsys.readouterr().err


def test_progress_as_a_line(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    fenderline.run_many(SCENARIO, speeds(20), progress=True)
    assert "20 of 20 runs" in capsys.readouterr().err


def test_runs_as_a_data_frame(scenarios: Path) -> None:
    path = scenarios / "berth" / "eight_cones_at_5_deg.toml"
    runs = fenderline.run_many(path, [{"time.duration": "30 s"}, {"time.duration": "40 s"}])
    frame = runs.to_pandas()
    assert frame.index.name == "run"
    assert frame["time.duration"].tolist() == ["30 s", "40 s"]
    for run in range(2):
        own = runs.fenders["run"] == run
        assert frame["peak_energy_j"][run] == runs.fenders["peak_energy_j"][own].max()
        assert frame["fender"][run] in runs.fenders["fender"][own]
    assert (frame["berthing_energy_j"] > 0).all()
    assert "2 runs" in runs._repr_html_()


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
        with pytest.raises(ValueError, match="there must be as many variants as indices"):
            fleet.reset([0, 1], [{}])
