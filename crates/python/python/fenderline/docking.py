"""Bringing a ship alongside: a Gymnasium environment, single and vectorised.

A coaster of 130 m with propeller, rudder, bow and stern thruster approaches a quay on her starboard side. She is to
come to rest on its four fenders: at her berth, parallel, and without any fender storing more than its rated energy.
Her start, wind and current are drawn from the episode's seed. One step is one second.

Importing this module registers ``fenderline/Docking-v0``:

>>> import fenderline.docking, gymnasium
>>> env = gymnasium.make("fenderline/Docking-v0")
>>> observation, info = env.reset(seed=1)
>>> observation, reward, terminated, truncated, info = env.step(env.action_space.sample())
>>> vectorised = gymnasium.make_vec("fenderline/Docking-v0", num_envs=8)
>>> vectorised.reset(seed=1)[0].shape
(8, 17)

**Action**, four numbers from −1 to 1:

== =================================================================================
0  rudder over its stop of 35°; positive turns to starboard going ahead
1  engine: revolutions over full revolutions, positive ahead
2  bow thruster over full power, positive to starboard (towards the quay)
3  stern thruster, likewise
== =================================================================================

**Observation**, 17 numbers in the quay's axes (along: her heading when berthed), each over its scale, clipped to ±10:

=== ============================================================================ ==========
    quantity                                                                     scale
=== ============================================================================ ==========
0   along: distance still to go to her berth, positive ahead of her              100 m
1   off: least clearance between her hull and the line of the fender faces       50 m
2   heading relative to the quay, positive to starboard                          0.5 rad
3   speed along the quay over ground                                             1 m/s
4   speed towards the quay over ground                                           0.3 m/s
5   rate of turn, positive to starboard                                          0.005 rad/s
6-9 last orders of rudder, engine, bow and stern thruster                        1
10  wind: component along the quay, in the direction in which it blows           10 m/s
11  wind: component towards the quay                                             10 m/s
12  current along the quay                                                       0.5 m/s
13  largest energy that a fender has stored so far over its rated energy         1
14  along again, clipped to ±1: what counts near the berth                       10 m
15  off again, clipped to ±1                                                     5 m
16  heading again, clipped to ±1                                                 0.05 rad
=== ============================================================================ ==========

:data:`SCALES` has the scales, :func:`physical` gives the first 14 numbers in metres, seconds and radians again, and
:func:`master` is a hand-written policy that berths.

**Reward**: 0.1 times the decrease of the distance to the berth in the step (in metres; heading counts with the ship's
half length), less 0.01, less 0.01 times the mean square of the action, less 50 times the increase of the largest share
of a fender's rated energy. **Termination**: +100 when she lies alongside (less than 4 m from her berth, at most 0.2 m
off the faces, within 1° of parallel, slower than 0.05 m/s, turning at less than 0.0005 rad/s); −100 when a fender is
loaded beyond its rating, when her hull reaches the line of the quay beside or beyond the fenders, or when she leaves
the basin. **Truncation** after 900 s.

**Rendering**: ``render_mode="rgb_array"`` gives a plan as an image, ``"human"`` shows it in a window; both need Matplotlib.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, TypeAlias, cast

import gymnasium
import numpy as np
import numpy.typing as npt
from gymnasium.utils import seeding
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

from fenderline._native import Docking, Scenario
from fenderline._picture import RENDER_MODES, Picture, Plan, known_render_mode
from fenderline._runs import example

__all__ = ["ENV_ID", "SCALES", "DockingEnv", "DockingVectorEnv", "master", "physical"]

ENV_ID = "fenderline/Docking-v0"

Floats: TypeAlias = npt.NDArray[np.float64]
Observation: TypeAlias = npt.NDArray[np.float32]
Action: TypeAlias = npt.NDArray[np.float32]

#: The numbers of an action: the controls that they set, and the value of each at 1.
LEVERS = [
    ("ship.rudder_rad", float(np.deg2rad(35.0))),
    ("ship.engine", 1.0),
    ("ship.thruster.bow", 1.0),
    ("ship.thruster.stern", 1.0),
]
#: From the scenario: y of the fenders' faces.
FACES_EAST_M = -1.8

#: Scales of the observation: its numbers are quantities over these.
SCALES = np.array(
    [100, 50, 0.5, 1, 0.3, 0.005, 1, 1, 1, 1, 10, 10, 0.5, 1, 10, 5, 0.05], dtype=np.float64
)
SCALES.flags.writeable = False
_HIGH = np.where(np.arange(len(SCALES)) < 14, 10.0, 1.0).astype(np.float32)
_HIGH[6:10] = 1.0
_LOW = np.where(np.arange(len(SCALES)) == 13, 0.0, -_HIGH).astype(np.float32)


def physical(observation: npt.NDArray[Any]) -> Floats:
    """The first 14 numbers of observations, in metres, seconds and radians.

    >>> import gymnasium
    >>> seen, _ = gymnasium.make(ENV_ID).reset(seed=1)
    >>> float(physical(seen)[0].round())  # metres still to go
    179.0
    """
    values: Floats = np.asarray(observation, dtype=np.float64)[..., :14] * SCALES[:14]
    return values


def master(observation: npt.NDArray[Any]) -> Action:
    """Actions of a hand-written policy that does what a master does: comes up the berth, stops abreast of it, breasts in
    slowly and parallel, and lets the fenders take her. Observations in rows, or a single one.
    """
    seen = physical(observation)
    to_go, off, heading, ahead, towards, turn = np.moveaxis(seen[..., :6], -1, 0)
    wind_along, wind_towards = np.moveaxis(seen[..., 10:12], -1, 0)
    # Come up at no more than 1.2 m/s, and so that 8 mm/s² stop her. Breast in only when she is abreast, slower the
    # nearer.
    stops_from = np.sqrt(2.0 * 0.008 * np.abs(to_go))
    ahead_wanted = np.sign(to_go) * np.minimum(np.minimum(stops_from, 0.04 * np.abs(to_go)), 1.2)
    least_off = np.clip(4.0 * (np.abs(to_go) - 2.5), 0.0, 15.0)
    fastest_in = np.clip(0.02 + 0.02 * off, 0.02, 0.3)
    towards_wanted = np.clip(0.03 * (off - least_off), -0.3, fastest_in)
    towards_wanted = towards_wanted + np.where((least_off == 0.0) & (off < 0.5), 0.02, 0.0)
    # Wind on her side, over the 220 kN of both thrusters; turning by one against the other.
    wind = 0.5 * 1.225 * 0.9 * 1300.0 * wind_towards * np.abs(wind_towards) / 220e3
    breast = 6.0 * (towards_wanted - towards) - wind
    swing = -5.0 * heading - 150.0 * turn
    engine = 4.0 * (ahead_wanted - ahead) - 0.0005 * wind_along * np.abs(wind_along)
    orders = np.stack([np.zeros_like(engine), engine, breast + swing, breast - swing], axis=-1)
    clipped: Action = np.clip(orders, -1.0, 1.0).astype(np.float32)
    return clipped


def _observation_space() -> gymnasium.Space[Observation]:
    return cast("gymnasium.Space[Observation]", gymnasium.spaces.Box(_LOW, _HIGH))


def _action_space() -> gymnasium.Space[Action]:
    return cast("gymnasium.Space[Action]", gymnasium.spaces.Box(-1.0, 1.0, (4,)))


#: Of each start, in the order of :class:`Docking`: least and greatest number.
_STARTS = np.array(
    [
        (-230.0, -130.0),  # position along the quay
        (30.0, 60.0),  # clearance
        (-0.15, 0.15),  # heading
        (0.8, 1.8),  # surge
        (0.0, 9.0),  # wind
        (0.0, 2.0 * np.pi),  # where it comes from
        (-0.4, 0.4),  # current along the quay
    ]
)


def _draw(random: np.random.Generator) -> Floats:
    """Start and weather of an episode: position north and east, heading, velocity ahead and to starboard, speed of the wind and where it
    comes from, speed of the current and where it goes."""
    low, high = _STARTS.T
    along, off, heading, surge, wind, wind_from, current = low + (high - low) * random.random(7)
    east = FACES_EAST_M - 10.0 - off
    towards = 0.0 if current >= 0.0 else np.pi
    start = [along, east, heading, surge, 0.0, wind, wind_from, abs(current), towards]
    return np.array(start)


#: How an episode ended, by the numbers of :class:`Docking`.
_WORDS = np.array(["", "alongside", "overloaded", "over_quay_line", "left_basin"])


class _Berth:
    """Episodes in parallel; shared by all environments. The steps, observations and rewards are those of the native :class:`Docking`.

    ``draw`` gives the start and weather of an episode, ``levers`` are the controls that an action sets, ``berthed_within_m`` is the
    distance along the quay from her berth at which she is still alongside.
    """

    def __init__(
        self,
        count: int,
        threads: int,
        scenario: Scenario | None = None,
        draw: Callable[[np.random.Generator], Floats] = _draw,
        levers: Sequence[tuple[str, float]] = LEVERS,
        berthed_within_m: float = 4.0,
    ) -> None:
        scenario = example("docking") if scenario is None else scenario
        self._draw = draw
        self.native = Docking(scenario, count, threads, levers, berthed_within_m)

    def begin(
        self, which: Sequence[int], randoms: Sequence[np.random.Generator]
    ) -> Observation:
        """Restarts some episodes, and observes them."""
        return self.native.begin(which, np.stack([self._draw(random) for random in randoms]))

    def step(
        self, actions: npt.NDArray[Any]
    ) -> tuple[Observation, Floats, npt.NDArray[np.int8], npt.NDArray[np.bool_]]:
        """One second: observations, rewards, how each episode ended (see :func:`words`), and which are truncated."""
        return self.native.step(np.ascontiguousarray(actions, dtype=np.float64))

    def plan(self, index: int) -> Plan:
        """What a picture of an episode shows."""
        north, east, heading, *speeds = self.native.states[index].tolist()
        orders, wind, steps, share = self.native.shown(index)
        return Plan(
            ship=(north, east, heading),
            speeds=(speeds[0], speeds[1]),
            orders=np.array(orders),
            wind=wind,
            seconds=steps,
            share=share,
        )

    @staticmethod
    def words(ended: npt.NDArray[np.int8]) -> npt.NDArray[np.str_]:
        """How episodes ended, in words; empty for those that have not."""
        words: npt.NDArray[np.str_] = _WORDS[ended]
        return words


class DockingEnv(gymnasium.Env[Observation, Action]):
    """One ship to be brought alongside; see :mod:`fenderline.docking`."""

    metadata: dict[str, Any] = {"render_modes": RENDER_MODES, "render_fps": 10}

    def __init__(self, render_mode: str | None = None) -> None:
        self.render_mode = known_render_mode(render_mode)
        self._picture: Picture | None = None
        self.observation_space = _observation_space()
        self.action_space = _action_space()
        self._berth = _Berth(1, 1)

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Observation, dict[str, Any]]:
        """Starts an episode, drawn from ``seed``, or from the random state that the last one left."""
        super().reset(seed=seed)
        seen = self._berth.begin([0], [self.np_random])[0]
        if self.render_mode == "human":
            self._show()
        return seen, {}

    def step(self, action: Action) -> tuple[Observation, float, bool, bool, dict[str, Any]]:
        """One second; ``info["ended"]`` says how an episode ended."""
        seen, rewards, ended, truncated = self._berth.step(np.asarray(action)[None])
        info = {"ended": str(self._berth.words(ended)[0])} if ended[0] else {}
        if self.render_mode == "human":
            self._show()
        return seen[0], float(rewards[0]), bool(ended[0]), bool(truncated[0]), info

    def render(self) -> Any:
        """The plan as an array (height, width, 3) of bytes, with ``render_mode="rgb_array"``. ``"human"`` shows it in a
        window in each step by itself."""
        if self.render_mode != "rgb_array":
            return None
        return self._show().image()

    def _show(self) -> Picture:
        if self._picture is None:
            self._picture = Picture(window=self.render_mode == "human")
        self._picture.draw([self._berth.plan(0)])
        return self._picture

    def close(self) -> None:
        """Closes the window."""
        if self._picture is not None:
            self._picture.close()
            self._picture = None


class DockingVectorEnv(VectorEnv[Observation, Action, npt.NDArray[Any]]):
    """Many environments at once, on ``threads`` threads; an episode restarts in the step in which it ends."""

    metadata: dict[str, Any] = {
        "render_modes": ["rgb_array"],
        "render_fps": 10,
        "autoreset_mode": AutoresetMode.SAME_STEP,
    }

    def __init__(
        self, num_envs: int = 1, threads: int = 1, render_mode: str | None = None
    ) -> None:
        self.render_mode = known_render_mode(render_mode, ["rgb_array"])
        self._picture: Picture | None = None
        # First of all: it refuses impossible numbers, before anything is as large.
        self._berth = _Berth(num_envs, threads)
        self.num_envs = num_envs
        self.single_observation_space = _observation_space()
        self.single_action_space = _action_space()
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self._randoms = [seeding.np_random()[0] for _ in range(num_envs)]

    def reset(
        self,
        *,
        seed: int | Sequence[int | None] | None = None,
        options: dict[str, Any] | None = None,
    ) -> tuple[Observation, dict[str, Any]]:
        """Starts all episodes: environment ``i`` like a single one with the seed ``seed + i``, or ``seed[i]``."""
        if isinstance(seed, int):
            seed = [seed + index for index in range(self.num_envs)]
        if seed is not None:
            if len(seed) != self.num_envs:
                raise ValueError(f"there are {len(seed)} seeds for {self.num_envs} environments")
            for index, own in enumerate(seed):
                if own is not None:
                    self._randoms[index] = seeding.np_random(own)[0]
        return self._berth.begin(range(self.num_envs), self._randoms), {}

    def step(
        self, actions: Action
    ) -> tuple[
        Observation, npt.NDArray[Any], npt.NDArray[Any], npt.NDArray[Any], dict[str, Any]
    ]:
        """One second of each; ``info["final_obs"]`` and ``info["final_info"]`` describe episodes that ended."""
        seen, rewards, ended, truncated = self._berth.step(actions)
        terminated = ended > 0
        over = terminated | truncated
        info: dict[str, Any] = {}
        if over.any():
            which = np.flatnonzero(over)
            final = np.full(self.num_envs, None, dtype=object)
            for index in which:
                final[index] = seen[index].copy()
            info = {
                "final_obs": final,
                "_final_obs": over,
                "final_info": {"ended": self._berth.words(ended), "_ended": over},
                "_final_info": over,
            }
            randoms = [self._randoms[index] for index in which]
            seen[which] = self._berth.begin(which.tolist(), randoms)
        return seen, rewards, terminated, truncated, info

    def render(self) -> tuple[Any, ...] | None:
        """The plan of each, as arrays (height, width, 3) of bytes, with ``render_mode="rgb_array"``."""
        if self.render_mode is None:
            return None
        if self._picture is None:
            self._picture = Picture(window=False)
        images = []
        for index in range(self.num_envs):
            self._picture.draw([self._berth.plan(index)])
            images.append(self._picture.image())
        return tuple(images)

    def close_extras(self, **kwargs: Any) -> None:
        """Forgets the picture."""
        if self._picture is not None:
            self._picture.close()
            self._picture = None


gymnasium.register(
    ENV_ID,
    entry_point="fenderline.docking:DockingEnv",
    vector_entry_point="fenderline.docking:DockingVectorEnv",
)
