# %% [markdown]
# # Bringing a ship alongside
#
# A coaster of 130 m comes up to her berth; wind, current and where she begins are drawn from the seed of the
# episode. A random policy against one that does what a master does: come up the berth, stop abreast of it, breast in
# slowly and parallel, and let the fenders take her.
#
# Run it as a program, or cell by cell in an editor that knows the percent format.

# %%
import fenderline.docking
import gymnasium
import numpy as np
import numpy.typing as npt

SHIPS = 32
env = gymnasium.make_vec("fenderline/Docking-v0", num_envs=SHIPS)

# %% [markdown]
# The observation is in the quay's axes, in metres, seconds and radians: see `help(fenderline.docking)`.


# %%
def master(seen: npt.NDArray[np.float32]) -> npt.NDArray[np.float32]:
    """Speeds by distance to go, thrust by speed, wind met by thrust of the same size."""
    to_go, off, heading, ahead, towards, turn = seen[:, :6].T
    wind_along, wind_towards = seen[:, 10:12].T
    # Come up at no more than 1.2 m/s, and so that 8 mm/s² stop her. Breast in only when she is abreast, slower the
    # nearer.
    stops_from = np.sqrt(2.0 * 0.008 * np.abs(to_go))
    ahead_wanted = np.sign(to_go) * np.minimum(np.minimum(stops_from, 0.04 * np.abs(to_go)), 1.2)
    least_off = np.clip(4.0 * (np.abs(to_go) - 2.5), 0.0, 15.0)
    fastest_in = np.clip(0.02 + 0.02 * off, 0.02, 0.3)
    towards_wanted = np.clip(0.03 * (off - least_off), -0.3, fastest_in)
    towards_wanted += np.where((least_off == 0.0) & (off < 0.5), 0.02, 0.0)
    # Wind on her side, over the 220 kN of both thrusters; turning by one against the other.
    wind = 0.5 * 1.225 * 0.9 * 1300.0 * wind_towards * np.abs(wind_towards) / 220e3
    breast = 6.0 * (towards_wanted - towards) - wind
    swing = -5.0 * heading - 150.0 * turn
    engine = 4.0 * (ahead_wanted - ahead) - 0.0005 * wind_along * np.abs(wind_along)
    orders = np.stack([np.zeros_like(engine), engine, breast + swing, breast - swing], axis=1)
    clipped: npt.NDArray[np.float32] = np.clip(orders, -1.0, 1.0).astype(np.float32)
    return clipped


# %%
def play(policy: str, seed: int) -> tuple[list[str], list[float], list[float]]:
    """One episode of each ship: how it ended, its return, and the fenders' largest share of rated energy."""
    seen, _ = env.reset(seed=seed)
    env.action_space.seed(seed)
    ended, shares = ["out of time"] * SHIPS, [0.0] * SHIPS
    returns, going = np.zeros(SHIPS), np.ones(SHIPS, dtype=bool)
    while going.any():
        actions = env.action_space.sample() if policy == "random" else master(seen)
        seen, rewards, terminated, truncated, info = env.step(actions)
        returns[going] += rewards[going]
        for ship in np.flatnonzero((terminated | truncated) & going):
            ended[ship] = str(info["final_info"]["ended"][ship]) or "out of time"
            shares[ship] = float(info["final_obs"][ship][13])
        going &= ~(terminated | truncated)
    return ended, returns.tolist(), shares


# %%
for policy in ("random", "master"):
    ended, returns, shares = play(policy, seed=7)
    counts = {kind: ended.count(kind) for kind in sorted(set(ended))}
    print(f"{policy:>6}: mean return {np.mean(returns):6.1f}, endings {counts}")
    if policy == "master":
        print(f"        largest share of a fender's rated energy {max(shares):.2f}")

# %% [markdown]
# The master lies alongside in nearly all of them; a learner may begin where it stops.

# %%
assert ended.count("alongside") >= 0.9 * SHIPS
