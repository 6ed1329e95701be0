"""Steering a live session of ``fenderline serve`` from Python.

The server prints a link for each role. A client connects by the link, reads frames and gives orders::

    import asyncio
    from math import radians
    from fenderline.live import Client

    async def main():
        async with Client.connect("http://127.0.0.1:8090/?token=...", name="autopilot") as ship:
            await ship.take_helm()
            await ship.engine(0.5)
            async for frame in ship:
                if frame.t_s > 600:
                    break
                await ship.rudder(-(frame.ship.heading_rad - radians(10)))

    asyncio.run(main())

People take the helm from a client in one press. Orders then raise :class:`HelmError` until the person releases the
helm. If a client goes away, the helm is free and the last order stands. ``pip install "fenderline[live]"`` installs the
library `websockets <https://websockets.readthedocs.io>`_, which the client needs. The guide *Steering from outside* has
examples; the guide *The protocol* lists all messages.
"""

from __future__ import annotations

import asyncio
import json
import math
import time
from collections.abc import Mapping, Sequence
from types import TracebackType
from typing import TYPE_CHECKING, Any, Self
from urllib.parse import parse_qs, urlsplit

from fenderline._errors import ArgumentError
from fenderline._live_errors import (
    DisconnectedError,
    FullError,
    HelmError,
    LinkError,
    LiveError,
    ProtocolError,
    RefusedError,
    RoleError,
    SessionChangedError,
)
from fenderline._live_frames import Frame, Setting, Ship

if TYPE_CHECKING:
    from websockets.asyncio.client import ClientConnection

__all__ = [
    "PROTOCOL",
    "Client",
    "DisconnectedError",
    "Frame",
    "FullError",
    "HelmError",
    "LinkError",
    "LiveError",
    "ProtocolError",
    "RefusedError",
    "RoleError",
    "SessionChangedError",
    "Setting",
    "Ship",
]

PROTOCOL = 9
"""Version of the protocol that this package speaks."""

_NO_TOKEN, _FULL = 4401, 4429
"""Close codes of the server: an unknown token, and no seat that is free."""
_LARGEST_MESSAGE = 64 << 20
_ANSWER_S = 10.0
_COMMANDS_PER_S = 25.0
"""The server takes 30 commands a second of a client; the client waits before it sends more than this."""
_BURST = 40.0
_OTHERS_HAVE_IT = ("holds this control", "has this control")
_NOT_ITS_OWN = ("does not open", "commands that", "gives no commands", "only the instructor")


def _library() -> Any:
    try:
        import websockets.asyncio.client
    except ImportError as error:
        raise ImportError(
            "fenderline.live needs the library websockets, 15 or later: pip install 'fenderline[live]'"
        ) from error
    return websockets


def _address(link: str, person: bool) -> str:
    """The address of the websocket that belongs to a link."""
    parts = urlsplit(link)
    schemes = {"http": "ws", "https": "wss", "ws": "ws", "wss": "wss"}
    token = parse_qs(parts.query).get("token", [""])[0]
    if parts.scheme not in schemes or not parts.netloc or not token:
        raise LinkError(f"{link!r} is no link as `fenderline serve` prints it: http://HOST:PORT/?token=...")
    return f"{schemes[parts.scheme]}://{parts.netloc}/live?token={token}{'' if person else '&program=1'}"


def _own_vessel(hello: Mapping[str, Any]) -> str | None:
    """The vessel of a role: the pilot's ship, or the tug master's tug if she is a vessel."""
    role, vessels = hello["role"], hello["vessels"]
    names = [str(vessel["name"]) for vessel in vessels]
    if role["name"] == "tugmaster":
        return role["tug"] if role["tug"] in names else None
    if role.get("vessel") is not None:
        return str(role["vessel"])
    ships = [str(vessel["name"]) for vessel in vessels if not vessel["is_tug"]]
    return next(iter(ships or names), None)


