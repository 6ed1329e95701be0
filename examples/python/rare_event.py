# %% [markdown]
# # The fender failure that comes once in 100,000 berthings
#
# A tanker comes to four cone fenders; speed, heading, rate of turn and way ahead are drawn for each berthing. How often
# is a fender loaded beyond its rated energy? FORM, SORM, importance sampling and subset simulation answer with some
# thousand runs each. Beside them stands a plain campaign of ten million berthings, made once.
#
#     python examples/python/rare_event.py                          # the table of the guide
#     python examples/python/rare_event.py --plain 10000000         # makes the plain campaign again, and keeps its figures

# %%
import argparse
import json
import math
import tomllib
from pathlib import Path

import numpy as np
from fenderline import campaign, reliability

FILE = Path(__file__).resolve().parents[2] / "campaigns" / "rare_event.toml"
#: Figures of the plain campaign.
KEPT = Path(__file__).with_suffix(".json")


# %%
def kept() -> reliability.Estimate:
    """The plain campaign that was made once."""
    figures = json.loads(KEPT.read_text("utf-8"))
    return reliability.Estimate("plain campaign", figures["probability"], figures["low"], figures["high"], figures["runs"])


# %%
def cannot_fail(state: reliability.LimitState, probabilities: np.ndarray) -> np.ndarray:
    """Which berthings have less energy than one fender is rated for. Nothing drives the ship, and no contact gains energy, so
    these berthings need no run: 98 of 100."""
    ship = tomllib.loads((FILE.parent / "rare_berth.toml").read_text("utf-8"))["body"]["ship"]
    mass_kg, gyradius_m, added = 42_000e3, 46.0, ship["added_mass"]
    assert (ship["mass"], ship["gyradius"]) == ("42000 t", "46 m")
    # Of a hard berthing, stored energy and its share of the rated energy.
    energy_kj, share = campaign.evaluate(state.campaign, [[0.9999, 0.5, 0.5, 0.5]], ["energy", "energy_share"])[0]
    rated_j = 1e3 * energy_kj / (0.01 * share)
    # The largest speed in each of 4,000 classes of probability that are narrow in the tails: never too small.
    tail = np.logspace(-16, math.log10(0.5), 2001)
    edges = np.concatenate([tail, 1.0 - tail[-2::-1]])
    speeds = []
    for column, to_si in ((0, 1e-2), (2, math.radians(1.0)), (3, 1e-2)):
        levels = np.full((len(edges), state.dimension), 0.5)
        levels[:, column] = np.minimum(edges, 1.0 - 2.0**-53)
        name = state.campaign.variables[column]
        values = to_si * np.abs([float(str(state.campaign.at(row)[name])) for row in levels.tolist()])
        above = np.clip(np.searchsorted(edges, probabilities[:, column]), 1, len(edges) - 1)
        speeds.append(np.maximum(values[above], values[above - 1]))
    sway, turn, surge = speeds
    energy_j = 0.5 * mass_kg * ((1 + added["surge"]) * surge**2 + (1 + added["sway"]) * sway**2 + (1 + added["yaw"]) * (gyradius_m * turn) ** 2)
    return np.asarray(energy_j < rated_j)


