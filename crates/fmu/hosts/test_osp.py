"""libcosim, the Open Simulation Platform's master: ships and engine as a system, connected by variable groups."""

from pathlib import Path

import systems
from libcosimpy.CosimEnums import CosimVariableType
from libcosimpy.CosimExecution import CosimExecution
from libcosimpy.CosimLogging import CosimLogLevel, log_output_level
from libcosimpy.CosimObserver import CosimObserver

log_output_level(CosimLogLevel.ERROR)

# The ship's variable groups, named like the engine's.
GROUPS = {
    "position": ("LinearDisplacement", ["x_m", "y_m"]),
    "heading": ("AngularDisplacement", ["heading_rad"]),
    "velocity": ("LinearVelocity", ["velocity_x_mps", "velocity_y_mps"]),
    "rate_of_turn": ("AngularVelocity", ["r_radps"]),
    "contact": ("Force", ["contact_x_n", "contact_y_n"]),
    "contact_moment": ("Torque", ["contact_moment_nm"]),
}


def write_system(folder, system, engine):
    """Writes OspSystemStructure.xml, and the ship's OSP description beside its FMU."""
    groups = "".join(
        f'<{kind} name="{name}">' + "".join(f'<Variable ref="{v}"/>' for v in variables) + f"</{kind}>"
        for name, (kind, variables) in GROUPS.items()
    )
    (folder / "Ship_OspModelDescription.xml").write_text(
        '<?xml version="1.0" encoding="UTF-8"?>'
        '<OspModelDescription xmlns="https://open-simulation-platform.com/OspModelDescription/1.0.0" version="1.0">'
        f"<VariableGroups>{groups}</VariableGroups></OspModelDescription>"
    )
    ships = "".join(
        f'<Simulator name="{name}" source="Ship.fmu"><InitialValues>'
        + "".join(f'<InitialValue variable="{p}"><Real value="{v!r}"/></InitialValue>' for p, v in parameters.items())
        + "</InitialValues></Simulator>"
        for name, parameters in system.ships.items()
    )
    connections = ""
    for ship in system.ships:
        for group in GROUPS:
            ends = [f'<VariableGroup simulator="{ship}" name="{group}"/>', f'<VariableGroup simulator="engine" name="{ship}.{group}"/>']
            if group.startswith("contact"):
                ends.reverse()
            connections += "<VariableGroupConnection>" + "".join(ends) + "</VariableGroupConnection>"
    path = folder / "OspSystemStructure.xml"
    path.write_text(
        '<?xml version="1.0" encoding="UTF-8"?>'
        '<OspSystemStructure xmlns="http://opensimulationplatform.com/MSMI/OSPSystemStructure" version="0.1">'
        f"<StartTime>0.0</StartTime><BaseStepSize>{system.step_s}</BaseStepSize><Algorithm>fixedStep</Algorithm>"
        f'<Simulators><Simulator name="engine" source="{Path(engine).name}"><InitialValues><InitialValue variable="host.step_s">'
        f'<Real value="{system.step_s}"/></InitialValue></InitialValues></Simulator>{ships}</Simulators>'
        f"<Connections>{connections}</Connections></OspSystemStructure>"
    )
    return path


class Osp:
    def __init__(self, fenderline, system):
        engine = fenderline.fmu(system.scenario, "engine", 2, *system.options[:2], name="engine")
        fenderline.ship()
        path = write_system(fenderline.folder, system, engine)
        self.execution = CosimExecution.from_osp_config_file(str(path))
        self.observer = CosimObserver.create_last_value()
        assert self.execution.add_observer(self.observer)
        self.indices = {info.name.decode(): info.index for info in self.execution.slave_infos()}
        self.references = {}
        for name, index in self.indices.items():
            for variable in self.execution.slave_variables(index):
                if variable.type == CosimVariableType.REAL.value:
                    self.references[name, variable.name.decode()] = variable.reference

    def step(self):
        assert self.execution.step(), "the master stopped"

    def get(self, simulator, names):
        references = [self.references[simulator, name] for name in names]
        return dict(zip(names, self.observer.last_real_values(self.indices[simulator], references)))


def play(fenderline, system, watch="ship", each=None):
    """Runs to the end; returns the peak force on a body and the ships' final states."""
    osp = Osp(fenderline, system)
    peak_n = 0.0
    for step in range(round(system.until_s / system.step_s)):
        osp.step()
        force_n = osp.get("engine", [f"body.{watch}.force_y_n"])
        peak_n = max(peak_n, *map(abs, force_n.values()))
        if each:
            each(step + 1, osp)
    return peak_n, {ship: osp.get(ship, systems.STATE) for ship in system.ships}


def test_a_tug_at_4_kn(fenderline):
    system = systems.IMPACT
    run = fenderline.run(system.scenario, *system.options)
    systems.compare_impact(run, *play(fenderline, system))


def test_the_berthing_on_eight_fenders(fenderline):
    system = systems.BERTHING
    between = {}

    def each(step, osp):
        if step == 500:
            between.update(osp.get("ship", systems.STATE))

    peak_n, states = play(fenderline, system, each=each)
    systems.compare_berthing(fenderline.run(system.scenario), peak_n, between, states)


def test_a_moored_ship_neither_creeps_nor_gains_energy_for_an_hour(fenderline):
    system = systems.MOORED
    places, speeds = [], []

    def each(step, osp):
        if step % 10 == 0:
            state = osp.get("ship", systems.STATE)
            places.append((state["x_m"], state["y_m"]))
            speeds.append(abs(state["velocity_y_mps"]))

    play(fenderline, system, each=each)
    half = places[len(places) // 2 :]
    y = [place[1] for place in half]
    print(f"\nat rest at {y[-1]:.6f} m (static depth 0.075), within {max(y) - min(y):.2e} m; speed {max(speeds[-600:]):.1e} m/s")
    assert abs(y[-1] - 0.075) < 0.001
    assert max(y) - min(y) < 0.0005
    assert max(speeds[-600:]) <= max(speeds[:600]) and max(speeds[-600:]) < 1e-4
    assert max(abs(place[0]) for place in places) < 1e-6


