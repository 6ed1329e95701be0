"""Scenarios: loaded, replaced, edited as trees; mistakes as exceptions with their place."""

from pathlib import Path

import fenderline
import numpy as np
import pytest
from fenderline import Scenario, ScenarioError

TUG = """\
[time]
step = "0.1 s"
duration = "20 s"

[material.rubber]
stiffness = "500 kN/m^2"
restitution = 0.1

[body.tug]
outline = [[-16, -6.5], [16, -6.5], [16, 6.5], [-16, 6.5]]
mass = "930 t"
gyradius = "8 m"
velocity = { surge = "4 kn" }

[body.quay]
fixed = true
outline = [[0, -50], [5, -50], [5, 50], [0, 50]]
position = [20, 0]

[[pair]]
bodies = ["tug", "quay"]
material = "rubber"
"""


def test_properties_of_a_scenario() -> None:
    scenario = Scenario.parse(TUG, "tug.toml")
    assert scenario.bodies == ["tug", "quay"]
    assert scenario.fenders == []
    assert (scenario.title, scenario.name) == ("tug", "tug.toml")
    assert (scenario.step_s, scenario.duration_s) == (0.1, 20.0)


def test_a_scenario_is_made_of_anything(scenarios: Path) -> None:
    path = scenarios / "paper" / "experiment_2_4kn.toml"
    loaded = Scenario.load(path)
    step = {"time.step": "0.05 s"}
    for source in (path, str(path), path.read_text("utf-8"), loaded.tree(), loaded):
        assert Scenario(source).bodies == ["ship", "tug"]
        assert Scenario(source, step).step_s == 0.05
    short = {"time.duration": "3 s"}
    runs = [fenderline.run(source, short) for source in (path, str(path), loaded.tree(), loaded)]
    assert all((run["bodies"]["x_m"] == runs[0]["bodies"]["x_m"]).all() for run in runs)
    with pytest.raises(TypeError, match="a scenario is a path, a text of TOML, .* not <class 'int'>"):
        Scenario(3)  # type: ignore[arg-type]
    with pytest.raises(ScenarioError, match=r"cannot read nowhere\.toml"):
        fenderline.run("nowhere.toml")


def test_keys_are_replaced_as_on_the_command_line(scenarios: Path) -> None:
    path = scenarios / "paper" / "experiment_2_4kn.toml"
    assert Scenario.load(path, {"time.step": "0.05 s"}).step_s == 0.05
    assert Scenario.load(path, ["time.step=0.05 s"]).step_s == 0.05
    scenario = Scenario.load(path).with_set({"time.step": np.float64(0.025)})
    assert scenario.with_set({"time.duration": 3}).step_s == 0.025


def test_a_mistake_names_file_line_column_key_and_help() -> None:
    with pytest.raises(ScenarioError) as raised:
        Scenario.parse(TUG.replace("restitution", "restitutoin"), "tug.toml")
    error = raised.value
    assert (error.file, error.line, error.column) == ("tug.toml", 7, 1)
    assert error.key == "material.rubber.restitutoin"
    assert error.help is not None and "restitution" in error.help
    assert error.message is not None and "\n" not in error.message
    assert "7 | restitutoin = 0.1" in str(error)
    assert isinstance(error, ValueError)


def test_a_mistake_in_a_replaced_key_names_it() -> None:
    with pytest.raises(ScenarioError) as raised:
        Scenario.parse(TUG, set={"time.step": "4 kn"})
    assert raised.value.key == "time.step"
    assert raised.value.line is None
    assert raised.value.file == "set time.step = 4 kn"


def test_a_file_that_is_not_there() -> None:
    with pytest.raises(ScenarioError, match="nowhere.toml"):
        Scenario.load("nowhere.toml")


def test_a_tree_goes_round(scenarios: Path) -> None:
    for path in sorted(scenarios.rglob("*.toml")):
        scenario = Scenario.load(path)
        again = Scenario.from_tree(scenario.tree(), path.name, path.parent)
        assert again.bodies == scenario.bodies, path
        if "provider" in path.parts:
            continue
        one, other = (fenderline.Simulation(s) for s in (scenario, again))
        one.step(20)
        other.step(20)
        assert (one.states == other.states).all(), path


def test_a_tree_includes_replaced_keys() -> None:
    scenario = Scenario.parse(TUG, set={"time.step": 0.5, "body.tug.velocity.surge": "1 kn"})
    tree = scenario.tree()
    assert tree["time"]["step"] == 0.5
    tree["body"]["tug"]["position"] = np.array([1.0, 0.0])
    edited = Scenario.from_tree(tree)
    simulation = fenderline.Simulation(edited)
    assert simulation.states[0].tolist() == [1.0, 0.0, 0.0, 1852 / 3600, 0.0, 0.0]


def test_a_mistake_in_a_tree_names_its_key() -> None:
    tree = Scenario.parse(TUG).tree()
    tree["body"]["tug"]["mass"] = -1
    with pytest.raises(ScenarioError) as raised:
        Scenario.from_tree(tree, "edited")
    assert (raised.value.file, raised.value.key) == ("edited", "body.tug.mass")
    with pytest.raises(TypeError, match="set"):
        Scenario.from_tree({"time": {"step": {1, 2}}})


def test_examples_are_the_scenarios_of_the_repository(scenarios: Path) -> None:
    own = fenderline.example("tug_4kn").text
    assert own == (scenarios / "paper" / "experiment_2_4kn.toml").read_text("utf-8")
