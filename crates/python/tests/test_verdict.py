"""The verdict on the cases of `crates/app/tests/verdict/cases.json`, which the program's own test reads too."""

import json
from pathlib import Path
from typing import Any

import pytest
from fenderline import Scenario, Simulation

FOLDER = Path(__file__).resolve().parents[2] / "app" / "tests" / "verdict"
CASES: list[dict[str, Any]] = json.loads((FOLDER / "cases.json").read_text("utf-8"))["cases"]


@pytest.mark.parametrize("case", CASES, ids=[case["name"] for case in CASES])
def test_the_verdict_on_a_known_case(case: dict[str, Any]) -> None:
    simulation = Simulation(Scenario.load(FOLDER / case["scenario"], case["set"]))
    simulation.run()
    findings = simulation.summary()["findings"]
    if case["key"] == "all_well":
        assert findings.rows == 0
    else:
        assert case["key"] in findings["finding"].tolist()
        assert any(case["sentence"] in text for text in findings["text"].tolist())
    if "law" in case:
        row = findings["law"].tolist().index(case["law"])
        assert findings["finding"].tolist()[row] == case["key"]
        assert 0 < findings["share_of_run"][row] <= 1
        assert findings["from_s"][row] >= 0
        told = simulation.summary_tree()["verdict"]["findings"]
        assert case["law"] in [finding.get("law") for finding in told]
    if case.get("is_worst", True):
        assert simulation.verdict == case["key"]