# %%
def estimates(state: reliability.LimitState, runs: int, seed: int) -> tuple[reliability.DesignPoint, list[reliability.Estimate]]:
    """The design point, and an estimate by each method; ``runs`` is shared by the two methods that draw."""
    near = reliability.form(state, seed=seed)
    found = [near.estimate, reliability.sorm(state, near)]
    found.append(reliability.importance_sampling(state, near, runs=runs // 5, seed=seed))
    found.append(reliability.subset_simulation(state, runs=runs // 2, seed=seed))
    return near, found


# %%
def table(found: list[reliability.Estimate]) -> str:
    """Estimates as a table."""
    rows = ["| method | runs | probability of a berthing | 95 % band | once in |", "|---|---:|---:|---|---:|"]
    for own in found:
        band = "–" if np.isnan(own.low) else f"{own.low:.2e} to {own.high:.2e}"
        rows.append(f"| {own.method} | {own.runs:,} | {own.probability:.2e} | {band} | {own.once_in:,.0f} berthings |")
    return "\n".join(rows)


# %%
def coverage(state: reliability.LimitState, runs: int, seeds: int, truth: reliability.Estimate) -> str:
    """How often the band of each method and the band of the plain campaign have a number in common."""
    meet = {"importance sampling": 0, "subset simulation": 0}
    for seed in range(1, seeds + 1):
        for own in estimates(state, runs, seed)[1]:
            if own.method in meet:
                meet[own.method] += own.low <= truth.high and truth.low <= own.high
    return "\n".join(f"{method}: the bands meet in {count} of {seeds} seeds" for method, count in meet.items())


# %%
def bands_of_subset_simulation(seeds: int) -> str:
    """How often the bands of subset simulation hold a known probability: this module's bound, and OpenTURNS' own coefficient."""
    import openturns as ot

    limit = 4.0
    truth = 0.5 * math.erfc(limit / math.sqrt(2.0))
    function = ot.PythonFunction(1, 1, func_sample=lambda sample: limit - np.asarray(sample))
    event = ot.ThresholdEvent(ot.CompositeRandomVector(function, ot.RandomVector(ot.Normal(1))), ot.LessOrEqual(), 0.0)
    rows = ["| runs of a step | scatter | OpenTURNS' band holds the truth | our band holds the truth |", "|---:|---:|---:|---:|"]
    for each in (500, 1000, 2000):
        logarithms, own, theirs = [], 0, 0
        for seed in range(seeds):
            ot.RandomGenerator.SetSeed(seed)
            method = ot.SubsetSampling(event)
            method.setBlockSize(each // 10)
            method.setMaximumOuterSampling(10)
            method.run()
            result = method.getResult()
            away = math.log(result.getProbabilityEstimate() / truth)
            logarithms.append(away)
            shares = (reliability.bound(np.array(method.getCoefficientOfVariationPerStep()), each), result.getCoefficientOfVariation())
            inside = [abs(away) < 1.96 * math.sqrt(math.log1p(share**2)) for share in shares]
            own, theirs = own + inside[0], theirs + inside[1]
        rows.append(f"| {each} | {np.std(logarithms):.2f} | {theirs} of {seeds} | {own} of {seeds} |")
    return "\n".join(rows)


# %%
def main() -> None:
    parser = argparse.ArgumentParser(description="The fender failure that comes once in 100,000 berthings.")
    parser.add_argument("--runs", type=int, default=20_000, help="runs that all methods together may take")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seeds", type=int, default=0, help="count over so many seeds how often the bands meet")
    parser.add_argument("--plain", type=int, default=0, help="make a plain campaign of so many berthings, and keep its figures")
    parser.add_argument("--threads", type=int, help="threads; all cores if left out")
    parser.add_argument("--bands", action="store_true", help="how often the bands of subset simulation hold a known probability")
    given = parser.parse_args()
    if given.bands:
        print(bands_of_subset_simulation(100))
        return
    state = reliability.LimitState(FILE, "rated", threads=given.threads)
    if given.plain:
        plain = reliability.plain(state, runs=given.plain, safe=lambda drawn: cannot_fail(state, drawn), progress=True)
        KEPT.write_text(json.dumps({"runs": plain.runs, "made": state.runs, "probability": plain.probability, "low": plain.low, "high": plain.high}, indent=1) + "\n", "utf-8")
        print(plain)
        return
    truth = kept()
    if given.seeds:
        print(coverage(state, given.runs, given.seeds, truth))
        return
    near, found = estimates(state, given.runs, given.seed)
    print(table([*found, truth]))
    print(f"\nAll methods together: {state.runs:,} runs.\n")
    for own in (near, *near.others):
        values = ", ".join(f"{name} {value:.3g}" for name, value in own.values.items() if isinstance(value, float))
        shares = ", ".join(f"{name} {100 * share:.0f} %" for name, share in own.importance.items())
        print(f"design point: {values} (distance {own.index:.2f}; {shares})")


if __name__ == "__main__":
    main()
