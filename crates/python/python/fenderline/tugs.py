"""Bringing a ship alongside by two tugs: a PettingZoo environment (``pip install pettingzoo``).

The coaster of :mod:`fenderline.docking` lies stopped 15 to 30 m off her berth, her engine and thrusters out of use. Two tugs
are made fast on her port side, ``forward`` and ``aft``; each is an agent. Together they are to lay her alongside, parallel
and without overloading a fender, in a wind that blows on or off the quay. One step is one second.

>>> from fenderline import tugs
>>> env = tugs.parallel_env()
>>> observations, infos = env.reset(seed=1)
>>> while env.agents:
...     actions = {agent: tugs.master(seen) for agent, seen in observations.items()}
...     observations, rewards, terminated, truncated, infos = env.step(actions)
>>> infos["forward"]["ended"]
'alongside'

**Action** of each agent, one number from −1 to 1: the force over 200 kN; positive pushes her towards the quay, negative
pulls her off it.

**Observation** of each agent, 20 numbers: the 17 of :mod:`fenderline.docking` (the ship's own orders are 0), then 1 for the
forward and −1 for the aft tug, the own last action, and the other tug's.

**Reward**, **termination** and **truncation** are those of :mod:`fenderline.docking`, the same for both agents: half of the
ship's each, and their own actions count. She may be 10 m along the quay from her berth: the tugs act square to her.
"""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np
import numpy.typing as npt
from gymnasium.utils import seeding
from pettingzoo import ParallelEnv

from fenderline._native import Scenario
from fenderline._picture import RENDER_MODES, Picture, known_render_mode
from fenderline._runs import example
from fenderline.docking import _HIGH, _LOW, FACES_EAST_M, LEVERS, _Berth, physical

__all__ = ["TugsEnv", "master", "parallel_env"]

AGENTS = ["forward", "aft"]
#: Where the tugs push, forward of midship; the force of an action of 1.
PUSH_AT_M = {"forward": 45.0, "aft": -45.0}
FULL_N = 200e3

Seen = npt.NDArray[np.float32]


def _scenario() -> Scenario:
    tugs = {
        name: {"vessel": "ship", "bollard_pull": "30 tf", "push_at": [along, -10.0]}
        for name, along in PUSH_AT_M.items()
    }
    return example("docking").with_set({"tug": tugs})


def _draw(random: np.random.Generator) -> npt.NDArray[np.float64]:
    """Start and wind of an episode, as in :mod:`fenderline.docking`."""
    off = random.uniform(15.0, 30.0)
    # On or off the quay, within 15 degrees.
    wind_from = random.choice([0.5, 1.5]) * np.pi + random.uniform(-0.26, 0.26)
    along, heading = random.uniform(-2.0, 2.0), random.uniform(-0.05, 0.05)
    wind = random.uniform(0.0, 8.0)
    return np.array([along, FACES_EAST_M - 10.0 - off, heading, 0.0, 0.0, wind, wind_from, 0.0, 0.0])


def master(observation: npt.NDArray[Any]) -> Seen:
    """The action of a hand-written policy for one tug: it brings its end of the ship in, slower the nearer."""
    seen = physical(observation)
    end_m = 45.0 * float(observation[17])
    off = seen[1] - end_m * seen[2]
    towards = seen[4] + end_m * seen[5]
    wanted = np.clip(0.02 * off + 0.02, 0.03, 0.2)
    # Half of the wind's force on her side.
    wind = 0.5 * 1.225 * 0.9 * 1300.0 * seen[11] * abs(seen[11]) / (2.0 * FULL_N)
    order = 8.0 * (wanted - towards) - wind
    clipped: Seen = np.clip(np.array([order]), -1.0, 1.0).astype(np.float32)
    return clipped


