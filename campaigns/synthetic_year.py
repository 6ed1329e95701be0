"""Prints a year of weather at a berth, 8,760 hours as CSV, for `fenderline campaign campaigns/downtime.toml`:

    python3 campaigns/synthetic_year.py --seed 1 > campaigns/year.csv

It is made up, for an example: storms of a day or two, more and higher in winter, a swell from the open sea that turns with them, and a wind
that goes with the waves. No port has this weather. The same seed prints the same file.
"""

import argparse
import math
import random
from datetime import datetime, timedelta

HOURS = 8760


def synthetic(seed: int) -> list[tuple[float, float, float, float, float]]:
    """Significant height (m), peak period (s), where the waves come from (deg), wind speed (m/s), where it comes from (deg), by hours."""
    draw = random.Random(seed)
    storm = turn = squall = veer = 0.0
    rows = []
    for hour in range(HOURS):
        # Winter is at the turn of the year.
        winter = 0.5 * (1.0 + math.cos(2.0 * math.pi * hour / HOURS))
        # Each is a process of first order with a memory of so many hours and deviation 1.
        storm = correlated(draw, storm, 30.0)
        turn = correlated(draw, turn, 40.0)
        squall = correlated(draw, squall, 8.0)
        veer = correlated(draw, veer, 25.0)
        height_m = math.exp(-1.15 + 0.55 * winter + 0.62 * storm)
        height_m = min(max(height_m, 0.05), 3.0)
        period_s = min(max(7.0 + 4.2 * math.sqrt(height_m) + 1.3 * turn, 3.0), 20.0)
        wave_from_deg = (205.0 + 22.0 * turn) % 360.0
        wind_mps = min(max(5.5 + 1.5 * winter + 3.2 * (0.75 * storm + 0.66 * squall), 0.0), 30.0)
        wind_from_deg = (235.0 + 35.0 * turn + 30.0 * veer) % 360.0
        rows.append((height_m, period_s, wave_from_deg, wind_mps, wind_from_deg))
    return rows


def correlated(draw: random.Random, before: float, memory_h: float) -> float:
    keeps = math.exp(-1.0 / memory_h)
    return keeps * before + math.sqrt(1.0 - keeps * keeps) * draw.gauss(0.0, 1.0)


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--seed", type=int, default=1, help="seed of the random numbers")
    seed = arguments.parse_args().seed
    print("time,hs_m,tp_s,wave_from_deg,wind_speed_mps,wind_from_deg")
    start = datetime(2025, 1, 1)
    for hour, (height_m, period_s, wave_from_deg, wind_mps, wind_from_deg) in enumerate(synthetic(seed)):
        time = (start + timedelta(hours=hour)).strftime("%Y-%m-%dT%H:%M")
        print(f"{time},{height_m:.2f},{period_s:.1f},{wave_from_deg:.0f},{wind_mps:.1f},{wind_from_deg:.0f}")


if __name__ == "__main__":
    main()
