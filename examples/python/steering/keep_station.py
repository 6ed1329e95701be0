"""Dynamic positioning outside the program: keeps the place and the heading of a ship with engine and thrusters.

    fenderline serve scenarios/live/keep_station.toml
    python examples/python/steering/keep_station.py "http://127.0.0.1:8090/?token=..."    # the pilot's link

The controller has a proportional, an integral and a derivative part in each of surge, sway and yaw. The integral part
is its estimate of the mean force of wind and current.
"""

from __future__ import annotations

import argparse
import asyncio
import math
from dataclasses import dataclass, field

from fenderline.live import Client, Ship
from track import Place, wrapped

BETWEEN_ORDERS_S = 1.0
"""Simulated time between two orders."""


@dataclass
class Gains:
    """What the controller has to know of the ship: `keep_station.toml` has her."""

    mass_kg: tuple[float, float] = (15.5e6, 27e6)
    """Mass with the added mass, in surge and in sway."""
    inertia_kgm2: float = 2.8e10
    """Moment of inertia in yaw, with the added one."""
    full_thrust_n: float = 500e3
    """Thrust of the propeller at rest and full revolutions."""
    period_s: float = 160.0
    """Period of the motion that the proportional part alone would give."""
    damping: float = 0.9
    integral_s: float = 200.0


@dataclass
class StationKeeper:
    """Keeps a place and a heading; :meth:`forces` is to be called about once a second."""

    place_m: Place
    heading_rad: float
    gains: Gains = field(default_factory=Gains)
    held: list[float] = field(default_factory=lambda: [0.0, 0.0, 0.0])
    """The integral parts: force ahead and to starboard (N), moment (N·m)."""
    _before: float | None = None

    def forces(self, t_s: float, ship: Ship) -> tuple[float, float, float]:
        """The wanted force ahead and to starboard (N), and the moment, bow to starboard (N·m)."""
        passed = 0.0 if self._before is None else min(max(t_s - self._before, 0.0), 10.0)
        self._before = t_s
        sin, cos = math.sin(ship.heading_rad), math.cos(ship.heading_rad)

        def own(north: float, east: float) -> tuple[float, float]:
            return cos * north + sin * east, cos * east - sin * north

        at, velocity = ship.position_m, ship.velocity_mps
        to_go = own(self.place_m[0] - at[0], self.place_m[1] - at[1])
        errors = (*to_go, wrapped(self.heading_rad - ship.heading_rad))
        rates = (*own(*velocity), ship.turn_radps)
        inertia = (*self.gains.mass_kg, self.gains.inertia_kgm2)
        omega = 2 * math.pi / self.gains.period_s
        wanted = []
        for index, (mass, error, rate) in enumerate(zip(inertia, errors, rates, strict=True)):
            # Far from the place, the ship is to come slowly.
            most = 0.05 if index == 2 else 8.0
            error = max(-most, min(most, error))
            self.held[index] += mass * omega**2 * error * passed / self.gains.integral_s
            wanted.append(
                mass * (omega**2 * error - 2 * self.gains.damping * omega * rate) + self.held[index]
            )
        return wanted[0], wanted[1], wanted[2]


def allocated(forces: tuple[float, float, float], thrusters: list[dict[str, float]]) -> list[float]:
    """Shares of the bow and the stern thruster that give a force to starboard and a moment together."""
    _, sway, yaw = forces
    bow, stern = thrusters
    by_bow = (yaw - stern["along_m"] * sway) / (bow["along_m"] - stern["along_m"])
    shares = by_bow / bow["force_n"], (sway - by_bow) / stern["force_n"]
    return [max(-1.0, min(1.0, share)) for share in shares]


async def keep_station(
    ship: Client, place_m: Place, heading_rad: float, until_s: float, tell_every_s: float = 60.0
) -> list[tuple[float, float]]:
    """Keeps a station until a simulated time. Returns time (s) and distance from the place (m), one pair an order."""
    info = next(vessel for vessel in ship.hello["vessels"] if vessel["name"] == ship.vessel)
    thrusters = sorted(info["thrusters"], key=lambda of: -of["along_m"])
    if len(thrusters) != 2:
        raise SystemExit(f"{ship.vessel} needs a bow and a stern thruster")
    keeper, distances = StationKeeper(place_m, heading_rad), []
    ordered_s = told_s = float("-inf")
    await ship.take_helm()
    await ship.rudder(0.0)
    async for frame in ship:
        if frame.t_s >= until_s:
            break
        if frame.t_s < ordered_s + BETWEEN_ORDERS_S:
            continue
        ordered_s = frame.t_s
        forces = keeper.forces(frame.t_s, frame.ship)
        share = math.copysign(math.sqrt(abs(forces[0]) / keeper.gains.full_thrust_n), forces[0])
        orders: list[dict[str, object]] = [
            {"do": "engine", "vessel": ship.vessel, "share": max(-1.0, min(1.0, share))}
        ]
        for of, power in zip(thrusters, allocated(forces, thrusters), strict=True):
            orders.append({"do": "thruster", "vessel": ship.vessel, "name": of["name"], "power": power})
        await ship.give(orders)
        off_m = math.dist(frame.ship.position_m, place_m)
        distances.append((frame.t_s, off_m))
        if frame.t_s >= told_s + tell_every_s:
            told_s = frame.t_s
            turned = math.degrees(wrapped(frame.ship.heading_rad - heading_rad))
            print(f"{frame.t_s:6.0f} s: {off_m:4.1f} m off the place, {turned:+5.1f}° off the heading", flush=True)
    return distances


async def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("link", help="the pilot's link, as `fenderline serve` prints it")
    parser.add_argument("--minutes", type=float, default=30.0, help="simulated time of the end [default: 30]")
    options = parser.parse_args()
    async with Client.connect(options.link, name="station keeping") as ship:
        frame = await ship.frame()
        place, heading = frame.ship.position_m, frame.ship.heading_rad
        distances = await keep_station(ship, place, heading, 60 * options.minutes)
    print(f"farthest from the place: {max(off for _, off in distances):.1f} m")


if __name__ == "__main__":
    asyncio.run(main())
