"""Learners: Stable-Baselines3's and PettingZoo's own checks, and the recipe in a small form."""

import csv
import importlib.util
from pathlib import Path
from types import ModuleType

import fenderline.docking as docking
import numpy as np
import pytest

HEAVY = "is not installed (with PyTorch 5 GB): python3 crates/python/test.py --heavy"


def recipe(root: Path) -> ModuleType:
    path = root / "examples" / "python" / "learn_to_berth.py"
    spec = importlib.util.spec_from_file_location("learn_to_berth", path)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_pettingzoo_accepts_the_two_tugs() -> None:
    pytest.importorskip("pettingzoo", reason="PettingZoo is not installed")
    from fenderline import tugs
    from pettingzoo.test import parallel_api_test, parallel_seed_test

    parallel_api_test(tugs.parallel_env(), num_cycles=300)
    parallel_seed_test(tugs.parallel_env, num_cycles=50)


def test_two_tugs_by_hand_lay_her_alongside() -> None:
    pytest.importorskip("pettingzoo", reason="PettingZoo is not installed")
    from fenderline import tugs

    env = tugs.parallel_env()
    ended = []
    for seed in range(20):
        observations, infos = env.reset(seed=seed)
        while env.agents:
            actions = {agent: tugs.master(seen) for agent, seen in observations.items()}
            observations, rewards, _, _, infos = env.step(actions)
            assert rewards.keys() == {"forward", "aft"}
        ended.append(infos["aft"].get("ended", "out of time"))
    assert ended.count("alongside") >= 18, ended


def test_a_tug_that_does_nothing_does_not_berth_her() -> None:
    pytest.importorskip("pettingzoo", reason="PettingZoo is not installed")
    from fenderline import tugs

    env = tugs.parallel_env()
    env.reset(seed=1)
    full = {"forward": np.ones(1, dtype=np.float32), "aft": np.zeros(1, dtype=np.float32)}
    while env.agents:
        *_, infos = env.step(full)
    assert infos["forward"].get("ended") != "alongside"
    env.reset(seed=1)
    with pytest.raises(ValueError, match="not a finite number"):
        env.step({"forward": np.full(1, np.nan, dtype=np.float32), "aft": full["aft"]})


@pytest.mark.filterwarnings("ignore")
def test_stable_baselines_makes_its_environments() -> None:
    pytest.importorskip("stable_baselines3", reason=f"Stable-Baselines3 {HEAVY}")
    from stable_baselines3 import PPO
    from stable_baselines3.common.env_checker import check_env
    from stable_baselines3.common.env_util import make_vec_env

    check_env(docking.DockingEnv())
    env = make_vec_env(docking.ENV_ID, n_envs=2, seed=1)
    PPO("MlpPolicy", env, n_steps=64, batch_size=64, device="cpu").learn(128)
    image = env.render()
    assert image is not None and image.ndim == 3
    env.close()


@pytest.mark.filterwarnings("ignore")
def test_the_recipe_in_small(root: Path, tmp_path: Path) -> None:
    pytest.importorskip("stable_baselines3", reason=f"Stable-Baselines3 {HEAVY}")
    best = recipe(root).main(["--small", "--out", str(tmp_path)])
    with (tmp_path / "curve.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["phase"] for row in rows] == ["start", "cloned", "practised"]
    assert (tmp_path / "policy.zip").is_file()
    # Half a minute of cloning berths most of the starts; nothing learnt berths none.
    assert float(rows[0]["berthed"]) < 0.2
    assert best >= 0.5
