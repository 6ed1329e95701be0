"""Starts `fenderline serve`, lets an example steer for some simulated minutes, and says how far the ship was off.

    python examples/python/steering/measured.py track --by client     # the autopilot by the Python client
    python examples/python/steering/measured.py track --by nmea       # the same autopilot by NMEA sentences
    python examples/python/steering/measured.py station               # station keeping

The distance from the track is the server's own: the instructor's page shows it. At the end a person takes the helm in
one press.
"""

from __future__ import annotations

import argparse
import asyncio
import math
import re
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import autopilot
import autopilot_nmea
import keep_station
from fenderline.live import Client

ROOT = Path(__file__).resolve().parents[3]


@dataclass
class Served:
    """A running server."""

    links: dict[str, str]
    instruments: str
    orders: str


def read_greeting(process: subprocess.Popen[str]) -> Served:
    """Reads what the server prints when it has started."""
    links, instruments, orders = {}, "", ""
    assert process.stdout is not None
    for line in process.stdout:
        if match := re.match(r"\s*(\S.*?)\s+(http://\S+)\s*$", line):
            links[match[1]] = match[2]
        elif match := re.search(r"AIS over TCP on (\S+)", line):
            instruments = match[1]
        elif match := re.search(r"of a controller over TCP on (\S+)", line):
            orders = match[1]
        elif "Recorded to" in line:
            return Served(links, instruments, orders)
    raise SystemExit("the server did not start")


async def watch(instructor: Client, until_s: float) -> list[float]:
    """The server's own distances from the track (m), until a simulated time."""
    distances = []
    async for frame in instructor:
        distances.append(abs(frame.ship.raw["plan"]["cross_track_m"]))
        if frame.t_s >= until_s:
            break
    return distances


async def take_back(served: Served) -> float:
    """A person takes the helm from the program, and puts the rudder to 10°. Returns the wall time that this took (s)."""
    async with Client.connect(served.links["pilot"], name="Anna", person=True) as person:
        await person.frame()
        loop = asyncio.get_running_loop()
        began = loop.time()
        await person.take_helm()
        await person.rudder(math.radians(10))
        took = loop.time() - began
        for _ in range(20):
            frame = await person.frame()
        if abs(frame.ship.rudder.order - math.radians(10)) > 1e-6:
            raise SystemExit("the program steers against the person")
    return took


async def run(options: argparse.Namespace, served: Served) -> float:
    until_s = 60 * options.minutes
    async with Client.connect(served.links["instructor"], name="observer") as instructor:
        await instructor.pace(options.pace)
        if options.what == "station":
            async with Client.connect(served.links["pilot"], name="station keeping") as ship:
                frame = await ship.frame()
                at, heading = frame.ship.position_m, frame.ship.heading_rad
                distances = await keep_station.keep_station(ship, at, heading, until_s)
            return max(off for _, off in distances)
        watching = asyncio.create_task(watch(instructor, until_s))
        if options.by == "client":
            async with Client.connect(served.links["pilot"], name="autopilot") as ship:
                steering = asyncio.create_task(autopilot.keep_track(ship, math.inf))
                worst = await ended(watching, steering)
                print(f"a person had the helm and the rudder {1000 * await take_back(served):.0f} ms after the press")
                steering.cancel()
        else:
            keeping = autopilot_nmea.keep_track(
                served.instruments, served.orders, math.inf, options.pace
            )
            steering = asyncio.create_task(keeping)
            worst = await ended(watching, steering)
            print(f"a person had the helm and the rudder {1000 * await take_back(served):.0f} ms after the press")
            steering.cancel()
        return worst


async def ended(watching: asyncio.Task[list[float]], steering: asyncio.Task[list[float]]) -> float:
    """The largest distance, once the time is over; fails if the autopilot has failed."""
    done, _ = await asyncio.wait([watching, steering], return_when=asyncio.FIRST_COMPLETED)
    if steering in done:
        steering.result()
    return max(await watching)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("what", choices=["track", "station"])
    parser.add_argument("--by", choices=["client", "nmea"], default="client")
    parser.add_argument("--minutes", type=float, default=30.0, help="simulated time [default: 30]")
    parser.add_argument("--pace", type=float, help="simulated time over wall time [default: 10; by NMEA 4]")
    parser.add_argument("--program", default="fenderline", help="the program [default: fenderline]")
    parser.add_argument("--limit", type=float, default=10.0, help="largest distance [default: 10 m]")
    options = parser.parse_args()
    options.pace = options.pace or (4.0 if options.by == "nmea" and options.what == "track" else 10.0)
    scenario = ROOT / "scenarios" / "live" / f"keep_{options.what}.toml"
    with tempfile.TemporaryDirectory() as sessions:
        command = [options.program, "serve", str(scenario), "--port", "0", "--sessions", sessions]
        command += ["--nmea-tcp", "0", "--nmea-steer", "0"]
        process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        try:
            worst = asyncio.run(run(options, read_greeting(process)))
        finally:
            process.terminate()
            process.wait()
            assert process.stdout is not None
            process.stdout.close()
    way = "" if options.what == "station" else f" by {options.by}"
    print(f"{options.what}{way}, {options.minutes:g} min at pace {options.pace:g}: at most {worst:.1f} m off")
    if worst > options.limit:
        sys.exit(f"more than {options.limit:g} m")


if __name__ == "__main__":
    main()
