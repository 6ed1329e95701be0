"""The autopilot of `track.py` by NMEA 0183: it reads the ship's instruments and orders the rudder. Standard library only.

    fenderline serve scenarios/live/keep_track.toml --nmea-tcp 10110 --nmea-steer 10111
    python examples/python/steering/autopilot_nmea.py --instruments 127.0.0.1:10110 --orders 127.0.0.1:10111

The instruments speak once a second of wall time: at a higher pace than 4 the autopilot knows too little.
"""

from __future__ import annotations

import argparse
import asyncio
import math
import time

from track import Place, Seen, Track, TrackPilot

WAYPOINTS: list[Place] = [(0, 0), (3000, 0), (5719, 1268), (8719, 1268), (14357, -784)]
"""Those of `scenarios/live/keep_track.toml`."""
RADIUS_M = 1500.0
LENGTH_M = 180.0
METRES_PER_DEG: Place = (110_574.0, 111_320.0)
"""A degree of latitude and of longitude at 0° N 0° E, where a scenario without a chart lies (WGS 84)."""
KNOT_MPS = 1852 / 3600


def sentence(body: str) -> bytes:
    """A sentence with its check sum and line end."""
    total = 0
    for byte in body.encode("ascii"):
        total ^= byte
    return f"${body}*{total:02X}\r\n".encode("ascii")


def fields_of(line: bytes) -> list[str]:
    """The fields of a line with a good check sum; none of a bad line."""
    text = line.decode("ascii", "replace").strip()
    body, star, total = text[1:].partition("*")
    good = text[:1] in ("$", "!") and star and sentence(body)[1:] == f"{body}*{total}\r\n".encode()
    return body.split(",") if good else []


def rudder_order(angle_rad: float) -> bytes:
    """HTC in rudder mode: the angle without a sign, and its side."""
    angle = math.degrees(angle_rad)
    return sentence(f"IIHTC,V,{abs(angle):.1f},{'L' if angle < 0 else 'R'},R,N,,,,,,,,T,C")


def engine_order(share: float) -> bytes:
    """PRC: the lever in percent."""
    return sentence(f"IIPRC,{100 * share:.0f},A,,,,,B,0")


class Instruments:
    """The latest values of the instruments."""

    def __init__(self) -> None:
        self.heading_rad: float | None = None
        self.turn_radps: float | None = None
        self.log_mps: float | None = None

    def take(self, fields: list[str], t_s: float) -> Seen | None:
        """Takes a sentence. Returns what is seen when a round of sentences has come to RMC, the position."""
        match fields:
            case [kind, heading, "T"] if kind.endswith("HDT"):
                self.heading_rad = math.radians(float(heading))
            case [kind, rate, "A"] if kind.endswith("ROT"):
                self.turn_radps = math.radians(float(rate)) / 60
            case [kind, ahead, _, "A", *_] if kind.endswith("VBW"):
                self.log_mps = float(ahead) * KNOT_MPS
            case [kind, _, "A", lat, north, lon, east, knots, track, *_] if kind.endswith("RMC"):
                if self.heading_rad is None or self.turn_radps is None or self.log_mps is None:
                    return None
                place = (_angle(lat, 2, north == "S"), _angle(lon, 3, east == "W"))
                speed, way = float(knots) * KNOT_MPS, math.radians(float(track))
                return Seen(
                    t_s,
                    (place[0] * METRES_PER_DEG[0], place[1] * METRES_PER_DEG[1]),
                    self.heading_rad,
                    self.turn_radps,
                    (speed * math.cos(way), speed * math.sin(way)),
                    self.log_mps,
                )
        return None


def _angle(text: str, digits: int, is_negative: bool) -> float:
    value = float(text[:digits]) + float(text[digits:]) / 60
    return -value if is_negative else value


async def keep_track(
    instruments: str, orders: str, seconds: float, pace: float = 1.0
) -> list[float]:
    """Keeps the track for a wall time. Returns the cross-track distances (m), one an order."""
    reader, from_ship = await asyncio.open_connection(*_host_and_port(instruments))
    _, to_ship = await asyncio.open_connection(*_host_and_port(orders))
    pilot, shown, distances = TrackPilot(Track(WAYPOINTS, RADIUS_M), LENGTH_M), Instruments(), []
    to_ship.write(engine_order(0.85))
    started = time.monotonic()
    try:
        while time.monotonic() < started + seconds:
            seen = shown.take(fields_of(await reader.readline()), pace * time.monotonic())
            if seen is None:
                continue
            to_ship.write(rudder_order(pilot.rudder(seen)))
            await to_ship.drain()
            distances.append(pilot.cross_track_m)
            if len(distances) % 15 == 1:
                print(
                    f"{time.monotonic() - started:6.0f} s: {pilot.cross_track_m:+5.1f} m off the track, "
                    f"drift {math.hypot(*pilot.drift_mps):.2f} m/s",
                    flush=True,
                )
    finally:
        to_ship.close()
        from_ship.close()
    return distances


def _host_and_port(text: str) -> tuple[str, int]:
    host, _, port = text.rpartition(":")
    return host, int(port)


async def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--instruments", default="127.0.0.1:10110", help="where the server sends sentences")
    parser.add_argument("--orders", default="127.0.0.1:10111", help="where the server takes orders")
    parser.add_argument("--minutes", type=float, default=30.0, help="wall time [default: 30]")
    parser.add_argument("--pace", type=float, default=1.0, help="pace of the session [default: 1]")
    options = parser.parse_args()
    distances = await keep_track(options.instruments, options.orders, 60 * options.minutes, options.pace)
    print(f"farthest from the track: {max(map(abs, distances)):.1f} m")


if __name__ == "__main__":
    asyncio.run(main())
