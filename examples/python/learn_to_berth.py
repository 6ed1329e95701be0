"""A policy that berths, learnt with Stable-Baselines3: a recipe.

    pip install stable-baselines3 matplotlib
    python examples/python/learn_to_berth.py --out out/learner              # the whole recipe
    python examples/python/learn_to_berth.py --out out/learner --small      # a minute of it, to see that it runs
    python examples/python/learn_to_berth.py --out out/learner --from-nothing   # without a teacher, to compare
    python examples/python/learn_to_berth.py --test out/learner/policy.zip      # a saved policy by 100 other starts

1. **Cloning.** The policy is fitted to the actions of `fenderline.docking.master`, first in the states that the master
   meets, then in those that the policy itself meets (DAgger, Ross et al. 2011): a clone that only knows the master's own
   states does not know the way back. The critic is fitted to the returns of the same episodes.
2. **Practice.** PPO goes on from there, by the reward of the environment.
3. **Test.** 100 starts with seeds that were in no training; the policy's mean action, without noise. The policy that does best is
   tested once more by 100 others, which had no part in choosing it.

`curve.csv` has the share of tests berthed, their mean return and length, over steps and processor time; `policy.zip` is the policy
that did best. `cargo xtask book` draws the curves that are kept in `examples/python/learning`.
"""

from __future__ import annotations

import argparse
import csv
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import fenderline.docking as docking
import numpy as np
import numpy.typing as npt
import torch
from stable_baselines3 import PPO
from stable_baselines3.common.vec_env import VecEnv

#: Seeds of tests begin here; training draws its own from 0 on. The policy that did best in the first is tested by the others.
TEST_SEED, OTHER_SEED = 1_000_000, 2_000_000
#: Rewards are up to 100: a critic learns numbers near 1 faster.
REWARD_SCALE = 0.05
GAMMA = 0.997

Array = npt.NDArray[Any]


class Ships(VecEnv):
    """`fenderline.docking.DockingVectorEnv` as Stable-Baselines3 takes it: all ships advance in one call, ten times faster
    than `make_vec_env`, which steps them one after the other."""

    def __init__(self, ships: int, threads: int = 1) -> None:
        self.ships = docking.DockingVectorEnv(ships, threads=threads)
        self.render_mode = None
        super().__init__(
            ships, self.ships.single_observation_space, self.ships.single_action_space
        )
        self._actions: Array = np.zeros((ships, 4), dtype=np.float32)

    def reset(self) -> Array:
        seeds = [seed for seed in self._seeds if seed is not None]
        seen, _ = self.ships.reset(seed=seeds if len(seeds) == self.num_envs else None)
        self._reset_seeds()
        return seen

    def step_async(self, actions: Array) -> None:
        self._actions = actions

    def step_wait(self) -> tuple[Array, Array, Array, list[dict[str, Any]]]:
        seen, rewards, terminated, truncated, info = self.ships.step(self._actions)
        infos: list[dict[str, Any]] = [{} for _ in range(self.num_envs)]
        for ship in np.flatnonzero(terminated | truncated):
            infos[ship] = {
                "terminal_observation": info["final_obs"][ship],
                "TimeLimit.truncated": bool(truncated[ship]),
                "ended": str(info["final_info"]["ended"][ship]) or "out of time",
            }
        return seen, rewards * REWARD_SCALE, terminated | truncated, infos

    def close(self) -> None:
        self.ships.close()

    def env_is_wrapped(self, wrapper_class: Any, indices: Any = None) -> list[bool]:
        return [False] * self.num_envs

    def get_attr(self, attr_name: str, indices: Any = None) -> list[Any]:
        return [getattr(self, attr_name)] * self.num_envs

    def set_attr(self, attr_name: str, value: Any, indices: Any = None) -> None:
        raise NotImplementedError("the ships have no attributes of their own")

    def env_method(self, method_name: str, *args: Any, indices: Any = None, **kwargs: Any) -> list[Any]:
        raise NotImplementedError("the ships have no methods of their own")


