"""FMPy: FMUs of both kinds and versions are valid and give the same bits as `fenderline run`."""

import numpy
import pytest
from conftest import BERTHING, MOORED, TUG
from fmpy import simulate_fmu
from fmpy.fmi1 import FMICallException
from fmpy.validation import validate_fmu
from fmus import Fmu

STATE = ["x_m", "y_m", "heading_rad", "velocity_x_mps", "velocity_y_mps", "r_radps"]
WRENCH = ["force_x_n", "force_y_n", "moment_z_nm"]
PORT = "scenarios/berth/alongside_with_two_tugs.toml"


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("kind", ["engine", "simulation"])
@pytest.mark.parametrize("scenario", [TUG, BERTHING, PORT])
def test_is_valid_without_warnings(fenderline, scenario, kind, fmi):
    assert validate_fmu(str(fenderline.fmu(scenario, kind, fmi))) == []


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("scenario, bodies", [(TUG, ["ship", "tug"]), (BERTHING, ["ship"]), (PORT, ["ship"])])
def test_a_simulation_has_the_bits_of_a_run(fenderline, scenario, bodies, fmi):
    duration = ["--duration", "60"] if scenario != TUG else []
    run = fenderline.run(scenario, *duration)
    rows = {body: run.table("bodies", "body", body) for body in bodies}
    times = sorted(rows[bodies[0]])
    step_s = run.summary["settings"]["step_s"] if "settings" in run.summary else times[1]
    columns = ["x_m", "y_m", "heading_rad", "u_mps", "v_mps", "r_radps"]
    contact = 0.0
    with Fmu(fenderline.fmu(scenario, "simulation", fmi, *duration)) as fmu:
        fmu.initialize()
        for index, t_s in enumerate(times[:-1]):
            for body in bodies:
                row = rows[body][t_s]
                assert fmu.get(*[f"body.{body}.{c}" for c in columns]) == [row[c] for c in columns], t_s
            fmu.step(index * step_s, step_s)
            for body in bodies:
                row = rows[body][t_s]
                got = fmu.get(*[f"body.{body}.{c}" for c in WRENCH])
                assert got == [row[c] for c in WRENCH], t_s
                contact = max(contact, abs(got[1]))
    if scenario != PORT:
        assert contact > 1e5, "there was no contact to compare"


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("scenario", [TUG, BERTHING])
def test_an_engine_has_the_bits_of_a_run_for_the_same_states(fenderline, scenario, fmi):
    """With the states of the simulation and the wind load, forces and fender data equal those of the run."""
    run = fenderline.run(scenario)
    bodies = ["ship", "tug"] if scenario == TUG else ["ship"]
    rows = {body: run.table("bodies", "body", body) for body in bodies}
    fenders = [f"fender_{n}" for n in range(1, 9)] if scenario == BERTHING else []
    touched = {fender: run.table("fenders", "fender", fender) for fender in fenders}
    times = sorted(rows[bodies[0]])
    step_s = times[1]
    forces = 0
    with (
        Fmu(fenderline.fmu(scenario, "simulation", fmi)) as ships,
        Fmu(fenderline.fmu(scenario, "engine", fmi)) as engine,
    ):
        ships.initialize()
        engine.initialize(host__following=False)
        if scenario == BERTHING:
            engine.set_all({"body.ship.load_y_n": 150e3})
        for index, t_s in enumerate(times[:-1]):
            names = [f"body.{body}.{c}" for body in bodies for c in STATE]
            engine.set_all(dict(zip(names, ships.get(*names))))
            engine.step(index * step_s, step_s)
            for body in bodies:
                got = engine.get(*[f"body.{body}.{c}" for c in WRENCH])
                assert got == [rows[body][t_s][c] for c in WRENCH], (body, t_s)
                forces += got[1] != 0.0
            for fender in fenders:
                columns = ["deflection_m", "reaction_n", "peak_reaction_n", "stored_j"]
                row = touched[fender].get(t_s, dict.fromkeys(columns, 0.0))
                assert engine.get(*[f"fender.{fender}.{c}" for c in columns]) == [row[c] for c in columns]
            ships.step(index * step_s, step_s)
    assert forces > 10, "there was no contact to compare"