class TugsEnv(ParallelEnv[str, Seen, Seen]):
    """Two tugs and a ship; see :mod:`fenderline.tugs`."""

    metadata: dict[str, Any] = {
        "name": "fenderline/Tugs-v0",
        "render_modes": RENDER_MODES,
        "render_fps": 10,
        "is_parallelizable": True,
    }

    def __init__(self, render_mode: str | None = None) -> None:
        self.render_mode = known_render_mode(render_mode)
        self.possible_agents = list(AGENTS)
        self.agents: list[str] = []
        levers = LEVERS + [(f"tug.{name}.force_n", FULL_N) for name in AGENTS]
        self._berth = _Berth(1, 1, _scenario(), _draw, levers, berthed_within_m=10.0)
        self._shared = np.zeros(len(_LOW), dtype=np.float32)
        self._orders = np.zeros(2)
        self._random = seeding.np_random()[0]
        self._picture: Picture | None = None
        low = np.concatenate([_LOW, -np.ones(3)]).astype(np.float32)
        high = np.concatenate([_HIGH, np.ones(3)]).astype(np.float32)
        self._seen = {name: gymnasium.spaces.Box(low, high) for name in AGENTS}
        self._acted = {name: gymnasium.spaces.Box(-1.0, 1.0, (1,)) for name in AGENTS}

    def observation_space(self, agent: str) -> gymnasium.spaces.Box:
        """The space of an agent's observations."""
        return self._seen[agent]

    def action_space(self, agent: str) -> gymnasium.spaces.Box:
        """The space of an agent's actions."""
        return self._acted[agent]

    def reset(
        self, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[dict[str, Seen], dict[str, dict[str, Any]]]:
        """Starts an episode, drawn from ``seed``, or from the random state that the last one left."""
        if seed is not None:
            self._random = seeding.np_random(seed)[0]
        self.agents = list(AGENTS)
        self._orders[:] = 0.0
        self._shared = self._berth.begin([0], [self._random])[0]
        self._show_in_window()
        return self._observe(), {name: {} for name in self.agents}

    def step(
        self, actions: dict[str, Seen]
    ) -> tuple[
        dict[str, Seen],
        dict[str, float],
        dict[str, bool],
        dict[str, bool],
        dict[str, dict[str, Any]],
    ]:
        """One second; ``infos[agent]["ended"]`` says how an episode ended."""
        orders = np.array([float(np.asarray(actions[name]).reshape(1)[0]) for name in AGENTS])
        if not np.isfinite(orders).all():
            raise ValueError("an action is not a finite number")
        self._orders = np.clip(orders, -1.0, 1.0)
        action = np.concatenate([np.zeros(len(LEVERS)), self._orders])
        seen_of_all, rewards, ended, truncated = self._berth.step(action[None])
        self._shared = seen_of_all[0]
        is_over, is_late = bool(ended[0]), bool(truncated[0])
        own = 0.5 * float(rewards[0]) - 0.01 * self._orders**2
        word = str(self._berth.words(ended)[0])
        infos: dict[str, dict[str, Any]] = {
            name: {"ended": word} if is_over else {} for name in self.agents
        }
        given = {name: float(own[AGENTS.index(name)]) for name in self.agents}
        over = dict.fromkeys(self.agents, is_over)
        late = dict.fromkeys(self.agents, is_late)
        seen = self._observe()
        self._show_in_window()
        if is_over or is_late:
            self.agents = []
        return seen, given, over, late, infos

    def state(self) -> npt.NDArray[np.float32]:
        """The ship's observation and both orders, for learners with a central critic."""
        values = [self._shared, self._orders.astype(np.float32)]
        joined: npt.NDArray[np.float32] = np.concatenate(values)
        return joined

    def render(self) -> Any:
        """The plan as an array (height, width, 3) of bytes, with ``render_mode="rgb_array"``."""
        return self._picture_now().image() if self.render_mode == "rgb_array" else None

    def close(self) -> None:
        """Closes the window."""
        if self._picture is not None:
            self._picture.close()
            self._picture = None

    def _observe(self) -> dict[str, Seen]:
        seen = {}
        for index, name in enumerate(AGENTS):
            own = [1.0 if name == "forward" else -1.0, self._orders[index], self._orders[1 - index]]
            seen[name] = np.concatenate([self._shared, np.array(own, dtype=np.float32)])
        return {name: seen[name] for name in self.agents}

    def _picture_now(self) -> Picture:
        if self._picture is None:
            self._picture = Picture(window=self.render_mode == "human")
        plan = self._berth.plan(0)
        forces = zip(PUSH_AT_M.values(), self._orders.tolist(), strict=True)
        plan.tugs = list(forces)
        self._picture.draw([plan])
        return self._picture

    def _show_in_window(self) -> None:
        if self.render_mode == "human":
            self._picture_now()


def parallel_env(render_mode: str | None = None) -> TugsEnv:
    """The environment, by PettingZoo's parallel interface; ``pettingzoo.utils.parallel_to_aec`` makes the other one."""
    return TugsEnv(render_mode)