class Client:
    """A client that steers a vessel of a live session; see :meth:`Client.connect`.

    ``async for frame in client`` gives the latest frame each time. Frames that come while the program is busy are
    skipped, all but the latest.
    """

    def __init__(self, url: str, name: str | None, vessel: str | None, patience_s: float) -> None:
        self._url = url
        self._name = name
        self._named_vessel = vessel
        self._patience_s = patience_s
        self._socket: ClientConnection | None = None
        self._reader: asyncio.Task[None] | None = None
        self._changed = asyncio.Condition()
        self._hello: dict[str, Any] = {}
        self._scenario: tuple[Any, ...] | None = None
        self._frame: Frame | None = None
        self._given: Frame | None = None
        self._failure: LiveError | None = None
        self._waiting: dict[int, asyncio.Future[int]] = {}
        self._next_id = 1
        self._wants_helm = False
        self._reconnected = False
        self._tokens, self._at = _BURST, time.monotonic()
        self.notices: list[str] = []
        """The server's notices so far, such as who has joined and who has taken the helm; at most the last 100."""

    @classmethod
    def connect(
        cls,
        link: str,
        *,
        name: str | None = None,
        vessel: str | None = None,
        person: bool = False,
        patience_s: float = 30.0,
    ) -> Client:
        """A client for ``async with``.

        :param link: The link of a role, as ``fenderline serve`` prints it. The link of the pilot steers the ship; the
            link of the instructor also pauses and sets the pace.
        :param name: Name of the program on the pages of the other people.
        :param vessel: Name of the vessel that the orders go to. Without it, the vessel of the role.
        :param person: True for a program by which a person steers, such as a joystick: it takes the helm from other
            programs, and a person must release it before another person takes it.
        :param patience_s: Time for which a lost connection is tried again (s); 0: not at all.
        :raises LinkError: The link is no link, or the server does not know its token.
        :raises DisconnectedError: The server does not answer.
        :raises FullError: The server has no seat free.
        :raises ProtocolError: The server speaks another version of the protocol.
        :raises ImportError: The library ``websockets`` is missing.
        """
        _library()
        if not (math.isfinite(patience_s) and patience_s >= 0):
            raise ArgumentError(f"patience_s must be a time from 0, but is {patience_s}")
        return cls(_address(link, person), name, vessel, patience_s)

    async def __aenter__(self) -> Self:
        await self._open()
        self._reader = asyncio.create_task(self._read())
        try:
            await self._introduce()
        except BaseException:
            await self._close()
            raise
        return self

    async def __aexit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        await self._close()

    def __aiter__(self) -> Self:
        return self

    async def __anext__(self) -> Frame:
        return await self.frame()

    # What the client sees.

    async def frame(self) -> Frame:
        """The latest frame that was not given before; waits for it.

        :raises DisconnectedError: The connection has ended.
        :raises SessionChangedError: Another scenario was opened.
        """
        async with self._changed:
            await self._changed.wait_for(
                lambda: self._failure is not None or self._frame is not self._given
            )
            if self._frame is not None and self._frame is not self._given:
                self._given = self._frame
                return self._frame
            assert self._failure is not None
            raise self._failure

    @property
    def hello(self) -> Mapping[str, Any]:
        """The message ``hello`` of the protocol: everything that frames do not repeat."""
        return self._hello

    @property
    def title(self) -> str:
        """Title of the scenario."""
        return str(self._hello["title"])

    @property
    def role(self) -> str:
        """The role of the link: ``instructor``, ``pilot``, ``tugmaster`` or ``observer``."""
        return str(self._hello["role"]["name"])

    @property
    def vessel(self) -> str:
        """Name of the vessel to which the orders go.

        :raises RoleError: The link belongs to no vessel, and none was named.
        """
        vessel = self._named_vessel or _own_vessel(self._hello)
        if vessel is None:
            raise RoleError("this link belongs to no vessel: name one with `vessel=`")
        return vessel

    @property
    def has_helm(self) -> bool:
        """True while this client holds the helm of its vessel. It is false once a person has taken the helm."""
        control = {"vessel": self.vessel}
        claims = (claim for claim in self._hello["claims"] if claim["control"] == control)
        is_held = any(claim["holder"] is not None and claim["connected"] for claim in claims)
        return is_held and control in self._hello["mine"]

    # The helm.

    async def take_helm(self) -> None:
        """Takes the helm of the vessel.

        :raises HelmError: Somebody holds the helm.
        :raises RoleError: The link does not open this helm.
        """
        await self.command({"do": "claim", "control": {"vessel": self.vessel}})
        self._wants_helm = True

    async def release_helm(self) -> None:
        """Gives the helm back; the last orders stand."""
        self._wants_helm = False
        await self.command({"do": "release", "control": {"vessel": self.vessel}})

    # Orders. Each returns the step at which the order takes effect.

    async def rudder(self, angle_rad: float) -> int:
        """Puts the rudder to an angle (rad), positive to starboard."""
        return await self._order("rudder", angle_rad=angle_rad)

    async def engine(self, share: float) -> int:
        """Sets the engine's revolutions over full revolutions, from −1 to 1."""
        return await self._order("engine", share=share)

    async def thruster(self, name: str, power: float) -> int:
        """Sets a tunnel thruster to a share of its thrust, from −1 (to port) to 1 (to starboard)."""
        return await self._order("thruster", name=name, power=power)

    async def azimuth(
        self, name: str, *, power: float | None = None, direction_rad: float | None = None
    ) -> int:
        """Sets an azimuth unit's thrust, from 0 to 1, and the direction of its thrust from the bow (rad)."""
        return await self._order("azimuth", name=name, power=power, direction_rad=direction_rad)

    async def course(self, heading_rad: float) -> int:
        """Lets the ship's own pilot keep a heading (rad)."""
        return await self._order("course", heading_rad=heading_rad)

    async def speed(self, speed_mps: float) -> int:
        """Lets the ship's own pilot keep a speed ahead through the water (m/s)."""
        return await self._order("speed", speed_mps=speed_mps)

    async def hands(self) -> int:
        """Switches the ship's own pilots off; rudder and engine stay as they are."""
        return await self._order("hands")

    async def tug(
        self,
        name: str,
        order: str,
        *,
        power: float | None = None,
        lead: str | None = None,
        place: str | None = None,
    ) -> int:
        """Orders a tug in words: ``push``, ``pull``, ``stop`` or ``stand_off``, with a share of her bollard pull.

        ``lead`` and ``place`` are words of the protocol, such as ``square`` and ``shoulder``.
        """
        action = {"do": "tug", "tug": name, "order": order, "power": power, "lead": lead, "place": place}
        return await self.command({key: value for key, value in action.items() if value is not None})

    async def give(self, orders: Sequence[Mapping[str, Any]]) -> int:
        """Gives several orders of the protocol at once: all of them or none."""
        return await self.command({"do": "give", "orders": list(orders)})

    # Time; for the instructor's link.

    async def pause(self) -> None:
        """Stops the simulated time."""
        await self.command({"do": "pause"})

    async def resume(self) -> None:
        """Lets the simulated time go on."""
        await self.command({"do": "resume"})

    async def pace(self, pace: float) -> None:
        """Sets simulated time over wall time, from 0.1 to 20."""
        await self.command({"do": "pace", "pace": pace})

    async def command(self, action: Mapping[str, Any]) -> int:
        """Sends any command of the protocol. Returns the step at which it takes effect.

        :raises ArgumentError: A number is not finite.
        :raises RefusedError: The server refuses the command; :class:`HelmError` and :class:`RoleError` are such errors.
        :raises DisconnectedError: The connection broke before the answer came.
        """
        if self._failure is not None:
            raise self._failure
        number, self._next_id = self._next_id, self._next_id + 1
        try:
            text = json.dumps({"type": "command", "id": number, "action": action}, allow_nan=False)
        except ValueError as error:
            raise ArgumentError(f"a command has finite numbers: {error}") from error
        await self._keep_rate()
        if self._socket is None:
            raise DisconnectedError("there is no connection to the server at the moment")
        answer = asyncio.get_running_loop().create_future()
        self._waiting[number] = answer
        try:
            await self._socket.send(text)
            return await asyncio.wait_for(answer, _ANSWER_S)
        except TimeoutError:
            raise DisconnectedError(f"the server did not answer within {_ANSWER_S:.0f} s") from None
        except _library().exceptions.ConnectionClosed as closed:
            raise DisconnectedError(f"the connection broke: {closed}") from closed
        finally:
            self._waiting.pop(number, None)

    async def _order(self, word: str, **arguments: Any) -> int:
        return await self.command({"do": word, "vessel": self.vessel, **arguments})

    async def _keep_rate(self) -> None:
        now = time.monotonic()
        self._tokens = min(self._tokens + (now - self._at) * _COMMANDS_PER_S, _BURST)
        self._at = now
        self._tokens -= 1
        if self._tokens < 0:
            await asyncio.sleep(-self._tokens / _COMMANDS_PER_S)

    # The connection.

    async def _open(self) -> None:
        """Opens the websocket and reads the greeting."""
        library = _library()
        try:
            # No proxy: the link names the server itself.
            socket = await library.asyncio.client.connect(
                self._url, max_size=_LARGEST_MESSAGE, compression=None, proxy=None
            )
        except (OSError, TimeoutError, library.exceptions.WebSocketException) as error:
            raise DisconnectedError(f"the server does not answer: {error}") from error
        try:
            hello = json.loads(await asyncio.wait_for(socket.recv(), _ANSWER_S))
            if hello.get("protocol") != PROTOCOL:
                raise ProtocolError(int(hello.get("protocol", 0)), PROTOCOL)
            self._greeted(hello)
        except BaseException as error:
            await socket.close()
            if isinstance(error, library.exceptions.ConnectionClosed):
                raise _why_closed(error) from error
            if isinstance(error, TimeoutError):
                raise DisconnectedError("the server does not greet") from error
            raise
        self._socket = socket

    async def _introduce(self) -> None:
        if self._name is not None:
            await self.command({"do": "name", "name": self._name})

    async def _close(self) -> None:
        if self._reader is not None:
            self._reader.cancel()
            await asyncio.gather(self._reader, return_exceptions=True)
        if self._socket is not None:
            await self._socket.close()
        await self._fail(DisconnectedError("the client is closed"))

    async def _read(self) -> None:
        """Reads messages for as long as there is a connection, and connects again."""
        closed_errors = _library().exceptions.ConnectionClosed
        while self._failure is None:
            assert self._socket is not None
            try:
                async for text in self._socket:
                    await self._heard(json.loads(text))
                why: LiveError = DisconnectedError("the server has ended the connection")
            except closed_errors as closed:
                why = _why_closed(closed)
            except LiveError as error:
                why = error
            except (ValueError, KeyError, TypeError) as error:
                why = LiveError(f"the server sent what is not understood: {error!r}")
            broken, self._socket = self._socket, None
            await broken.close()
            self._answer_all(DisconnectedError("the connection broke before an answer came"))
            if type(why) is not DisconnectedError or not await self._again(why):
                await self._fail(why)

    async def _again(self, why: LiveError) -> bool:
        """Connects again after the connection has broken; false if that fails for too long."""
        until, wait_s = time.monotonic() + self._patience_s, 0.4
        while time.monotonic() < until:
            await asyncio.sleep(wait_s)
            wait_s = min(2 * wait_s, 4.0)
            try:
                await self._open()
            except DisconnectedError:
                continue
            except LiveError as error:
                await self._fail(error)
                return True
            self._reconnected = True
            asyncio.get_running_loop().create_task(self._return_to_helm())
            return True
        return False

    async def _return_to_helm(self) -> None:
        """Gives the name again after a reconnection, and takes the helm again if nobody else has it."""
        try:
            await self._introduce()
            if self._wants_helm:
                await self.take_helm()
        except LiveError as error:
            self._note(f"after the reconnection: {error}")

    def _note(self, text: str) -> None:
        self.notices.append(text)
        del self.notices[:-100]

    def _greeted(self, hello: dict[str, Any]) -> None:
        names = tuple(vessel["name"] for vessel in hello["vessels"])
        scenario = (hello["file"], hello["title"], names)
        if self._scenario not in (None, scenario):
            raise SessionChangedError(f"another session was opened: {hello['title']}")
        self._scenario, self._hello = scenario, hello

    async def _heard(self, message: dict[str, Any]) -> None:
        match message["type"]:
            case "frame":
                own = self._named_vessel or _own_vessel(self._hello)
                # A frame that nobody has read yet hands its mark on to the frame that takes its place.
                skipped = self._frame is not self._given and self._frame is not None and self._frame.reconnected
                frame = Frame(self._hello, message, own, self._reconnected or skipped)
                self._reconnected = False
                async with self._changed:
                    self._frame = frame
                    self._changed.notify_all()
            case "hello":
                self._greeted(message)
            case "ack":
                self._answer(message["id"], message["tick"])
            case "refused":
                if message["id"] is None:
                    self._note(f"refused: {message['reason']}")
                else:
                    self._answer(message["id"], _refusal(message["reason"]))
            case "notice":
                self._note(message["text"])
            case _:
                pass

    def _answer(self, number: int, answer: int | LiveError) -> None:
        waiting = self._waiting.get(number)
        if waiting is None or waiting.done():
            return
        if isinstance(answer, LiveError):
            waiting.set_exception(answer)
        else:
            waiting.set_result(answer)

    def _answer_all(self, error: LiveError) -> None:
        for number in list(self._waiting):
            self._answer(number, error)

    async def _fail(self, error: LiveError) -> None:
        self._answer_all(error)
        async with self._changed:
            self._failure = self._failure or error
            self._changed.notify_all()


def _refusal(reason: str) -> RefusedError:
    if any(words in reason for words in _OTHERS_HAVE_IT):
        return HelmError(reason)
    if any(words in reason for words in _NOT_ITS_OWN):
        return RoleError(reason)
    return RefusedError(reason)


def _why_closed(closed: Any) -> LiveError:
    """The error of a connection that the server has closed, by its code."""
    code, reason = (closed.rcvd.code, closed.rcvd.reason) if closed.rcvd is not None else (None, "")
    if code == _NO_TOKEN:
        return LinkError(reason)
    if code == _FULL:
        return FullError(reason)
    return DisconnectedError(f"the server has ended the connection: {reason or closed}")