@pytest.mark.parametrize("fmi", [2, 3])
def test_simulate_fmu(fenderline, fmi):
    """simulate_fmu, with outputs by name: the tug leaves with a tenth of her approach speed."""
    result = simulate_fmu(str(fenderline.fmu(TUG, "simulation", fmi)), output=["body.tug.u_mps", "body.ship.v_mps"])
    closing = result["body.tug.u_mps"] - result["body.ship.v_mps"]
    assert abs(closing[-1] / closing[0] + 0.1) < 0.005
    result = simulate_fmu(str(fenderline.fmu(BERTHING, "simulation", fmi)), output=["fender.fender_7.peak_energy_j"])
    fenders = {fender["name"]: fender for fender in fenderline.run(BERTHING).summary["fenders"]}
    direct = fenders["fender_7"]["peak_energy_j"]
    assert result["fender.fender_7.peak_energy_j"][-1] == direct > 9e5


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("kind", ["engine", "simulation"])
def test_states_are_saved_restored_and_serialised(fenderline, kind, fmi):
    """A restored state, and its bytes in another instance, continue with the same bits."""
    path = fenderline.fmu(TUG, kind, fmi)
    names = [f"body.tug.{c}" for c in WRENCH]
    inputs = {"engine": "body.tug.y_m", "simulation": "body.tug.external_y_n"}[kind]
    value = {"engine": lambda n: -41.0 + 0.2 * n, "simulation": lambda n: 1e4 * n}[kind]

    def play(fmu, first, last):
        seen = []
        for n in range(first, last):
            fmu.set_all({inputs: value(n)})
            fmu.step(0.1 * n, 0.1)
            seen.append(fmu.get(*names))
        return seen

    with Fmu(path, "one") as one, Fmu(path, "two") as two:
        one.initialize()
        play(one, 0, 12)
        if fmi == 2:
            state = one.fmu.getFMUstate()
            data = one.fmu.serializeFMUstate(state)
        else:
            state = one.fmu.getFMUState()
            data = one.fmu.serializeFMUState(state)
        straight = play(one, 12, 40)
        assert any(wrench[1] != 0.0 for wrench in straight)
        with pytest.raises(FMICallException):
            one.step(1.2, 0.1)
        (one.fmu.setFMUstate if fmi == 2 else one.fmu.setFMUState)(state)
        assert play(one, 12, 40) == straight
        two.initialize()
        if fmi == 2:
            other = two.fmu.deSerializeFMUstate(data)
            two.fmu.setFMUstate(other)
            two.fmu.freeFMUstate(other)
            one.fmu.freeFMUstate(state)
        else:
            other = two.fmu.deserializeFMUState(data)
            two.fmu.setFMUState(other)
            two.fmu.freeFMUState(other)
            one.fmu.freeFMUState(state)
        assert play(two, 12, 40) == straight


def test_parameters_change_the_run(fenderline):
    path = fenderline.fmu(TUG, "simulation")
    finals = []
    for restitution in (0.1, 0.5):
        result = simulate_fmu(
            str(path), start_values={"material.paper.restitution": restitution}, output=["body.tug.u_mps"]
        )
        finals.append(result["body.tug.u_mps"][-1])
    assert finals[1] < 3.0 * finals[0] < 0.0


@pytest.mark.parametrize("fmi", [2, 3])
def test_how_the_host_integrates_is_an_enumeration(fenderline, fmi):
    path = fenderline.fmu(TUG, "engine", fmi)
    for value in (1, 2):
        with Fmu(path) as fmu:
            (declared,) = fmu.description.typeDefinitions
            assert [(item.name, int(item.value)) for item in declared.items] == [("forward_euler", 1), ("semi_implicit", 2)]
            fmu.initialize(host__integration=value)
            fmu.step(0.0, 0.1)
    fmu = Fmu(path)
    with pytest.raises(FMICallException):
        fmu.initialize(host__integration=3)
    fmu.close(terminate=False)


