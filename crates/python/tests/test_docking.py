"""The Gymnasium environment."""

import fenderline.docking as docking
import gymnasium
import numpy as np
import pytest
from fenderline.docking import DockingEnv, DockingVectorEnv
from gymnasium.utils.env_checker import check_env


def test_check_env_passes() -> None:
    env = gymnasium.make(docking.ENV_ID)
    check_env(env.unwrapped, skip_render_check=True)


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
