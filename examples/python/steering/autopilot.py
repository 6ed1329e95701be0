"""An autopilot outside the program that keeps the passage plan of a ship, by the Python client.

    fenderline serve scenarios/live/keep_track.toml
    python examples/python/steering/autopilot.py "http://127.0.0.1:8090/?token=..."    # the pilot's link

A person takes the helm back at any time with *Take the helm* on a page, and gives it to the autopilot again by
releasing the helm.
"""

from __future__ import annotations

import argparse
import asyncio
from math import atan2, degrees, hypot

from fenderline.live import Client, Frame, HelmError
from track import Seen, Track, TrackPilot, waypoints_of

RADIUS_M = 1500.0
"""Radius of the turns in `scenarios/live/keep_track.toml`."""
ENGINE = 0.85
"""Revolutions over full revolutions."""
BETWEEN_ORDERS_S = 1.0
"""Simulated time between two orders."""


def seen(frame: Frame) -> Seen:
    """What the autopilot may know of a frame."""
    ship = frame.ship
    return Seen(frame.t_s, ship.position_m, ship.heading_rad, ship.turn_radps, ship.velocity_mps, ship.water_mps[0])


def pilot_of(ship: Client) -> TrackPilot:
    """The autopilot for a ship and her passage plan."""
    info = next(vessel for vessel in ship.hello["vessels"] if vessel["name"] == ship.vessel)
    if info["plan"] is None:
        raise SystemExit(f"{ship.vessel} has no passage plan")
    return TrackPilot(Track(waypoints_of(info["plan"]), RADIUS_M), float(info["length_m"]))


async def keep_track(ship: Client, until_s: float, tell_every_s: float = 60.0) -> list[float]:
    """Keeps the track until a simulated time. Returns the cross-track distances (m), one an order."""
    pilot = pilot_of(ship)
    await ship.take_helm()
    await ship.engine(ENGINE)
    distances: list[float] = []
    ordered_s = told_s = float("-inf")
    async for frame in ship:
        if frame.t_s >= until_s:
            return distances
        if frame.t_s < ordered_s + BETWEEN_ORDERS_S:
            continue
        ordered_s = frame.t_s
        angle = pilot.rudder(seen(frame))
        distances.append(pilot.cross_track_m)
        try:
            await ship.rudder(angle)
        except HelmError:
            # A person has the helm. When she releases it, the autopilot goes on.
            if not ship.has_helm and await is_free(ship):
                pilot = pilot_of(ship)
        if frame.t_s >= told_s + tell_every_s:
            told_s = frame.t_s
            print(
                f"{frame.t_s:6.0f} s: {pilot.cross_track_m:+5.1f} m off the track, rudder {degrees(angle):+5.1f}°, "
                f"drift {hypot(*pilot.drift_mps):.2f} m/s to {degrees(atan2(*reversed(pilot.drift_mps))) % 360:03.0f}°",
                flush=True,
            )
    return distances


async def is_free(ship: Client) -> bool:
    """Takes the helm if nobody holds it."""
    claims = (claim for claim in ship.hello["claims"] if claim["control"] == {"vessel": ship.vessel})
    if any(claim["holder"] is not None for claim in claims):
        return False
    try:
        await ship.take_helm()
    except HelmError:
        return False
    return True


async def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("link", help="the pilot's link, as `fenderline serve` prints it")
    parser.add_argument("--minutes", type=float, default=30.0, help="simulated time of the end [default: 30]")
    options = parser.parse_args()
    async with Client.connect(options.link, name="autopilot") as ship:
        distances = await keep_track(ship, 60 * options.minutes)
    print(f"farthest from the track: {max(map(abs, distances)):.1f} m")


if __name__ == "__main__":
    asyncio.run(main())
