"""The engine: arrays, steps, refused calls, save and restore."""

import copy
import gc
from pathlib import Path
from typing import Literal

import fenderline
import numpy as np
import pytest
from fenderline import Engine, EngineError, Scenario

TUG_MASS_KG = 930e3


def coupled_tug() -> Scenario:
    return fenderline.example("tug_4kn").with_set(
        {"contact.method": "coupled", "time.integrator": "semi_implicit"}
    )


def test_the_engine_moves_bodies_like_the_simulation() -> None:
    scenario = coupled_tug()
    engine, simulation = Engine(scenario), fenderline.Simulation(scenario)
    for _ in range(200):
        simulation.step()
        engine.step(0.1)
        assert (engine.wrenches == simulation.wrenches).all()
        assert (engine.states_after == simulation.states).all()
        assert engine.contacts.tolist() == simulation.contacts.tolist()
        engine.states[:] = engine.states_after


def test_a_cosimulation_host_moves_its_bodies_itself() -> None:
    engine = Engine(coupled_tug(), host="cosimulation", integration="semi_implicit")
    tug = engine.bodies.index("tug")
    mass_kg = TUG_MASS_KG * 1.086
    largest = 0.0
    for _ in range(100):
        engine.step(0.1)
        largest = max(largest, float(np.hypot(*engine.wrenches[tug, :2])))
        engine.states[tug, 3:5] += engine.wrenches[tug, :2] / mass_kg * 0.1
        engine.states[tug, 0:2] += engine.states[tug, 3:5] * 0.1
    assert largest > 1e6
    assert engine.states[tug, 4] < 0


def test_views_share_memory_and_results_are_read_only() -> None:
    engine = Engine(coupled_tug())
    states, wrenches = engine.states, engine.wrenches
    assert engine.states is states
    assert engine.wrenches is wrenches
    engine.states[1, 1] = -38.5
    engine.step(0.1)
    assert wrenches[1, 1] < 0  # the view from before the step shows its results
    with pytest.raises(ValueError, match="read-only"):
        wrenches[0, 0] = 1.0
    with pytest.raises(AttributeError):
        engine.states = np.zeros((2, 6))  # type: ignore[misc]


def test_views_outlive_their_engine() -> None:
    engine = Engine(coupled_tug())
    engine.step(0.1)
    states, wrenches, after = engine.states, engine.wrenches, engine.states_after
    expected = states.copy()
    del engine
    gc.collect()
    other_memory = [np.full(1000, 7.0) for _ in range(100)]
    assert (states == expected).all()
    assert wrenches.shape == (2, 3)
    assert np.isfinite(after).all()
    del other_memory


def test_an_array_of_another_size_is_refused() -> None:
    engine = Engine(coupled_tug())
    engine.states.resize((1, 6), refcheck=False)
    with pytest.raises(ValueError, match="6 numbers, but needs 12"):
        engine.step(0.1)


def test_contacts_are_a_structured_array() -> None:
    engine = Engine(coupled_tug())
    engine.states[1, 1] = -38.5
    engine.step(0.1)
    contacts = engine.contacts
    assert contacts.dtype == fenderline.CONTACT_TYPE
    assert contacts["body_1"].tolist() == [0]
    assert contacts["fender"].tolist() == [-1]
    assert contacts["depth_m"][0] == pytest.approx(0.5)
    parts = contacts["spring_n"] + contacts["stop_n"] + contacts["damper_n"]
    assert contacts["normal_force_n"] == pytest.approx(parts - contacts["limiter_n"])
    assert [event.kind for event in engine.events] == ["contact_began", "placed_in_overlap"]
    assert engine.events[0].subjects == ["ship", "tug"]


def test_refused_calls_change_nothing() -> None:
    engine = Engine(coupled_tug())
    with pytest.raises(EngineError, match="no results"):
        engine.contacts  # noqa: B018
    engine.states[1, 1] = -38.5
    engine.step(0.1)
    saved = engine.save()
    engine.states[1, 3] = np.nan
    with pytest.raises(EngineError, match="tug"):
        engine.step(0.1)
    engine.states[1, 3] = 0.0
    engine.loads[1, 0] = np.inf
    with pytest.raises(EngineError, match="tug"):
        engine.step(0.1)
    engine.loads[1, 0] = 0.0
    for step_s in (-1.0, np.nan):
        with pytest.raises(EngineError):
            engine.step(step_s)
    engine.restore(saved)
    assert engine.save() == saved