def test(model: PPO, count: int, seed: int = TEST_SEED) -> tuple[dict[str, int], float, float]:
    """How episodes of unseen starts end, their mean return and their mean length in seconds."""
    ships = docking.DockingVectorEnv(count)
    seen, _ = ships.reset(seed=seed)
    ended: dict[int, str] = {}
    returns, seconds = np.zeros(count), np.zeros(count)
    while len(ended) < count:
        going = np.array([ship not in ended for ship in range(count)])
        actions, _ = model.predict(seen, deterministic=True)
        seen, rewards, terminated, truncated, info = ships.step(actions)
        returns += np.where(going, rewards, 0.0)
        seconds += going
        for ship in np.flatnonzero((terminated | truncated) & going).tolist():
            ended[ship] = str(info["final_info"]["ended"][ship]) or "out of time"
    kinds = list(ended.values())
    counts = {kind: kinds.count(kind) for kind in sorted(set(kinds))}
    return counts, float(returns.mean()), float(seconds.mean())


def clone(model: PPO, rounds: int, ships: int, steps: int, epochs: int, seed: int) -> int:
    """Fits the policy to the master, in the states that both meet; returns the number of steps."""
    env = Ships(ships)
    env.seed(seed)
    random = np.random.default_rng(seed)
    policy = model.policy
    adam = torch.optim.Adam(policy.parameters(), lr=1e-3)
    all_seen: list[Array] = []
    all_wanted: list[Array] = []
    all_returns: list[Array] = []
    for number in range(rounds):
        seen = env.reset()
        # The share of ships that the policy steers itself.
        by_policy = random.random(ships) < (0.0 if number == 0 else 0.8)
        rows, wanted, rewards, ends = [], [], [], []
        for _ in range(steps):
            rows.append(seen)
            teacher = docking.master(seen)
            wanted.append(teacher)
            mine, _ = model.predict(seen, deterministic=True)
            noise = random.normal(0.0, 0.2, teacher.shape) * (random.random((ships, 1)) < 0.5)
            actions = np.where(by_policy[:, None], mine, teacher) + noise
            seen, reward, done, _ = env.step(np.clip(actions, -1.0, 1.0).astype(np.float32))
            rewards.append(reward)
            ends.append(done)
        # Returns from the end backwards; what comes after the last step is what the critic expects.
        with torch.no_grad():
            after = policy.predict_values(torch.as_tensor(seen)).numpy()[:, 0]
        after = after if number > 0 else np.zeros(ships)
        returns = np.empty((steps, ships))
        for step in reversed(range(steps)):
            after = rewards[step] + GAMMA * np.where(ends[step], 0.0, after)
            returns[step] = after
        all_seen.append(np.concatenate(rows))
        all_wanted.append(np.concatenate(wanted))
        all_returns.append(returns.ravel())
        x = torch.as_tensor(np.concatenate(all_seen))
        y = torch.as_tensor(np.concatenate(all_wanted))
        z = torch.as_tensor(np.concatenate(all_returns), dtype=torch.float32)
        batches = max(1, epochs * len(all_seen[0]) // 2048)
        for batch in range(batches):
            for group in adam.param_groups:
                group["lr"] = 1e-3 * (1.0 - 0.9 * batch / batches)
            which = torch.randint(len(x), (2048,))
            mean = policy.get_distribution(x[which]).distribution.mean
            value = policy.predict_values(x[which])[:, 0]
            miss = ((mean - y[which]) ** 2).mean()
            loss = miss + 0.02 * ((value - z[which]) ** 2).mean()
            adam.zero_grad()
            loss.backward()
            adam.step()
        print(f"cloning, round {number + 1}: mean square miss {float(miss.detach()):.4f}", flush=True)
    return rounds * ships * steps


def learn(out: Path, *, small: bool, from_nothing: bool, minutes: float, seed: int) -> float:
    """Runs the recipe; returns the share of tests that the best policy berths."""
    out.mkdir(parents=True, exist_ok=True)
    torch.manual_seed(seed)
    ships, tests = (32, 20) if small else (64, 100)
    env = Ships(ships)
    env.seed(seed + 10_000)
    model = PPO(
        "MlpPolicy",
        env,
        learning_rate=3e-4 if from_nothing else 1e-4,
        n_steps=256,
        batch_size=2048,
        n_epochs=5,
        gamma=GAMMA,
        gae_lambda=0.95,
        clip_range=0.15,
        target_kl=0.03,
        ent_coef=0.0,
        policy_kwargs={
            "net_arch": {"pi": [128, 128], "vf": [128, 128]},
            "log_std_init": -1.0 if from_nothing else -2.0,
        },
        seed=seed,
        device="cpu",
    )
    began, taken, best = time.process_time(), 0, (-1.0, 0.0)
    with (out / "curve.csv").open("w", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(["phase", "steps", "processor_s", "berthed", "mean_return", "mean_s", "endings"])

        def report(phase: str) -> None:
            nonlocal best
            endings, mean_return, mean_s = test(model, tests)
            berthed = endings.get("alongside", 0) / tests
            spent_s = time.process_time() - began
            words = " ".join(f"{kind}:{number}" for kind, number in endings.items())
            means = [round(mean_return, 2), round(mean_s, 1)]
            rows.writerow([phase, taken, round(spent_s, 1), berthed, *means, words])
            file.flush()
            print(
                f"{phase}: {taken} steps, {spent_s:.0f} s of processor time; {berthed:.0%} berthed, "
                f"mean return {mean_return:.1f}, {mean_s:.0f} s; {words}",
                flush=True,
            )
            if (berthed, mean_return) > best:
                best = (berthed, mean_return)
                model.save(out / "policy.zip")

        report("start")
        if not from_nothing:
            rounds, steps, epochs = (3, 400, 25) if small else (8, 450, 12)
            taken += clone(model, rounds, ships, steps, epochs, seed)
            report("cloned")
        steps_of_practice = 256 * ships if small else 250_000
        while True:
            model.learn(steps_of_practice, reset_num_timesteps=False)
            taken += steps_of_practice
            report("practised")
            if small or time.process_time() - began > 60.0 * minutes:
                break
    return final(out / "policy.zip", tests)


def final(policy: Path, count: int) -> float:
    """Tests a saved policy by starts that neither trained nor chose it; returns the share that it berths."""
    endings, mean_return, mean_s = test(PPO.load(policy, device="cpu"), count, OTHER_SEED)
    words = ", ".join(f"{number} {kind.replace('_', ' ')}" for kind, number in endings.items())
    print(f"{policy.name}, {count} other starts: {words}; mean return {mean_return:.1f}, {mean_s:.0f} s")
    return endings.get("alongside", 0) / count


def main(arguments: Sequence[str] | None = None) -> float:
    """Reads the command line and learns."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--out", type=Path, default=Path("out/learner"))
    parser.add_argument("--small", action="store_true", help="a minute of the recipe")
    parser.add_argument("--from-nothing", action="store_true", help="PPO alone, without a teacher")
    parser.add_argument("--minutes", type=float, default=10.0, help="processor time, of one core")
    parser.add_argument("--test", type=Path, metavar="POLICY", help="only test a saved policy")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--threads", type=int, default=1, help="threads of the learner")
    given = parser.parse_args(arguments)
    torch.set_num_threads(given.threads)
    if given.test is not None:
        return final(given.test, 100)
    best = learn(
        given.out,
        small=given.small,
        from_nothing=given.from_nothing,
        minutes=given.minutes,
        seed=given.seed,
    )
    print(f"the best policy berths {best:.0%} of unseen starts")
    return best


if __name__ == "__main__":
    main()
