"""The Gymnasium environment."""

import fenderline.docking as docking
import gymnasium
import numpy as np
import pytest
from fenderline.docking import DockingEnv, DockingVectorEnv
from gymnasium.utils.env_checker import check_env


def test_check_env_passes() -> None:
    pytest.importorskip("matplotlib", reason="Matplotlib is not installed").use("Agg")
    for render_mode in (None, *DockingEnv.metadata["render_modes"]):
        env = gymnasium.make(docking.ENV_ID, render_mode=render_mode)
        check_env(env.unwrapped)
        env.close()


def test_the_picture_shows_the_ship() -> None:
    pytest.importorskip("matplotlib", reason="Matplotlib is not installed")
    env = DockingEnv(render_mode="rgb_array")
    env.reset(seed=1)
    image = env.render()
    assert (image.shape, image.dtype) == ((320, 640, 3), np.uint8)
    red = (image == (0xB5, 0x45, 0x2C)).all(axis=2)
    # 130 by 20 m at 4/3 pixels per metre.
    assert 2000 < red.sum() < 5000
    for _ in range(60):
        env.step(np.array([0, 0.5, 0, 0], dtype=np.float32))
    later = (env.render() == (0xB5, 0x45, 0x2C)).all(axis=2)
    # Ahead of her is to the right.
    assert np.flatnonzero(later.any(axis=0)).max() > np.flatnonzero(red.any(axis=0)).max() + 50
    env.close()
    vector = DockingVectorEnv(2, render_mode="rgb_array")
    vector.reset(seed=1)
    first, second = vector.render() or ()
    assert (first == image).all()
    assert (first != second).any()
    vector.close()
    with pytest.raises(ValueError, match="render_mode is 'ansi', but must be None or one of"):
        DockingEnv(render_mode="ansi")


def test_the_master_berths() -> None:
    vector = DockingVectorEnv(20)
    seen, _ = vector.reset(seed=500)
    ended: dict[int, str] = {}
    while len(ended) < 20:
        seen, _, terminated, truncated, info = vector.step(docking.master(seen))
        for ship in np.flatnonzero(terminated | truncated).tolist():
            ended.setdefault(ship, str(info["final_info"]["ended"][ship]))
    assert list(ended.values()).count("alongside") >= 19


def test_observations_are_quantities_over_their_scales() -> None:
    env = DockingEnv()
    seen, _ = env.reset(seed=4)
    si = docking.physical(seen)
    north, east, heading, *_ = env._berth.fleet.states[0, 0]
    assert si[0] == pytest.approx(-north, rel=1e-6)
    assert si[2] == pytest.approx(heading, rel=1e-6)
    assert 25.0 < si[1] < -east
    assert seen[14:].tolist() == [1.0, 1.0, pytest.approx(np.clip(heading / 0.05, -1, 1))]


def test_the_seed_determines_the_episode() -> None:
    def play(seed: int) -> list[float]:
        env = DockingEnv()
        seen, _ = env.reset(seed=seed)
        env.action_space.seed(seed)
        values = [float(x) for x in seen]
        for _ in range(50):
            seen, reward, *_ = env.step(env.action_space.sample())
            values += [float(x) for x in seen] + [reward]
        return values

    assert play(3) == play(3)
    assert play(3) != play(4)


def test_a_vectorised_environment_equals_single_ones() -> None:
    vector = DockingVectorEnv(4, threads=2)
    singles = [DockingEnv() for _ in range(4)]
    seen, _ = vector.reset(seed=10)
    for index, single in enumerate(singles):
        assert (single.reset(seed=10 + index)[0] == seen[index]).all()
    vector.action_space.seed(0)
    resets = 0
    for _ in range(1000):
        actions = vector.action_space.sample()
        seen, rewards, terminated, truncated, info = vector.step(actions)
        for index, single in enumerate(singles):
            own, reward, ended, late, own_info = single.step(actions[index])
            assert (reward, ended, late) == (rewards[index], terminated[index], truncated[index])
            if ended or late:
                resets += 1
                assert (info["final_obs"][index] == own).all()
                assert info["final_info"]["ended"][index] == own_info.get("ended", "")
                own, _ = single.reset()
            assert (own == seen[index]).all()
    assert resets > 0


def test_observations_stay_within_their_space() -> None:
    vector = DockingVectorEnv(16)
    vector.reset(seed=5)
    vector.action_space.seed(5)
    for _ in range(500):
        seen, rewards, *_ = vector.step(vector.action_space.sample())
        assert vector.observation_space.contains(seen)
        assert np.isfinite(rewards).all()


def test_make_vec_makes_the_vectorised_environment() -> None:
    vector = gymnasium.make_vec(docking.ENV_ID, num_envs=3)
    assert isinstance(vector.unwrapped, DockingVectorEnv)
    vector.close()


def place(env: DockingEnv, **keys: object) -> None:
    """Places the ship, in still air and water."""
    env.reset(seed=0)
    env._berth.fleet.reset([0], [keys])
    env._berth._far[:] = env._berth._distance()


def test_lying_alongside_at_rest_ends_the_episode_well() -> None:
    env = DockingEnv()
    place(
        env,
        **{"body.ship.position": [0.0, -11.75], "body.ship.velocity": {"surge": 0.0}},
    )
    _, reward, terminated, _, info = env.step(np.zeros(4, dtype=np.float32))
    assert (terminated, info["ended"]) == (True, "alongside")
    assert reward > 90


def test_a_hard_landing_ends_the_episode_badly() -> None:
    env = DockingEnv()
    place(
        env,
        **{
            "body.ship.position": [0.0, -13.0],
            "body.ship.velocity": {"surge": 0.0, "sway": 0.6},
        },
    )
    for _ in range(20):
        _, reward, terminated, _, info = env.step(np.zeros(4, dtype=np.float32))
        if terminated:
            break
    assert info["ended"] == "overloaded"
    assert reward < -90


def test_a_non_finite_action_is_refused() -> None:
    env = DockingEnv()
    env.reset(seed=0)
    with pytest.raises(ValueError, match="not a finite number"):
        env.step(np.full(4, np.nan, dtype=np.float32))
