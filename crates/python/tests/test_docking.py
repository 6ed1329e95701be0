"""The Gymnasium environment."""

import fenderline
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
    north, east, heading, *_ = env._berth.native.states[0]
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


class Formula:
    """Observation, reward and end of an episode by the formulas of the module's documentation, in NumPy."""

    side_m = np.array([(68, 0), (58, 6), (40, 10), (-60, 10), (-68, 8)], dtype=np.float64)

    def __init__(self, start: np.ndarray, state: np.ndarray) -> None:
        north, east = -np.cos(start[6]), -np.sin(start[6])
        along = start[7] if start[8] == 0.0 else -start[7]
        self.weather = np.array([start[5] * north, start[5] * east, along])
        self.far, self.share = self.lie(state)[2], 0.0

    def lie(self, state: np.ndarray) -> tuple[float, float, float]:
        sine, cosine = np.sin(state[2]), np.cos(state[2])
        off = -1.8 - state[1] - (sine * self.side_m[:, 0] + cosine * self.side_m[:, 1]).max()
        heading = np.remainder(state[2] + np.pi, 2.0 * np.pi) - np.pi
        far = np.sqrt(state[0] ** 2 + max(off, 0.0) ** 2 + (65.0 * heading) ** 2)
        return float(off), float(heading), float(far)

    def step(
        self, action: np.ndarray, state: np.ndarray, share: float, failed: bool
    ) -> tuple[np.ndarray, float, str]:
        off, heading, far = self.lie(state)
        orders = np.clip(action.astype(np.float64), -1.0, 1.0)
        reward = 0.1 * (self.far - far) - 0.01 - 0.01 * (orders**2).mean()
        reward -= 50.0 * max(share - self.share, 0.0)
        self.far, self.share = far, share
        ended = ""
        at_rest = np.hypot(state[3], state[4]) < 0.05 and abs(state[5]) < 5e-4
        if abs(state[0]) < 4.0 and off < 0.2 and abs(state[2]) < np.deg2rad(1.0) and at_rest:
            ended = "alongside"
        if share > 1.0 or failed:
            ended = "overloaded"
        if off < -1.6:
            ended = "over_quay_line"
        if abs(state[0]) > 400.0 or off > 200.0:
            ended = "left_basin"
        reward += {"": 0.0, "alongside": 100.0}.get(ended, -100.0)
        own = [-state[0], off, heading, *state[3:6], *orders, *self.weather, share]
        seen = np.array([*own, *own[:3]]) / docking.SCALES
        return np.clip(seen, docking._LOW, docking._HIGH), reward, ended


def test_observations_rewards_and_ends_are_those_of_the_formulas() -> None:
    """Beside a fleet of the same simulations, with random actions and with the master's.

    An observation is one rounding to 32 bits of a number whose sine and cosine may differ in the last of 53 bits; a reward is a
    difference of distances of up to 400 m.
    """
    count = 12
    starts = [docking._draw(np.random.default_rng(seed)) for seed in range(count)]
    # Some that end soon: at rest alongside, a hard landing, towards the quay beside the fenders, out of the basin.
    starts[0][:9] = [0.0, -11.75, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    starts[1][:9] = [0.0, -13.0, 0.0, 0.0, 0.6, 0.0, 0.0, 0.0, 0.0]
    starts[2][:9] = [-180.0, -75.0, 1.2, 1.5, 0.0, 3.0, 1.0, 0.2, np.pi]
    starts[3][:9] = [-380.0, -60.0, 3.1, 1.5, 0.0, 3.0, 4.0, 0.3, 0.0]
    variants = [
        {
            "body.ship.position": start[:2].tolist(),
            "body.ship.heading": float(start[2]),
            "body.ship.velocity": {"surge": float(start[3]), "sway": float(start[4])},
            "environment.wind": {"speed": float(start[5]), "from": float(start[6])},
            "environment.current": {"speed": float(start[7]), "towards": float(start[8])},
        }
        for start in starts
    ]
    fleet = fenderline.Fleet(fenderline.example("docking"), variants)
    names = [name for name, _ in docking.LEVERS]
    columns = [fleet.control_names.index(name) for name in names]
    berth = docking._Berth(count, 2)
    seen = berth.native.begin(range(count), np.stack(starts))
    formulas = [Formula(start, fleet.states[i, 0]) for i, start in enumerate(starts)]
    random = np.random.default_rng(0)
    found = set()
    for _ in range(400):
        actions = random.uniform(-1.2, 1.2, (count, 4))
        actions[count // 2 :] = docking.master(seen)[count // 2 :]
        seen, rewards, ended, _ = berth.step(actions)
        fleet.controls[:, columns] = np.clip(actions, -1.0, 1.0) * [full for _, full in docking.LEVERS]
        fleet.step()
        assert (berth.native.states == fleet.states[:, 0]).all()
        shares = fleet.fender_energy_shares.max(axis=1)
        failed = fleet.fenders_failed.max(axis=1)
        for i, formula in enumerate(formulas):
            state = fleet.states[i, 0]
            own = formula.step(actions[i], state, float(shares[i]), bool(failed[i]))
            np.testing.assert_allclose(seen[i], own[0], rtol=1.2e-7, atol=1e-12)
            assert rewards[i] == pytest.approx(own[1], rel=1e-12, abs=1e-11)
            assert berth.words(ended)[i] == own[2]
            found.add(own[2])
    assert {"", "alongside", "overloaded", "over_quay_line", "left_basin"} <= found


def test_the_starts_of_a_seed_are_as_they_always_were() -> None:
    """One call of the generator for all numbers draws what one call for each drew."""
    for seed in range(20):
        random = np.random.default_rng(seed)
        along, off = random.uniform(-230.0, -130.0), random.uniform(30.0, 60.0)
        heading, surge = random.uniform(-0.15, 0.15), random.uniform(0.8, 1.8)
        wind, wind_from = random.uniform(0.0, 9.0), random.uniform(0.0, 2.0 * np.pi)
        current = random.uniform(-0.4, 0.4)
        towards = 0.0 if current >= 0.0 else np.pi
        east = docking.FACES_EAST_M - 10.0 - off
        start = [along, east, heading, surge, 0.0, wind, wind_from, abs(current), towards]
        assert docking._draw(np.random.default_rng(seed)).tolist() == start


def test_what_a_step_returns_is_not_overwritten_by_the_next() -> None:
    vector = DockingVectorEnv(2)
    seen, _ = vector.reset(seed=1)
    first = seen.copy()
    later, *_ = vector.step(np.zeros((2, 4), dtype=np.float32))
    assert np.array_equal(seen, first)
    assert not np.array_equal(later, first)


def place(env: DockingEnv, east: float, sway: float) -> None:
    """Places the ship abreast of her berth, in still air and water."""
    start = np.zeros((1, 9))
    start[0, 1], start[0, 4] = east, sway
    env._berth.native.begin([0], start)


def test_lying_alongside_at_rest_ends_the_episode_well() -> None:
    env = DockingEnv()
    place(env, east=-11.75, sway=0.0)
    _, reward, terminated, _, info = env.step(np.zeros(4, dtype=np.float32))
    assert (terminated, info["ended"]) == (True, "alongside")
    assert reward > 90


def test_a_hard_landing_ends_the_episode_badly() -> None:
    env = DockingEnv()
    place(env, east=-13.0, sway=0.6)
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
