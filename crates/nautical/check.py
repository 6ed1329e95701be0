"""Reads the output of `cargo run -p fenderline-nautical --example sentences` with independent parsers, two for each kind
of sentence, and compares the values with the input.

NMEA 0183: pynmea2 and pynmeagps. AIS: pyais and simpleais (`pip install pynmea2 pynmeagps pyais simpleais`).
"""

import json
import math
import sys

import pyais
import pynmea2
import simpleais
from pynmeagps import NMEAReader

KNOT_MPS = 1852 / 3600
ROUND = 360


def near(read, wanted, tolerance, what, turn=None):
    """Checks that a value is equal to within half of the sentence's last digit."""
    off = abs(float(read) - float(wanted))
    if turn:
        off = min(off % turn, turn - off % turn)
    assert off <= tolerance, f"{what}: {read} read, {wanted} expected"


def pynmea2_reads(line):
    """Kind and fields of a sentence, in the order of FIELDS."""
    m = pynmea2.parse(line, check=True)
    return m.sentence_type, {
        "HDT": lambda: [m.heading],
        "ROT": lambda: [m.rate_of_turn],
        "RMC": lambda: [m.status, str(m.datestamp), m.latitude, m.longitude, m.spd_over_grnd, m.true_course],
        "VTG": lambda: [m.true_track, m.spd_over_grnd_kts, m.spd_over_grnd_kmph],
        "VBW": lambda: [m.lon_water_spd, m.lon_grnd_spd, m.trans_grnd_spd],
        "MWV": lambda: [m.reference, m.wind_angle, m.wind_speed],
        "DPT": lambda: [m.depth, m.offset],
        "RSA": lambda: [m.rsa_starboard, m.rsa_starboard_status],
        "RPM": lambda: [m.speed],
    }[m.sentence_type]()


def pynmeagps_reads(line):
    """As `pynmea2_reads`."""
    m = NMEAReader.parse(line + "\r\n", validate=1)
    return m.msgID, {
        "HDT": lambda: [m.headingT],
        "ROT": lambda: [m.rot],
        "RMC": lambda: [m.status, str(m.date), m.lat, m.lon, m.spd, m.cog],
        "VTG": lambda: [m.cogt, m.sogn, m.sogk],
        "VBW": lambda: [m.longwaterspd, m.longgroundspd, m.transgroundspd],
        "MWV": lambda: [m.reference, m.angle, m.speed],
        "DPT": lambda: [m.depth, m.offset],
        "RSA": lambda: [m.stbdangle, m.stbdstatus],
        "RPM": lambda: [m.rpm],
    }[m.msgID]()


def expected(kind, values, reference):
    """The expected fields of a sentence: texts, or number, tolerance and, for an angle, the full turn."""
    knots = math.hypot(values["ahead"], values["across"]) / KNOT_MPS
    course = values["heading"] + math.degrees(math.atan2(values["across"], values["ahead"]))
    relative = reference == "R"
    return {
        "HDT": lambda: [(values["heading"], 0.051, ROUND)],
        "ROT": lambda: [(values["turn"], 0.051)],
        "RMC": lambda: ["A", "2026-11-21", (values["lat"], 1e-7), (values["lon"], 1e-7, ROUND), (knots, 0.0051),
                        (course, 0.051, ROUND)],
        "VTG": lambda: [(course, 0.051, ROUND), (knots, 0.0051), (knots * 1.852, 0.0051)],
        "VBW": lambda: [(values[key] / KNOT_MPS, 0.0051) for key in ("water", "ahead", "across")],
        "MWV": lambda: [reference, (values["wind" if relative else "true_wind"], 0.051, ROUND),
                        ((12.5 if relative else 10) / KNOT_MPS, 0.051)],
        "DPT": lambda: [(15, 0.051), (-9, 0.051)],
        "RSA": lambda: [(values["rudder"], 0.051), "A"],
        "RPM": lambda: [(values["rpm"], 0.051)],
    }[kind]()


def nmea(line, values):
    """Checks one sentence with both parsers."""
    for parser in (pynmea2_reads, pynmeagps_reads):
        kind, fields = parser(line)
        wanted = expected(kind, values, fields[0])
        assert len(fields) == len(wanted), line
        for read, want in zip(fields, wanted):
            if isinstance(want, str):
                assert read == want, f"{parser.__name__}: {read} read, {want} expected in {line}"
            else:
                near(read, *want[:2], f"{parser.__name__} {kind}", *want[2:])
    return kind


def ais(parts, values):
    """Checks one message of one or two sentences with both parsers."""
    (other,) = simpleais.parse_many(parts)
    for m in (pyais.decode(*parts).asdict(), other):
        kind = m["msg_type"] if isinstance(m, dict) else m["type"]
        assert str(m["mmsi"]).startswith("99900000"), m
        if kind == 1:
            near(m["lat"], values["lat"], 1e-6, "AIS latitude")
            near(m["lon"], values["lon"], 1e-6, "AIS longitude", ROUND)
            near(m["heading"], values["heading"], 0.51, "AIS heading", ROUND)
            course = values["heading"] + math.degrees(math.atan2(values["across"], values["ahead"]))
            near(m["course"], course, 0.051, "AIS course", ROUND)
            near(m["speed"], math.hypot(values["ahead"], values["across"]) / KNOT_MPS, 0.051, "AIS speed")
        else:
            assert kind == 5 and m["shipname"] == "CONTAINER SHIP, 298" and m["callsign"] == "FENDER", m
            assert [m[to] for to in ("to_bow", "to_stern", "to_port", "to_starboard")] == [150, 148, 23, 23], m
            assert m["draught"] == 9.0 and m["destination"] == "BERTH", m
    read = pyais.decode(*parts).asdict()
    if kind == 1:
        # The message has 4.733 sqrt(deg/min), rounded. pyais returns whole degrees per minute; simpleais does not square.
        sent = round(4.733 * math.sqrt(abs(values["turn"])))
        near(read["turn"], math.copysign((sent / 4.733) ** 2, values["turn"]), 0.501, "AIS turn")
    else:
        assert int(read["ship_type"]) == 70, read
    return f"AIS {kind}"


def main():
    read, values, parts = {}, None, []
    for line in sys.stdin.read().splitlines():
        if line.startswith("{"):
            values = json.loads(line)
            continue
        if line.startswith("$"):
            kind = nmea(line, values)
        else:
            parts.append(line)
            if len(parts) < int(line.split(",")[1]):
                continue
            kind, parts = ais(parts, values), []
        read[kind] = read.get(kind, 0) + 1
    wanted = {"HDT", "ROT", "RMC", "VTG", "VBW", "MWV", "DPT", "RSA", "RPM", "AIS 1", "AIS 5"}
    assert set(read) == wanted, wanted - set(read)
    print(f"{sum(read.values())} messages of {len(read)} kinds read correctly, each by two parsers: "
          "pynmea2 and pynmeagps, pyais and simpleais")


main()
