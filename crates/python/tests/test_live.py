"""The client of live sessions against the program, and the examples that steer from outside."""

import asyncio
import math
import os
import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import fenderline
import pytest

pytest.importorskip("websockets", reason="websockets is not installed: pip install 'fenderline[live]'")

from fenderline import live  # noqa: E402
from fenderline.live import Client  # noqa: E402

NOBODY = "http://127.0.0.1:9/?token=" + 32 * "0"


def program() -> str:
    found = os.environ.get("FENDERLINE_PROGRAM")
    if found is None:
        pytest.skip("FENDERLINE_PROGRAM does not say where the program `fenderline` is")
    return found


class Server:
    """A running server and its links by role."""

    def __init__(self, process: "subprocess.Popen[str]") -> None:
        self.process = process
        self.links: dict[str, str] = {}
        assert process.stdout is not None
        for line in process.stdout:
            if match := re.match(r"\s*(\S.*?)\s+(http://\S+)\s*$", line):
                self.links[match[1]] = match[2]
            if "Recorded to" in line:
                self.recording = line.split("Recorded to ")[1].strip()
                return
        raise AssertionError("the server did not start")


@contextmanager
def served(scenario: Path, sessions: Path) -> Iterator[Server]:
    command = [program(), "serve", str(scenario), "--port", "0", "--sessions", str(sessions)]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    try:
        yield Server(process)
    finally:
        process.kill()
        process.wait()
        assert process.stdout is not None
        process.stdout.close()


@pytest.fixture
def server(scenarios: Path, tmp_path: Path) -> Iterator[Server]:
    with served(scenarios / "berth" / "alongside_with_two_tugs.toml", tmp_path) as running:
        yield running


def test_the_version_of_the_protocol_is_the_servers(root: Path) -> None:
    pages = root / "web" / "src" / "protocol.ts"
    if not pages.exists():
        pytest.skip("the sources of the pages are not here")
    found = re.search(r"export const PROTOCOL = (\d+);", pages.read_text("utf-8"))
    assert found is not None and int(found[1]) == live.PROTOCOL


@pytest.mark.parametrize(
    "link", ["", "harbour", "http://127.0.0.1:8090/", "ftp://127.0.0.1/?token=a", "http:///?token=a"]
)
def test_what_is_no_link_is_refused(link: str) -> None:
    with pytest.raises(live.LinkError, match="no link"):
        Client.connect(link)


def test_a_bad_patience_is_refused() -> None:
    with pytest.raises(fenderline.ArgumentError, match="patience_s"):
        Client.connect(NOBODY, patience_s=math.nan)


def test_without_the_library_the_error_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "websockets.asyncio.client", None)
    with pytest.raises(ImportError, match=r"fenderline\[live\]"):
        Client.connect(NOBODY)


def test_no_server_and_a_wrong_token(server: Server) -> None:
    async def enter(link: str) -> None:
        async with Client.connect(link, patience_s=0):
            pass

    with pytest.raises(live.DisconnectedError, match="does not answer"):
        asyncio.run(enter(NOBODY))
    wrong = re.sub("token=.*", "token=" + 32 * "0", server.links["pilot"])
    with pytest.raises(live.LinkError, match="not valid"):
        asyncio.run(enter(wrong))


def test_another_version_of_the_protocol(server: Server, monkeypatch: pytest.MonkeyPatch) -> None:
    version = live.PROTOCOL
    monkeypatch.setattr(live, "PROTOCOL", version - 1)

    async def enter() -> None:
        async with Client.connect(server.links["pilot"]):
            pass

    with pytest.raises(live.ProtocolError) as caught:
        asyncio.run(enter())
    assert (caught.value.server, caught.value.client) == (version, version - 1)


async def frame_with(ship: Client, wanted: Callable[[live.Frame], bool]) -> live.Frame:
    async with asyncio.timeout(20):
        async for frame in ship:
            if wanted(frame):
                return frame
    raise AssertionError


