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

SHIPS = 32
env = gymnasium.make_vec("fenderline/Docking-v0", num_envs=SHIPS)

# %% [markdown]
# The observation is in the quay's axes, each number over its scale: see `help(fenderline.docking)`. The policy of the
# master is `fenderline.docking.master`; its source is thirty lines.


# %%
def play(policy: str, seed: int) -> tuple[list[str], list[float], list[float]]:
    """One episode of each ship: how it ended, its return, and the fenders' largest share of rated energy."""
    seen, _ = env.reset(seed=seed)
    env.action_space.seed(seed)
    ended, shares = ["out of time"] * SHIPS, [0.0] * SHIPS
    returns, going = np.zeros(SHIPS), np.ones(SHIPS, dtype=bool)
    while going.any():
        actions = env.action_space.sample() if policy == "random" else fenderline.docking.master(seen)
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
# The master lies alongside in nearly all of them. `examples/python/learn_to_berth.py` learns from it, and goes on.

# %%
assert ended.count("alongside") >= 0.9 * SHIPS
