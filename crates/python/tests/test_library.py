"""Every vessel of the library, every example scenario: each runs by herself and has all her results."""

import tomllib
from pathlib import Path
from typing import Any

import pytest
from fenderline import Scenario, Simulation

ROOT = Path(__file__).resolve().parents[3]
SCENARIOS = sorted((ROOT / "scenarios").rglob("*.toml"))


def vessels() -> dict[str, dict[str, Any]]:
    """The vessels of the library, as their files have them."""
    found: dict[str, dict[str, Any]] = {}
    for file in sorted((ROOT / "vessels").glob("*.toml")):
        found |= tomllib.loads(file.read_text("utf-8")).get("vessel", {})
    return found


def has_all_results(simulation: Simulation) -> None:
    """The tables and the tree of the summary are there."""
    assert simulation.summary_tree()["verdict"]["key"] == simulation.verdict
    assert simulation.summary()["verdicts"].rows == 1
    assert simulation.results()["bodies"].rows > 0


@pytest.mark.parametrize("name", vessels())
def test_a_vessel_of_the_library_runs_by_herself(name: str) -> None:
    body: dict[str, Any] = {"vessel": name, "position": [0, 0]}
    if "outline" not in vessels()[name]:
        body["outline"] = [[-50, -8], [50, -8], [50, 8], [-50, 8]]
    tree = {"time": {"step": "0.5 s", "duration": "2 s"}, "body": {"ship": body}}
    simulation = Simulation(Scenario.from_tree(tree), record=True)
    simulation.run()
    has_all_results(simulation)
    assert [own["name"] for own in simulation.summary_tree()["vessels"]] == ["ship"]


@pytest.mark.parametrize("path", SCENARIOS, ids=[path.stem for path in SCENARIOS])
def test_an_example_gives_all_its_results(path: Path) -> None:
    if path.parent.name == "provider":
        pytest.skip("programs that give forces belong to the command line")
    lines = path.read_text("utf-8").splitlines()
    shorter = {"time.duration": "2 s"}
    if "[statistics]" in lines:
        shorter["statistics.from"] = "0 s"
    if any(line.startswith("interval = ") for line in lines):
        shorter["output.interval"] = "0"
    scenario = Scenario.load(path, shorter)
    simulation = Simulation(scenario, record=True)
    simulation.run()
    has_all_results(simulation)
