"""Campaigns: the same table whoever makes the runs, and methods for rare events and sensitivity."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import fenderline
from fenderline import campaign

BARGE = (Path(__file__).resolve().parents[3] / "crates" / "campaign" / "tests" / "barge.toml").read_text()

SPEED = """
scenario = "barge.toml"
number = 60
[variable.speed]
key = "body.barge.velocity.sway"
distribution = "lognormal"
mean = "7.1 cm/s"
standard_deviation = "4.47 cm/s"
"""

#: Reaction of a speed: the root of stiffness times mass.
KN_PER_CMPS = np.sqrt(2.5e6 * 1e6) / 1e5
#: Mean and standard deviation of the logarithm of the speed in cm/s.
DEVIATION = float(np.sqrt(np.log1p((4.47 / 7.1) ** 2)))
MEAN = float(np.log(7.1) - 0.5 * DEVIATION**2)


@pytest.fixture
def speeds(tmp_path: Path) -> campaign.Campaign:
    (tmp_path / "barge.toml").write_text(BARGE)
    (tmp_path / "speeds.toml").write_text(SPEED)
    return campaign.load(tmp_path / "speeds.toml")


def tables(folder: Path) -> tuple[bytes, bytes]:
    return (folder / "cases.csv").read_bytes(), (folder / "cases.parquet").read_bytes()


@pytest.fixture
def whole(speeds: campaign.Campaign, tmp_path: Path) -> tuple[bytes, bytes]:
    campaign.run(speeds, tmp_path / "whole", threads=1)
    return tables(tmp_path / "whole")


def test_the_rows_are_those_of_the_file(speeds: campaign.Campaign, whole: tuple[bytes, bytes], tmp_path: Path) -> None:
    frame = campaign.read(tmp_path / "whole")
    assert len(frame) == 60 and list(frame.columns[:2]) == ["case", "speed"]
    assert frame["speed"][4] == speeds.draw(4)["speed"]
    assert speeds.settings(4) == [f"body.barge.velocity.sway={frame['speed'][4]} cm/s"]
    moved = frame[frame["speed"] > 2.0]
    np.testing.assert_allclose(moved["reaction"], KN_PER_CMPS * moved["speed"], rtol=2e-4)


def test_threads_and_chunks_do_not_change_the_table(
    speeds: campaign.Campaign, whole: tuple[bytes, bytes], tmp_path: Path
) -> None:
    seen: list[int] = []
    campaign.run(speeds, tmp_path / "out", chunk=7, threads=2, progress=lambda done, total: seen.append(done))
    assert tables(tmp_path / "out") == whole
    assert seen[-1] == 60 and seen == sorted(seen)


def test_processes_give_the_same_table(
    speeds: campaign.Campaign, whole: tuple[bytes, bytes], tmp_path: Path
) -> None:
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
        campaign.run(speeds, tmp_path / "out", executor=pool, chunk=10)
    assert tables(tmp_path / "out") == whole


def test_joblib_gives_the_same_table(speeds: campaign.Campaign, whole: tuple[bytes, bytes], tmp_path: Path) -> None:
    joblib = pytest.importorskip("joblib")

    def mapped(work: Callable[[Any], bytes], parts: list[Any]) -> list[bytes]:
        return list(joblib.Parallel(n_jobs=2)(joblib.delayed(work)(part) for part in parts))

    campaign.run(speeds, tmp_path / "out", executor=mapped, chunk=10)
    assert tables(tmp_path / "out") == whole


def test_a_dask_cluster_of_two_workers_gives_the_same_table(
    speeds: campaign.Campaign, whole: tuple[bytes, bytes], tmp_path: Path
) -> None:
    distributed = pytest.importorskip("distributed")
    dask = pytest.importorskip("dask")
    with (
        dask.config.set({"distributed.comm.timeouts.connect": "120s"}),
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True, host="127.0.0.1", dashboard_address=None
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        campaign.run(speeds, tmp_path / "out", executor=client, chunk=10)
    assert tables(tmp_path / "out") == whole


def test_ray_gives_the_same_table(
    ray: Any, speeds: campaign.Campaign, whole: tuple[bytes, bytes], tmp_path: Path
) -> None:
    def mapped(work: Callable[[Any], bytes], parts: list[Any]) -> list[bytes]:
        remote = ray.remote(work)
        return list(ray.get([remote.remote(part) for part in parts]))

    campaign.run(speeds, tmp_path / "out", executor=mapped, chunk=10)
    assert tables(tmp_path / "out") == whole


def test_a_campaign_with_a_file_goes_to_other_processes_from_a_relative_path(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "barge.toml").write_text(BARGE)
    (tmp_path / "measured.csv").write_text("speed [cm/s]\n3\n5\n8\n")
    law = 'mean = "7.1 cm/s"\nstandard_deviation = "4.47 cm/s"\n'
    measured = SPEED.replace('"lognormal"', '"empirical"').replace(law, 'file = "measured.csv"\n')
    (tmp_path / "measured.toml").write_text(measured)
    monkeypatch.chdir(tmp_path)
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
        campaign.run("measured.toml", "out", executor=pool, chunk=20)
    assert set(campaign.read("out")["speed"]) == {3.0, 5.0, 8.0}


def test_mistakes(speeds: campaign.Campaign, tmp_path: Path) -> None:
    campaign.run(speeds, tmp_path / "out")
    with pytest.raises(fenderline.CampaignError, match="holds a campaign already"):
        campaign.run(speeds, tmp_path / "out")
    campaign.run(speeds, tmp_path / "out", replace=True)
    with pytest.raises(IndexError, match="there are 60"):
        speeds.draw(60)
    with pytest.raises(IndexError, match="there are 60"):
        speeds.run(0, 61)
    with pytest.raises(fenderline.CampaignError, match="did you mean `reaction`"):
        campaign.evaluate(speeds, [[0.5]], ["reation"])
    with pytest.raises(fenderline.CampaignError, match="2 probabilities for 1 variables"):
        campaign.evaluate(speeds, [[0.5, 0.5]], ["reaction"])
    with pytest.raises(fenderline.CampaignError, match="not between 0 and 1"):
        campaign.evaluate(speeds, [[1.0]], ["reaction"])
    with pytest.raises(fenderline.CampaignError, match="40 runs have no row; the first of these runs has the number 20"):
        speeds.write(tmp_path / "other", [speeds.run(0, 20)])
    with pytest.raises(fenderline.CampaignError, match="damaged"):
        speeds.write(tmp_path / "damaged", [speeds.run(0, 60)[:-1]])
    with pytest.raises(fenderline.CampaignError, match="chunk"):
        campaign.run(speeds, tmp_path / "none", chunk=0)
    with pytest.raises(TypeError, match="executor"):
        campaign.run(speeds, tmp_path / "none", executor=3)
    (tmp_path / "bad.toml").write_text(SPEED.replace("lognormal", "lognormall"))
    with pytest.raises(fenderline.ScenarioError) as caught:
        campaign.load(tmp_path / "bad.toml")
    assert caught.value.line == 6


def test_a_worker_with_another_file_is_refused(speeds: campaign.Campaign, tmp_path: Path) -> None:
    part = (str(speeds.path), speeds.fingerprint, 0, 2)
    (tmp_path / "speeds.toml").write_text(SPEED.replace("7.1", "7.2"))
    with pytest.raises(fenderline.CampaignError, match="differs"):
        campaign.make_part(part)


def test_a_pickle_reads_the_file_again(speeds: campaign.Campaign) -> None:
    other = pickle.loads(pickle.dumps(speeds))
    assert other.fingerprint == speeds.fingerprint and other.draw(3) == speeds.draw(3)


def rare(p: float) -> float:
    """The reaction that is exceeded with a probability, in closed form."""
    statistics = pytest.importorskip("scipy.stats")
    return float(KN_PER_CMPS * np.exp(MEAN - DEVIATION * statistics.norm.ppf(p)))


def test_importance_sampling_finds_a_probability_of_1e_5(speeds: campaign.Campaign) -> None:
    """A density around the threshold in standard normal space. 1000 runs: plain Monte Carlo needs 10^7 for 10 %."""
    statistics = pytest.importorskip("scipy.stats")
    threshold = rare(1e-5)
    centre = float(statistics.norm.isf(1e-5))
    scores = np.random.default_rng(1).normal(centre, 1.0, 1000)
    reactions = campaign.evaluate(speeds, statistics.norm.cdf(scores)[:, None], ["reaction"])[:, 0]
    weights = np.exp(0.5 * centre**2 - centre * scores) * (reactions > threshold)
    estimate, error = weights.mean(), weights.std(ddof=1) / np.sqrt(weights.size)
    assert error < 0.1 * estimate
    assert abs(estimate - 1e-5) < 3.0 * error


def test_sobol_indices_of_a_product_of_powers(tmp_path: Path) -> None:
    """ln R = ln v + ln k / 2 + ln m / 2 would be additive; R itself is a product of lognormal powers: the first-order index of
    factor i is (exp(s_i^2) - 1)/(exp(S^2) - 1), with s_i the deviation of its logarithm and S^2 their sum."""
    salib = pytest.importorskip("SALib.sample.sobol")
    analysis = pytest.importorskip("SALib.analyze.sobol")
    (tmp_path / "barge.toml").write_text(BARGE)
    (tmp_path / "two.toml").write_text(
        SPEED.replace('mean = "7.1 cm/s"\nstandard_deviation = "4.47 cm/s"', 'log_mean = 2.1\nlog_standard_deviation = 0.2\nunit = "cm/s"')
        + '[variable.mass]\nkey = "body.barge.mass"\ndistribution = "lognormal"\nlog_mean = 6.9\nlog_standard_deviation = 0.3\nunit = "t"\n'
    )
    two = campaign.load(tmp_path / "two.toml")
    problem = campaign.salib_problem(two)
    sample = salib.sample(problem, 256, calc_second_order=False, seed=1)
    reactions = campaign.evaluate(two, sample, ["reaction"])[:, 0]
    indices = analysis.analyze(problem, reactions, calc_second_order=False, seed=1)
    squares = np.array([0.2**2, 0.15**2])
    wanted = np.expm1(squares) / np.expm1(squares.sum())
    assert np.all(np.abs(indices["S1"] - wanted) < 3.0 * indices["S1_conf"] + 0.01)