@pytest.mark.parametrize("host", ["direct", "cosimulation"])
def test_a_pause_changes_nothing(host: Literal["direct", "cosimulation"]) -> None:
    engine = Engine(coupled_tug(), host=host)
    engine.step(0.0)
    assert not engine.wrenches.any()
    engine.states[1, 1] = -38.9
    for _ in range(3):
        engine.step(0.1)
    wrenches, saved = engine.wrenches.copy(), engine.save()
    engine.step(0.0)
    assert np.array_equal(engine.wrenches, wrenches) and not engine.events
    if host == "direct":
        assert np.array_equal(engine.states_after, engine.states)
    engine.restore(saved)
    engine.step(0.0)
    assert np.array_equal(engine.wrenches, wrenches)


def test_a_tug_placed_in_a_ship_is_pressed_out_slowly() -> None:
    engine = Engine(coupled_tug())
    engine.states[1, 3:] = 0.0
    engine.step(0.1)
    engine.states[1, 1] = -36.0  # three metres into her side
    engine.mark_teleported("tug")
    engine.step(0.1)
    assert {"teleported", "placed_in_overlap"} <= {event.kind for event in engine.events}
    fastest_mps = 0.0
    for _ in range(600):
        engine.states[:] = engine.states_after
        engine.step(0.1)
        fastest_mps = max(fastest_mps, float(np.hypot(engine.states[1, 3], engine.states[1, 4])))
    assert 0.07 < fastest_mps < 0.1
    assert not len(engine.contacts)
    with pytest.raises(EngineError, match="barge"):
        engine.mark_teleported("barge")


def test_peak_wrenches_are_reported_beside_the_means() -> None:
    engine = Engine(coupled_tug())
    assert (engine.peak_wrenches == 0.0).all()
    engine.states[1, 1] += 1.0
    engine.step(4.0)
    assert engine.peak_wrenches[1, 1] < 3.0 * engine.wrenches[1, 1] < 0.0
    assert abs(engine.peak_wrenches[0, 1] / engine.peak_wrenches[1, 1] + 1.0) < 1e-9
    assert not engine.peak_wrenches.flags.writeable
    saved, peaks = engine.save(), engine.peak_wrenches.copy()
    other = Engine(coupled_tug())
    other.restore(saved)
    assert (other.peak_wrenches == peaks).all()
    engine.reset()
    assert (engine.peak_wrenches == 0.0).all()


def test_save_restore_and_copy() -> None:
    engine = Engine(coupled_tug())
    engine.states[1, 1] = -38.9
    for _ in range(3):
        engine.step(0.1)
        engine.states[:] = engine.states_after
    saved, other = engine.save(), copy.copy(engine)
    later: list[np.ndarray] = []
    for run in (engine, other, engine):
        if run is engine and later:
            run.restore(saved)
        for _ in range(10):
            run.step(0.1)
            run.states[:] = run.states_after
        later.append(run.states.copy())
    assert (later[0] == later[1]).all()
    assert (later[0] == later[2]).all()
    fresh = Engine(coupled_tug())
    fresh.restore(saved)
    assert fresh.save() == saved


@pytest.mark.parametrize("cut", [0, 7, 100, -1])
def test_invalid_bytes_are_refused(cut: int) -> None:
    engine = Engine(coupled_tug())
    engine.step(0.1)
    saved = engine.save()
    with pytest.raises(EngineError):
        engine.restore(saved[:cut])
    broken = bytearray(saved)
    broken[cut] ^= 1
    with pytest.raises(EngineError):
        engine.restore(bytes(broken))
    assert engine.save() == saved


def test_reset_returns_to_the_start() -> None:
    engine = Engine(coupled_tug())
    start = engine.states.copy()
    engine.states[1, 1] = -38.5
    engine.step(0.1)
    engine.reset()
    assert (engine.states == start).all()
    assert not engine.wrenches.any()


def test_conflicting_settings_are_refused(scenarios: Path) -> None:
    scenario = fenderline.example("tug_4kn")
    with pytest.raises(EngineError, match="paper"):
        Engine(scenario, host="cosimulation")
    with pytest.raises(ValueError, match="delay_steps"):
        Engine(scenario, delay_steps=1)
    with pytest.raises(ValueError, match="direct, cosimulation"):
        Engine(scenario, host="absent")  # type: ignore[arg-type]
    paper = Engine(scenario)
    assert (paper.method, paper.uses_loads) == ("paper", False)
    with pytest.raises(EngineError, match="has no loads"):
        paper.uses_loads = True
    with pytest.raises(EngineError, match="states after"):
        paper.states_after  # noqa: B018
    berth = Scenario.load(scenarios / "berth" / "alongside_with_two_tugs.toml")
    assert "the engine leaves to the host: 2 parts of the scenario of the kind \"tug\"" in Engine(berth).notices