def test_orders_reach_the_ship_and_frames_show_her(server: Server) -> None:
    async def steer() -> None:
        async with Client.connect(server.links["pilot"], name="autopilot") as ship:
            assert (ship.role, ship.vessel, ship.has_helm) == ("pilot", "ship", False)
            await ship.take_helm()
            await ship.rudder(0.1)
            await ship.engine(-0.25)
            await ship.thruster("bow", 0.5)
            tick = await ship.tug("forward", "push", power=0.25)
            frame = await frame_with(ship, lambda frame: frame.tick > tick)
            assert ship.has_helm
            own = frame.ship
            assert own.rudder.order == 0.1 and own.engine.order == -0.25
            assert own.thrusters["bow"].order == 0.5
            assert own.pilot == "hands"
            north, east = own.position_m
            assert abs(north + 700) < 20 and abs(east + 60) < 5
            assert own.speed_over_ground_mps == pytest.approx(math.hypot(*own.velocity_mps))
            assert 0 <= own.heading_rad < 2 * math.pi and own.is_seen
            assert frame.wind_mps[0] > 0 and frame.current_mps[0] == pytest.approx(0.3)
            await ship.course(1.0)
            await ship.speed(3.0)
            await ship.give([{"do": "hands", "vessel": "ship"}, {"do": "engine", "vessel": "ship", "share": 0.1}])
            frame = await frame_with(ship, lambda frame: frame.ship.engine.order == 0.1)
            await ship.release_helm()
            await frame_with(ship, lambda frame: not ship.has_helm)

    asyncio.run(steer())


def test_refusals_are_errors_with_the_servers_words(server: Server) -> None:
    async def steer() -> None:
        async with (
            Client.connect(server.links["pilot"], name="one") as one,
            Client.connect(server.links["pilot"], name="two") as two,
            Client.connect(server.links["observer"], vessel="ship") as observer,
        ):
            await one.take_helm()
            with pytest.raises(live.HelmError, match="one"):
                await two.take_helm()
            with pytest.raises(live.HelmError, match="one"):
                await two.rudder(0.1)
            with pytest.raises(live.RoleError, match="observer"):
                await observer.rudder(0.1)
            with pytest.raises(live.RoleError, match="link"):
                await observer.take_helm()
            with pytest.raises(live.RoleError, match="only the instructor"):
                await one.pause()
            with pytest.raises(live.RefusedError, match="no thruster `none`"):
                await one.thruster("none", 0.1)
            with pytest.raises(live.RefusedError, match="between -1 and 1"):
                await one.engine(2.0)
            with pytest.raises(fenderline.ArgumentError, match="finite"):
                await one.rudder(math.nan)
            with pytest.raises(live.RefusedError):
                await one.command({"do": "fly"})
            # It still steers.
            await one.rudder(0.05)

    asyncio.run(steer())


def test_a_person_takes_the_helm_from_a_client_in_one_press(server: Server) -> None:
    async def steer() -> None:
        async with (
            Client.connect(server.links["pilot"], name="autopilot") as ship,
            Client.connect(server.links["pilot"], name="Anna", person=True) as person,
        ):
            await ship.take_helm()
            await person.take_helm()
            tick = await person.rudder(0.2)
            with pytest.raises(live.HelmError, match="Anna"):
                await ship.rudder(-0.2)
            frame = await frame_with(ship, lambda frame: frame.tick > tick)
            assert frame.ship.rudder.order == 0.2 and not ship.has_helm
            with pytest.raises(live.HelmError, match="Anna"):
                await ship.take_helm()
            assert any("has taken the control from you" in text for text in ship.notices)
            await person.release_helm()
            await ship.take_helm()

    asyncio.run(steer())


def test_a_client_that_orders_too_fast_is_slowed_down_and_a_slow_one_gets_the_latest(
    server: Server,
) -> None:
    async def steer() -> None:
        async with Client.connect(server.links["pilot"]) as ship:
            first = await ship.frame()
            for number in range(100):
                await ship.rudder(0.001 * number)
            assert not any(text.startswith("refused") for text in ship.notices)
            await asyncio.sleep(1.0)
            frame = await ship.frame()
            assert frame.tick > first.tick + 5
            assert frame.ship.rudder.order == pytest.approx(0.099)
            # The one after it is newer.
            assert (await ship.frame()).tick > frame.tick

    asyncio.run(steer())


