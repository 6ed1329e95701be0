"""ecos, NTNU's master, which steps all FMUs at the same time, as libcosim does."""

import ctypes
import sys
from pathlib import Path

import systems

if sys.platform == "linux":
    # The package 0.7.2 needs this library but does not load it.
    ctypes.CDLL(str(Path(sys.prefix) / "lib" / "libtbb.so.12"), ctypes.RTLD_GLOBAL)

from ecospy import EcosSimulation, EcosSimulationStructure  # noqa: E402


def play(fenderline, system, watch="ship", at=()):
    structure = EcosSimulationStructure()
    engine = fenderline.fmu(system.scenario, "engine", 2, *system.options[:2])
    structure.add_model("engine", str(engine))
    parameters = {"engine::host.step_s": system.step_s}
    for ship, values in system.ships.items():
        structure.add_model(ship, str(fenderline.ship()))
        parameters |= {f"{ship}::{name}": float(value) for name, value in values.items()}
        for name in systems.STATE:
            structure.make_real_connection(f"{ship}::{name}", f"engine::body.{ship}.{name}")
        for to, name in systems.WRENCH.items():
            structure.make_real_connection(f"engine::body.{ship}.{name}", f"{ship}::{to}")
    structure.add_parameter_set("start", parameters)
    peak_n, seen = 0.0, {}
    with EcosSimulation(structure=structure, step_size=system.step_s) as simulation:
        assert simulation.init(parameter_set="start")
        state = lambda ship: {name: simulation.get_real(f"{ship}::{name}") for name in systems.STATE}
        for step in range(round(system.until_s / system.step_s)):
            simulation.step()
            peak_n = max(peak_n, abs(simulation.get_real(f"engine::body.{watch}.force_y_n")))
            if step + 1 in at:
                seen[step + 1] = state(watch)
        states = {ship: state(ship) for ship in system.ships}
        simulation.terminate()
    return peak_n, states, seen


def test_a_tug_at_4_kn(fenderline):
    system = systems.IMPACT
    peak_n, states, _ = play(fenderline, system)
    systems.compare_impact(fenderline.run(system.scenario, *system.options), peak_n, states)


def test_the_berthing_on_eight_fenders(fenderline):
    system = systems.BERTHING
    peak_n, states, seen = play(fenderline, system, at=(500,))
    systems.compare_berthing(fenderline.run(system.scenario), peak_n, seen[500], states)
