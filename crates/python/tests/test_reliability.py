"""Rare events: closed forms by each method, bad input, and the worked berth in a small form."""

from __future__ import annotations

import importlib.util
import math
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from fenderline import reliability

pytest.importorskip("openturns")

BARGE = (Path(__file__).resolve().parents[3] / "crates" / "campaign" / "tests" / "barge.toml").read_text()

SPEED = """
scenario = "barge.toml"
number = 60
[variable.speed]
key = "body.barge.velocity.sway"
distribution = "lognormal"
mean = "7.1 cm/s"
standard_deviation = "4.47 cm/s"
[limit.reaction]
output = "reaction"
value = "1000 kN"
[limit.often]
output = "reaction"
value = "200 kN"
[limit.never]
output = "reaction"
value = "1000000000 kN"
[limit.mega]
output = "reaction"
value = "1 MN"
"""

#: Reaction of a speed: the root of stiffness times mass.
KN_PER_CMPS = math.sqrt(2.5e6 * 1e6) / 1e5
DEVIATION = math.sqrt(math.log1p((4.47 / 7.1) ** 2))
MEAN = math.log(7.1) - 0.5 * DEVIATION**2


def truth(reaction_kn: float) -> tuple[float, float]:
    """Reliability index and probability of a reaction."""
    index = (math.log(reaction_kn / KN_PER_CMPS) - MEAN) / DEVIATION
    return index, 0.5 * math.erfc(index / math.sqrt(2.0))


@pytest.fixture
def file(tmp_path: Path) -> Path:
    (tmp_path / "barge.toml").write_text(BARGE)
    (tmp_path / "speeds.toml").write_text(SPEED)
    return tmp_path / "speeds.toml"


def test_every_method_meets_the_closed_form(file: Path) -> None:
    state = reliability.LimitState(file, "reaction")
    index, probability = truth(1000.0)
    assert 1e-5 < probability < 1e-3
    near = reliability.form(state, starts=1)
    # The reaction of the run is right to 2e-4, and the search stops within 1e-3.
    assert near.index == pytest.approx(index, rel=2e-3)
    assert near.estimate.probability == pytest.approx(probability, rel=0.02)
    assert near.importance == {"speed": pytest.approx(1.0)} and near.others == []
    assert near.values["speed"] == pytest.approx(1000.0 / KN_PER_CMPS, rel=2e-3)
    # One variable: the limit has no curvature.
    assert reliability.sorm(state, near).probability == near.estimate.probability
    drawn = reliability.importance_sampling(state, near, runs=1000)
    assert drawn.runs == 1000 and drawn.low < probability < drawn.high
    assert drawn.high / drawn.low < 1.5
    stepped = reliability.subset_simulation(state, runs=4000)
    assert stepped.low < probability < stepped.high and stepped.runs <= 4000
    assert state.runs == near.estimate.runs + 1 + 1000 + stepped.runs + 4


def test_a_limit_is_in_the_unit_of_its_column_whatever_the_files(file: Path) -> None:
    assert reliability.LimitState(file, "mega").value == reliability.LimitState(file, "reaction").value == 1000.0


def test_a_plain_campaign_has_a_band(file: Path) -> None:
    state = reliability.LimitState(file, "often")
    found = reliability.plain(state, runs=800, seed=4)
    assert found.runs == state.runs == 800
    assert found.low < truth(200.0)[1] < found.high
    assert found.once_in == pytest.approx(1.0 / found.probability)
    nothing = reliability.plain(reliability.LimitState(file, "never"), runs=100)
    assert nothing.probability == nothing.low == 0.0 and nothing.high == pytest.approx(1.0 - 0.025 ** (1 / 100), rel=1e-6)
    assert nothing.once_in == math.inf


def test_bad_input_is_told(file: Path) -> None:
    with pytest.raises(reliability.ReliabilityError, match="did you mean 'reaction'"):
        reliability.LimitState(file, "reactoin")
    state = reliability.LimitState(file, "never")
    with pytest.raises(reliability.ReliabilityError, match="no design point from 2 starts"):
        reliability.form(state, starts=2)
    with pytest.raises(reliability.ReliabilityError, match="subset simulation"):
        reliability.subset_simulation(state, runs=900)
    with pytest.raises(reliability.ReliabilityError, match="at least 100 runs a step"):
        reliability.subset_simulation(state, runs=100)
    with pytest.raises(reliability.ReliabilityError, match="scores"):
        state.margins(np.array([[math.nan]]))


def test_a_run_that_fails_is_named_and_not_taken_as_safe(file: Path) -> None:
    # A mass below 0 is no scenario: the median is one, the score -1 is none.
    file.write_text(SPEED.replace("velocity.sway", "mass").replace('"lognormal"', '"normal"').replace('"7.1 cm/s"', '"10 t"').replace('"4.47 cm/s"', '"100 t"'))
    state = reliability.LimitState(file, "reaction")
    with pytest.raises(reliability.ReliabilityError, match="gave no reaction; the first had {'speed'"):
        state.margins(np.array([[0.0], [-1.0]]))


@pytest.fixture(scope="module")
def example(root: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location("rare_event", root / "examples" / "python" / "rare_event.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_worked_berth_in_a_small_form(example: ModuleType) -> None:
    state = reliability.LimitState(example.FILE, "rated")
    near, found = example.estimates(state, 6_000, 1)
    assert state.runs < 6_000
    plain = example.kept()
    for own in found:
        if not math.isnan(own.low):
            assert own.low < plain.high and plain.low < own.high, (str(own), str(plain))
    # Bow first and stern first are two ways to the same failure: FORM counts one of them.
    assert len(near.others) == 1 and near.estimate.probability < plain.low
    ways = {math.copysign(1.0, float(str(point.values["heading"]))) for point in (near, near.others[0])}
    assert ways == {-1.0, 1.0} and near.importance["speed"] > 0.6
    way = reliability.along(state, near, points=9)
    assert way["share"][0] == 0.0 and abs(float(np.interp(1.0, way["share"], way["margin"]))) < 0.1
    assert str(example.table([*found, plain])).count("\n") == 6