def test_the_end_of_the_session_ends_the_frames(server: Server) -> None:
    async def steer() -> None:
        async with Client.connect(server.links["pilot"], patience_s=0.5) as ship:
            await ship.frame()
            server.process.kill()
            with pytest.raises(live.DisconnectedError):
                async for _ in ship:
                    pass
            with pytest.raises(live.DisconnectedError):
                await ship.rudder(0.1)

    asyncio.run(steer())


def test_a_client_comes_back_and_takes_the_helm_again(server: Server) -> None:
    async def steer() -> None:
        async with Client.connect(server.links["pilot"], name="autopilot") as ship:
            await ship.take_helm()
            await ship.frame()
            assert ship._socket is not None
            ship._socket.transport.abort()
            # The program is busy for longer than the reconnection takes: the first frames afterwards are skipped.
            await asyncio.sleep(2.0)
            await frame_with(ship, lambda frame: frame.reconnected)
            assert not (await ship.frame()).reconnected
            await frame_with(ship, lambda frame: ship.has_helm)
            await ship.rudder(0.1)

    asyncio.run(steer())


def test_another_scenario_is_told(server: Server) -> None:
    async def steer() -> None:
        async with (
            Client.connect(server.links["instructor"]) as instructor,
            Client.connect(server.links["pilot"]) as ship,
        ):
            await ship.frame()
            others = [entry["file"] for entry in instructor.hello["gallery"]]
            other = next(name for name in others if name.startswith("single_tug") or name != instructor.hello["file"])
            await instructor.command({"do": "load", "file": other})
            with pytest.raises(live.SessionChangedError):
                async with asyncio.timeout(60):
                    async for _ in ship:
                        pass

    asyncio.run(steer())


EXAMPLES: list[tuple[list[str], str]] = [
    (["track", "--by", "client", "--pace", "20", "--minutes", "2"], "track by client"),
    (["track", "--by", "nmea", "--pace", "4", "--minutes", "0.5"], "track by nmea"),
    (["station", "--pace", "20", "--minutes", "2"], "station"),
]


@pytest.mark.parametrize(("arguments", "said"), EXAMPLES, ids=lambda of: str(of))
def test_the_examples_that_steer(root: Path, arguments: list[str], said: str) -> None:
    example = root / "examples" / "python" / "steering" / "measured.py"
    command = [sys.executable, str(example), *arguments, "--program", program()]
    ran = subprocess.run(command, capture_output=True, text=True, timeout=300)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert said in ran.stdout and "m off" in ran.stdout


def test_the_track_of_the_example(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(root / "examples" / "python" / "steering"))
    import track

    line = track.Track([(0, 0), (3000, 0), (5719, 1268), (8719, 1268), (14357, -784)], 1500.0)
    places = line.polyline(50.0)
    following = track.Track([(0, 0), (3000, 0), (5719, 1268), (8719, 1268), (14357, -784)], 1500.0)
    # Along the track, places are on it; the courses turn by the angles of the plan.
    for place in places:
        assert abs(following.beside(place)[1]) < 1e-6
    assert math.degrees(following.course_at(following.length_m)) == pytest.approx(-20.0, abs=0.1)
    # A place 10 m to starboard of a leg and of a turn to starboard.
    fresh = track.Track([(0, 0), (1000, 0), (1000, 1000)], 300.0)
    assert fresh.beside((100, 10))[1] == pytest.approx(10)
    # Outside of the turn is to port.
    middle = (700 + 310 * math.sin(math.pi / 4), 300 - 310 * math.cos(math.pi / 4))
    assert fresh.beside(middle)[1] == pytest.approx(-10)
    assert fresh.curvature_at(fresh.beside(middle)[0]) == pytest.approx(1 / 300)