def test_the_communication_step_changes_no_bit(fenderline):
    """At common communication points the bits are the same for any communication step."""
    path = fenderline.fmu(TUG, "simulation")
    ends = []
    for step_s in (0.05, 0.1, 0.5):
        with Fmu(path) as fmu:
            fmu.initialize()
            for n in range(round(10 / step_s)):
                fmu.step(n * step_s, step_s)
            ends.append(fmu.get("body.tug.y_m", "body.tug.velocity_y_mps", "body.ship.y_m"))
    assert ends[0] == ends[1] == ends[2]


def test_external_control(fenderline):
    """With external control, rudder and revolutions follow the master, not the scenario."""
    path = fenderline.fmu(PORT, "simulation")
    with Fmu(path) as fmu:
        fmu.initialize()
        fmu.set_all({"vessel.ship.external_control": True, "vessel.ship.rudder_order_rad": 0.3, "vessel.ship.engine_order": 0.5})
        for n in range(600):
            fmu.step(0.1 * n, 0.1)
        rudder, shaft = fmu.get("vessel.ship.rudder_rad", "vessel.ship.shaft_rps")
        assert abs(rudder - 0.3) < 1e-9 and shaft > 0.1


def moored_positions(engine, hours, step_s, load_n):
    """A simple master: it gives current states, steps the engine first, then its ship by forward Euler."""
    mass_kg = 87.8e6 * 1.506
    y_m, v_mps, places = 0.0, 0.0, []
    for n in range(round(hours * 3600 / step_s)):
        engine.set_all({"body.ship.y_m": y_m, "body.ship.velocity_y_mps": v_mps})
        engine.step(n * step_s, step_s)
        (force_n,) = engine.get("body.ship.force_y_n")
        y_m += v_mps * step_s
        v_mps += (force_n + load_n) / mass_kg * step_s
        places.append(y_m)
    return numpy.array(places)


def test_a_moored_ship_does_not_creep(fenderline):
    """An hour on eight fenders under 1.2 MN that is not given to the engine: the static depth is 0.075 m."""
    with Fmu(fenderline.fmu(MOORED, "engine")) as engine:
        engine.initialize(host__delay_steps=0, host__step_s=0.5)
        places = moored_positions(engine, 1.0, 0.5, 1.2e6)
    last = places[len(places) // 2 :]
    assert abs(last[-1] - 0.075) < 0.001
    assert last.max() - last.min() < 0.0005


@pytest.mark.parametrize("fmi", [2, 3])
def test_a_tug_repositioned_into_a_ship_leaves_slowly(fenderline, fmi):
    """The master sets her there at rest, increases the counter, and moves her by forward Euler: she leaves at 0.08 m/s."""
    mass_kg = 930e3 * 1.086
    y_m, v_mps, speeds = -41.0, 1.0, []
    options = ("--method", "coupled", "--set", "time.integrator=semi_implicit")
    with Fmu(fenderline.fmu(TUG, "engine", fmi, *options)) as engine:
        engine.initialize(host__delay_steps=0, host__step_s=0.1)
        for n in range(400):
            if n == 10:
                y_m, v_mps = -38.5, 0.0
                engine.set_all({"body.tug.reposition_count": 1})
            engine.set_all({"body.tug.y_m": y_m, "body.tug.velocity_y_mps": v_mps})
            engine.step(0.1 * n, 0.1)
            force_n, peak_n = engine.get("body.tug.force_y_n", "body.tug.peak_force_y_n")
            assert abs(force_n) < 0.03 * mass_kg and abs(peak_n) < 0.03 * mass_kg, n
            y_m += v_mps * 0.1
            v_mps += force_n / mass_kg * 0.1
            speeds.append(v_mps)
    assert -0.09 < speeds[-1] < -0.07
