"""What a client of a live session sees: ships by name, wind, alarms."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

Json = Mapping[str, Any]


@dataclass(frozen=True)
class Setting:
    """An order and what it has come to: a rudder's angle (rad), or a share of full revolutions or of full thrust."""

    order: float
    now: float


class Ship:
    """A vessel of a frame."""

    def __init__(self, info: Json, now: Json, body: list[float] | None) -> None:
        self.info = info
        """What does not change: the vessel's ``VesselInfo`` of the protocol."""
        self.raw = now
        """The vessel's ``VesselNow`` of the protocol."""
        self._body = body

    @property
    def name(self) -> str:
        """Name in the scenario."""
        return str(self.info["name"])

    @property
    def is_seen(self) -> bool:
        """False if fog hides the vessel: she has no place then."""
        return self._body is not None

    def _state(self, index: int) -> float:
        return math.nan if self._body is None else self._body[index]

    @property
    def position_m(self) -> tuple[float, float]:
        """Centre of gravity, north and east of the scenario's origin (m); NaN in fog."""
        return self._state(0), self._state(1)

    @property
    def heading_rad(self) -> float:
        """Heading from north, clockwise, from 0 up to 2π (rad); NaN in fog."""
        return self._state(2) % (2 * math.pi)

    @property
    def velocity_mps(self) -> tuple[float, float]:
        """Velocity over ground, north and east (m/s); NaN in fog."""
        return self._state(3), self._state(4)

    @property
    def turn_radps(self) -> float:
        """Rate of turn, positive to starboard (rad/s); NaN in fog."""
        return self._state(5)

    @property
    def speed_over_ground_mps(self) -> float:
        """Speed over ground (m/s); NaN in fog."""
        return math.hypot(*self.velocity_mps)

    @property
    def course_over_ground_rad(self) -> float:
        """Course over ground, from 0 up to 2π (rad); NaN in fog."""
        north, east = self.velocity_mps
        return math.atan2(east, north) % (2 * math.pi)

    @property
    def water_mps(self) -> tuple[float, float]:
        """Velocity through the water, ahead and to starboard (m/s)."""
        ahead, starboard = self.raw["water_mps"]
        return float(ahead), float(starboard)

    @property
    def rudder(self) -> Setting:
        """Rudder angle (rad), positive to starboard."""
        return Setting(self.raw["rudder"]["order_rad"], self.raw["rudder"]["now_rad"])

    @property
    def engine(self) -> Setting:
        """Revolutions over full revolutions, from −1 to 1."""
        return Setting(self.raw["shaft"]["order"], self.raw["shaft"]["now"])

    @property
    def thrusters(self) -> dict[str, Setting]:
        """Tunnel thrusters by name, each from −1 (to port) to 1 (to starboard)."""
        pairs = zip(self.info["thrusters"], self.raw["thrusters"], strict=True)
        return {str(info["name"]): Setting(now["order"], now["now"]) for info, now in pairs}

    @property
    def pilot(self) -> str:
        """Mode of steering: ``hands``, ``course``, ``speed``, ``course+speed``, ``station`` or ``assist``."""
        return str(self.raw["pilot"])

    @property
    def course_order_rad(self) -> float | None:
        """The heading that the ship's own course pilot keeps (rad)."""
        value = self.raw["course_rad"]
        return None if value is None else float(value)

    @property
    def length_m(self) -> float:
        """Length (m)."""
        return float(self.info["length_m"])


class Frame:
    """The state of a session at one step."""

    def __init__(self, hello: Json, raw: Json, own: str | None, reconnected: bool) -> None:
        self.raw = raw
        """The message ``frame`` of the protocol."""
        self.reconnected = reconnected
        """True for the first frame that the client gives after the connection was lost and came back."""
        self._hello = hello
        self._own = own

    @property
    def tick(self) -> int:
        """Number of steps since the start."""
        return int(self.raw["tick"])

    @property
    def t_s(self) -> float:
        """Simulated time (s)."""
        return float(self.raw["t_s"])

    @property
    def paused(self) -> bool:
        """True while the session is paused."""
        return bool(self.raw["run"]["paused"])

    @property
    def pace(self) -> float:
        """Simulated time over wall time."""
        return float(self.raw["run"]["pace"])

    @cached_property
    def ships(self) -> dict[str, Ship]:
        """All vessels, by name."""
        vessels = zip(self._hello["vessels"], self.raw["vessels"], strict=True)
        ships = (Ship(info, now, self.raw["bodies"][info["body"]]) for info, now in vessels)
        return {ship.name: ship for ship in ships}

    @property
    def ship(self) -> Ship:
        """The client's own vessel.

        :raises KeyError: The link belongs to no vessel, and none was named.
        """
        if self._own is None:
            raise KeyError("this client has no vessel: name one with `vessel=`")
        return self.ships[self._own]

    @property
    def wind_mps(self) -> tuple[float, float]:
        """Speed of the true wind (m/s), and the direction from which it comes (rad)."""
        return float(self.raw["wind"]["speed_mps"]), float(self.raw["wind"]["from_rad"])

    @property
    def current_mps(self) -> tuple[float, float]:
        """Speed of the current (m/s), and the direction to which it sets (rad)."""
        return float(self.raw["current"]["speed_mps"]), float(self.raw["current"]["to_rad"])

    @property
    def alarms(self) -> list[str]:
        """The texts of the alarms and cautions that stand."""
        return [str(alarm["text"]) for alarm in self.raw["alarms"] if alarm["stands"]]

    @property
    def events(self) -> list[tuple[float, str]]:
        """Events since the last frame that the server sent: time (s) and text."""
        return [(float(event["t_s"]), str(event["text"])) for event in self.raw["events"]]
