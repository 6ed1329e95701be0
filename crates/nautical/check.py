"""Reads what `cargo run -p fenderline-nautical --example sentences` prints with two parsers that we did not write,
pynmea2 and pyais, and holds what they read against the numbers that went in. Needs both (`pip install pynmea2 pyais`)."""

import json
import math
import sys

import pyais
import pynmea2

KNOT_MPS = 1852 / 3600


def near(ours, theirs, tolerance, what, turn=None):
    off = abs(float(ours) - float(theirs))
    if turn:
        off = min(off % turn, turn - off % turn)
    assert off <= tolerance, f"{what}: {ours} beside {theirs}"


def nmea(line, said):
    """One sentence; tolerances are half of the last digit that it has."""
    m = pynmea2.parse(line, check=True)
    speed = math.hypot(said["ahead"], said["across"]) / KNOT_MPS
    course = said["heading"] + math.degrees(math.atan2(said["across"], said["ahead"]))
    kind = m.sentence_type
    if kind == "HDT":
        near(m.heading, said["heading"], 0.051, kind, 360)
    elif kind == "ROT":
        near(m.rate_of_turn, said["turn"], 0.051, kind)
    elif kind == "RMC":
        assert m.is_valid and str(m.datestamp) == "2026-11-21", line
        near(m.latitude, said["lat"], 1e-7, kind)
        near(m.longitude, said["lon"], 1e-7, kind, 360)
        near(m.spd_over_grnd, speed, 0.0051, kind)
        near(m.true_course, course, 0.051, kind, 360)
    elif kind == "VTG":
        near(m.true_track, course, 0.051, kind, 360)
        near(m.spd_over_grnd_kts, speed, 0.0051, kind)
        near(m.spd_over_grnd_kmph, speed * 1.852, 0.0051, kind)
    elif kind == "VBW":
        near(m.lon_water_spd, said["water"] / KNOT_MPS, 0.0051, kind)
        near(m.lon_grnd_spd, said["ahead"] / KNOT_MPS, 0.0051, kind)
        near(m.trans_grnd_spd, said["across"] / KNOT_MPS, 0.0051, kind)
    elif kind == "MWV":
        near(m.wind_angle, said["wind" if m.reference == "R" else "true_wind"], 0.051, kind, 360)
        near(m.wind_speed, (12.5 if m.reference == "R" else 10) / KNOT_MPS, 0.051, kind)
    elif kind == "DPT":
        near(m.depth, 15, 0.051, kind)
        near(m.offset, -9, 0.051, kind)
    elif kind == "RSA":
        near(m.rsa_starboard, said["rudder"], 0.051, kind)
        assert m.rsa_starboard_status == "A", line
    elif kind == "RPM":
        near(m.speed, said["rpm"], 0.051, kind)
    else:
        raise AssertionError(f"not looked at: {line}")
    return kind


def ais(parts, said):
    """One message of one or two sentences."""
    m = pyais.decode(*parts).asdict()
    if m["msg_type"] == 1:
        near(m["lat"], said["lat"], 1e-6, "AIS latitude")
        near(m["lon"], said["lon"], 1e-6, "AIS longitude", 360)
        near(m["heading"], said["heading"], 0.51, "AIS heading", 360)
        near(m["course"], said["heading"] + math.degrees(math.atan2(said["across"], said["ahead"])), 0.051,
             "AIS course", 360)
        near(m["speed"], math.hypot(said["ahead"], said["across"]) / KNOT_MPS, 0.051, "AIS speed")
        # What is sent is 4.733 sqrt(deg/min), rounded; pyais gives back whole degrees a minute.
        sent = round(4.733 * math.sqrt(abs(said["turn"])))
        near(m["turn"], math.copysign((sent / 4.733) ** 2, said["turn"]), 0.501, "AIS turn")
    else:
        assert m["msg_type"] == 5 and m["shipname"] == "CONTAINER SHIP, 298" and m["callsign"] == "FENDER", m
        assert (m["to_bow"], m["to_stern"], m["to_port"], m["to_starboard"]) == (150, 148, 23, 23), m
        assert m["draught"] == 9.0 and m["destination"] == "BERTH" and int(m["ship_type"]) == 70, m
    return f"AIS {m['msg_type']}"


def main():
    read, said, parts = {}, None, []
    for line in sys.stdin.read().splitlines():
        if line.startswith("{"):
            said = json.loads(line)
            continue
        if line.startswith("$"):
            kind = nmea(line, said)
        else:
            parts.append(line)
            if len(parts) < int(line.split(",")[1]):
                continue
            kind, parts = ais(parts, said), []
        read[kind] = read.get(kind, 0) + 1
    wanted = {"HDT", "ROT", "RMC", "VTG", "VBW", "MWV", "DPT", "RSA", "RPM", "AIS 1", "AIS 5"}
    assert set(read) == wanted, wanted - set(read)
    print(f"{sum(read.values())} messages of {len(read)} kinds read by pynmea2 and pyais as they were meant")


main()
