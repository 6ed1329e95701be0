# %% [markdown]
# # Coefficients of a ship from measured tracks
#
# KVLCC2 with four changed coefficients makes a turning circle and a zig-zag; a receiver with noise, rounding and gaps
# measures them. From the tracks and the ship as the library has her, the identification finds the changes again.
#
#     python examples/python/identification.py                # one seed, the table of one fit
#     python examples/python/identification.py --seeds 50     # how often the stated bands hold the truth
#     python examples/python/identification.py --write        # the tracks of examples/identification

# %%
import argparse
import math
import tempfile
from pathlib import Path

import numpy as np
from fenderline import Scenario, Simulation, identify

FOLDER = Path(__file__).resolve().parents[1] / "identification"
TRIALS = ("turning", "zig_zag")
#: The ship of the tracks: factors on the library's numbers.
TRUTH = {
    "rudder.lift_gradient": 1.10,
    "sway_polynomial.n_r": 0.92,
    "sway_polynomial.y_v": 1.15,
    "added_mass.sway": 0.90,
}
#: Deviation of the places (m) and of the headings (degrees).
NOISE_M, NOISE_DEG = 1.5, 0.2
#: The origin and the antenna of mapping.toml.
ORIGIN_DEG, ANTENNA_M = (53.9, 7.6), (-150.0, 6.0)


# %%
def on_earth(north_m: float, east_m: float) -> tuple[float, float]:
    """Latitude and longitude (degrees) of a place on the plane that touches WGS 84 at the origin."""
    radius_m, squared = 6378137.0, 6.69437999014e-3
    latitude, longitude = map(math.radians, ORIGIN_DEG)
    sin, cos = math.sin(latitude), math.cos(latitude)
    across = radius_m / math.sqrt(1 - squared * sin**2)
    out = across * cos - north_m * sin
    up = across * (1 - squared) * sin + north_m * cos
    around = math.hypot(out, east_m)
    for _ in range(8):
        across = radius_m / math.sqrt(1 - squared * math.sin(latitude) ** 2)
        latitude = math.atan2(up + squared * across * math.sin(latitude), around)
    return math.degrees(latitude), math.degrees(longitude + math.atan2(east_m, out))


# %%
def measured(trial: str, seed: int, folder: Path) -> Path:
    """Makes up the track of a trial: a row every 2 s, one of ten lost, places to 10⁻⁶ degrees, headings to 0.1°."""
    draw = np.random.default_rng([seed, TRIALS.index(trial)])
    own = Scenario.load(FOLDER / f"{trial}.toml")
    vessel = identify.VesselFile(own, "ship")
    # She begins a little off the scenario's start, as a ship does.
    start = {
        "body.ship.position": draw.normal(0.0, 30.0, 2).tolist(),
        "body.ship.heading": float(draw.normal(0.0, 0.03)),
        "body.ship.velocity.surge": 7.7 + float(draw.normal(0.0, 0.2)),
    }
    simulation = Simulation(vessel.scenario_with(vessel.changed(TRUTH), {}).with_set(start))
    rows = ["UTC,lat,lon,gyro"]
    ahead, aside = ANTENNA_M[0] - vessel.gravity_m, ANTENNA_M[1]
    for second in range(0, 600, 2):
        north, east, heading = simulation.states[0, :3].tolist()
        cos, sin = math.cos(heading), math.sin(heading)
        north += cos * ahead - sin * aside + float(draw.normal(0.0, NOISE_M))
        east += sin * ahead + cos * aside + float(draw.normal(0.0, NOISE_M))
        gyro = math.degrees(heading) + float(draw.normal(0.0, NOISE_DEG))
        time = f"2026-05-01T{6 + second // 3600:02}:{second % 3600 // 60:02}:{second % 60:02}Z"
        if draw.random() > 0.1 or second == 0:
            latitude, longitude = on_earth(north, east)
            rows.append(f"{time},{latitude:.6f},{longitude:.6f},{gyro % 360:.1f}")
        simulation.step(2)
    path = folder / f"{trial}.csv"
    path.write_text("\n".join(rows) + "\n", "utf-8")
    return path


# %%
def fit(seed: int, folder: Path, profiles: bool = True) -> identify.Identification:
    """Identifies the changed coefficients from the tracks of a seed."""
    tracks = [measured(trial, seed, folder) for trial in TRIALS]
    scenarios = [FOLDER / f"{trial}.toml" for trial in TRIALS]
    return identify.identify(scenarios, tracks, list(TRUTH), mapping=FOLDER / "mapping.toml", profiles=profiles, threads=2)


# %%
def table(seeds: int) -> str:
    """How often the stated bands hold the truth, and how far the fits are from the truth."""
    factors, deviations, inside = [], [], []
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(1, seeds + 1):
            found = fit(seed, Path(folder), profiles=False)
            own = {one.name: one for one in found.coefficients}
            factors.append([own[name].factor for name in TRUTH])
            deviations.append([own[name].deviation for name in TRUTH])
            inside.append([own[name].refused is None and own[name].band[0] <= truth <= own[name].band[1] for name, truth in TRUTH.items()])
    misses = np.array(factors) / list(TRUTH.values()) - 1.0
    rows = ["| coefficient | truth | mean of the fits | scatter | mean standard error | largest error | in the 95 % band |", "|---|---:|---:|---:|---:|---:|---:|"]
    for column, (name, truth) in enumerate(TRUTH.items()):
        fits = np.array(factors)[:, column]
        rows.append(
            f"| `{name}` | {truth:.2f} | {fits.mean():.4f} | {fits.std(ddof=1):.4f} | {np.array(deviations)[:, column].mean():.4f} "
            f"| {100 * np.abs(misses[:, column]).max():.2f} % | {sum(own[column] for own in inside)} of {seeds} |"
        )
    held = int(np.sum(inside))
    return "\n".join([*rows, f"\nIn all {held} of {len(TRUTH) * seeds} bands hold the truth."])


# %%
def main() -> None:
    parser = argparse.ArgumentParser(description="Coefficients of a ship from measured tracks whose truth is known.")
    parser.add_argument("--seeds", type=int, default=0, help="print a table over so many seeds, at least 2")
    parser.add_argument("--write", action="store_true", help="write the tracks of examples/identification")
    given = parser.parse_args()
    if given.write:
        for trial in TRIALS:
            measured(trial, 1, FOLDER)
    elif given.seeds:
        print(table(given.seeds))
    else:
        with tempfile.TemporaryDirectory() as folder:
            found = fit(1, Path(folder))
        print(found.table())
        print("the ship of the tracks:", TRUTH)


if __name__ == "__main__":
    main()
