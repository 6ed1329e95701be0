"""Makes up the logs of this folder: three docking logs of different layouts, an NMEA 0183 log and an AIS log.

Run `python3 examples/measured/make_logs.py` in the folder of the sources; it needs no package. The ship is that of
berth.toml. She comes to the fenders with a speed that falls towards the touch, and comes to rest on them.
Noise, rounding, pauses and wrong readings are drawn with fixed seeds, so the script writes the same bytes every time.
"""

import datetime
import math
import pathlib
import random

HERE = pathlib.Path(__file__).parent
# Of berth.toml, in the axes of the berth: hull (forward, towards the quay), fenders along the quay.
HULL = [(92, 0), (86, 6.5), (74, 12.5), (58, 15), (-68, 15), (-84, 13.5), (-93, 9)]
FENDERS = [-36, -12, 12, 36]
HALF_WIDTH = 1.2
# The faces of the fenders stand 1.9 m in front of the quay, which runs north; the water is west of it.
FACES_EAST = -1.9
ORIGIN = (51.95, 4.05)
FEET = 1 / 0.3048


def hull_off(pose, along):
    """Distance of the hull from the line of the fenders at a place along the quay; None beyond her ends."""
    s, off, angle = pose
    sin, cos = math.sin(angle), math.cos(angle)
    at = [(s + x * cos - y * sin, off - x * sin - y * cos) for x, y in HULL]
    for (x0, y0), (x1, y1) in zip(at, at[1:]):
        if min(x0, x1) <= along <= max(x0, x1) and x0 != x1:
            return y0 + (along - x0) / (x1 - x0) * (y1 - y0)
    return None


def gap(pose):
    ends = [f + side * HALF_WIDTH for f in FENDERS for side in (-1, 1)]
    return min(off for off in (hull_off(pose, end) for end in ends) if off is not None)


def approach(off_m, first_mps, touch_mps, angle_deg, turn_deg_per_min, along_mps, after_s, place_m=0.0, step_s=0.1):
    """Poses every 0.1 s, and the index of the touch."""
    s, angle = place_m, math.radians(angle_deg)
    pose = (s, 15.0 + off_m, angle)
    whole = gap(pose)
    poses, touch, speed = [pose], None, first_mps
    turn = math.radians(turn_deg_per_min) / 60
    while touch is None or len(poses) < touch + after_s / step_s:
        s, off, angle = poses[-1]
        left = gap(poses[-1])
        if touch is None and left <= 0:
            touch = len(poses) - 1
        if touch is None:
            # She slows down towards the touch as a ship does that is stopped by tugs.
            share = max(left, 0) / whole
            speed = touch_mps + (first_mps - touch_mps) * share
        else:
            # Onto the fenders: parallel to the quay and 6 cm into the rubber.
            speed += step_s * (0.0225 * (off - 14.94) - 0.3 * speed)
            turn -= step_s * (0.0225 * angle + 0.3 * turn)
            along_mps *= 1 - 0.05 * step_s
        poses.append((s + along_mps * step_s, off - speed * step_s, angle + turn * step_s))
    return poses, touch


def number(value, decimals, comma=False):
    text = f"{value:.{decimals}f}"
    return text.replace(".", ",") if comma else text


def speeds(poses, index, places):
    before, after = poses[max(index - 10, 0)], poses[min(index + 10, len(poses) - 1)]
    span = 0.1 * (min(index + 10, len(poses) - 1) - max(index - 10, 0))
    return [((hull_off(before, p) or 0) - (hull_off(after, p) or 0)) / span for p in places]


def laser():
    """Layout 1: commas, metres and cm/s, names of columns with their units, local time, angle."""
    draw = random.Random(1)
    lines = ["Timestamp,Ship,Dist Bow (m),Dist Stern (m),Speed Bow (cm/s),Speed Stern (cm/s),Angle (deg),Tide (m)"]
    berthings = [
        ("2025-05-03 06:12:00", "Made Up Star", (12, 0.16, 0.085, 1.2, -0.2, 0.01), 0.9),
        ("2025-05-05 21:40:00", "Made Up Star", (14, 0.20, 0.120, -1.8, 0.3, -0.02), 1.4),
        ("2025-05-09 13:05:00", "Second Ship", (10, 0.15, 0.062, 0.4, 0.1, 0.0), 0.3),
        ("2025-05-12 02:31:00", "Made Up Star", (15, 0.24, 0.152, 2.6, -0.4, 0.02), 1.1),
        ("2025-05-17 17:55:00", "Second Ship", (11, 0.18, 0.104, -0.9, 0.0, 0.01), 0.6),
    ]
    for start, ship, course, tide in berthings:
        poses, touch = approach(*course, after_s=90)
        begin = datetime.datetime.fromisoformat(start)
        for index in range(0, len(poses), 10):
            # A pause of the link in the second berthing, some seconds before the touch.
            if "21:40" in start and 150 < touch - index < 240:
                continue
            bow, stern = (hull_off(poses[index], p) for p in (45, -45))
            v = speeds(poses, index, (45, -45))
            angle = math.degrees(math.atan((stern - bow) / 90))
            cells = [bow + draw.gauss(0, 0.01), stern + draw.gauss(0, 0.01)]
            if draw.random() < 0.004:
                cells[draw.randrange(2)] += draw.uniform(2, 6)
            at = begin + datetime.timedelta(seconds=index / 10)
            lines.append(
                f"{at},{ship},{cells[0]:.2f},{cells[1]:.2f},{100 * v[0]:.0f},{100 * v[1]:.0f},{angle:.1f},{tide}"
            )
    (HERE / "laser.csv").write_text("\n".join(lines) + "\n")


def feet():
    """Layout 2: semicolons and decimal commas, feet, day first, `---` for a lost hull; the sensors show their own
    readings, 2.4 m behind the faces. The days are out of order."""
    draw = random.Random(2)
    lines = ["Datum;Uhrzeit;Bug A (ft);Heck B (ft);vA (ft/min);vB (ft/min)"]
    for start, course in [
        ("2025-06-14 08:20:00", (9, 0.14, 0.070, 0.8, 0.0, 0.0)),
        ("2025-06-11 19:45:00", (12, 0.21, 0.110, -1.1, 0.2, 0.01)),
        ("2025-06-21 04:02:00", (10, 0.17, 0.095, 1.9, -0.3, 0.0)),
    ]:
        poses, touch = approach(*course, after_s=60, place_m=-4)
        begin = datetime.datetime.fromisoformat(start)
        for index in range(0, len(poses), 10):
            at = begin + datetime.timedelta(seconds=index / 10)
            cells = []
            for place in (38, -52):
                off = (hull_off(poses[index], place) + 2.4 + draw.gauss(0, 0.012)) * FEET
                is_lost = draw.random() < 0.06
                cells.append("---" if is_lost else number(off, 2, comma=True))
            v = [number(60 * speed * FEET, 0) for speed in speeds(poses, index, (38, -52))]
            lines.append(f"{at:%d.%m.%Y};{at:%H:%M:%S};{cells[0]};{cells[1]};{v[0]};{v[1]}")
    (HERE / "feet.csv").write_text("\n".join(lines) + "\n")


def portable():
    """Layout 3: tabs, centimetres and knots, month first, two rows a second, the place along the quay measured too."""
    draw = random.Random(3)
    lines = ["Date\tClock\tSensor 2 [cm]\tSensor 1 [cm]\tS2 [kn]\tS1 [kn]\tOffset [m]\tPilot"]
    for start, pilot, course, place in [
        ("2025-07-14 11:30:00", "A", (8, 0.13, 0.075, -0.5, 0.1, 0.03), 2.0),
        ("2025-07-15 23:57:30", "B", (9, 0.19, 0.135, 1.4, -0.2, 0.05), -3.0),
    ]:
        poses, _ = approach(*course, after_s=60, place_m=place)
        begin = datetime.datetime.fromisoformat(start)
        for index in range(0, len(poses), 5):
            at = begin + datetime.timedelta(seconds=index / 10)
            off = [hull_off(poses[index], p) + draw.gauss(0, 0.008) for p in (50, -35)]
            v = [speed * 3600 / 1852 for speed in speeds(poses, index, (50, -35))]
            along = poses[index][0] + draw.gauss(0, 0.1)
            clock = f"{at:%H:%M:%S}.{at.microsecond // 100000}"
            lines.append(
                f"{at:%m/%d/%Y}\t{clock}\t{100 * off[0]:.0f}\t{100 * off[1]:.0f}\t{v[0]:.2f}\t{v[1]:.2f}\t{along:.1f}\t{pilot}"
            )
    (HERE / "portable.tsv").write_text("\n".join(lines) + "\n")


def degrees_per_metre():
    """Degrees of latitude and longitude of a metre at the origin, on WGS 84."""
    latitude = math.radians(ORIGIN[0])
    e2 = (2 - 1 / 298.257223563) / 298.257223563
    below = 1 - e2 * math.sin(latitude) ** 2
    along = 6378137 * (1 - e2) / below**1.5
    across = 6378137 / below**0.5 * math.cos(latitude)
    return math.degrees(1 / along), math.degrees(1 / across)


def antenna(pose, forward, starboard):
    """Latitude and longitude of an antenna on board, and the heading: the quay runs north, starboard side to."""
    s, off, angle = pose
    sin, cos = math.sin(angle), math.cos(angle)
    north = s + forward * cos - starboard * sin
    east = FACES_EAST - off + forward * sin + starboard * cos
    per_north, per_east = degrees_per_metre()
    return north, east, per_north, per_east, math.degrees(angle) % 360


def sentence(start, body):
    total = 0
    for character in body:
        total ^= ord(character)
    return f"{start}{body}*{total:02X}"


def in_minutes(value, width, sides):
    side = sides[0] if value >= 0 else sides[1]
    degrees, minutes = divmod(abs(value) * 60, 60)
    return f"{int(degrees):0{width}d}{minutes:010.7f},{side}"


def nmea():
    """Sentences of a portable unit with two antennas and corrections: RMC, GGA, HDT, ROT and VTG, once a second."""
    draw = random.Random(4)
    poses, _ = approach(14, 0.22, 0.11, 1.6, -0.25, 0.04, after_s=80, place_m=1.5)
    begin = datetime.datetime(2025, 8, 2, 9, 14, 0)
    lines = []
    for index in range(0, len(poses), 10):
        at = begin + datetime.timedelta(seconds=index / 10)
        north, east, per_north, per_east, heading = antenna(poses[index], -70, 3)
        latitude = ORIGIN[0] + (north + draw.gauss(0, 0.015)) * per_north
        longitude = ORIGIN[1] + (east + draw.gauss(0, 0.015)) * per_east
        other = poses[min(index + 10, len(poses) - 1)]
        turn = math.degrees(other[2] - poses[index][2]) * 60
        place = f"{in_minutes(latitude, 2, 'NS')},{in_minutes(longitude, 3, 'EW')}"
        clock = f"{at:%H%M%S}.00"
        lines.append(sentence("$", f"GPRMC,{clock},A,{place},0.2,270.0,{at:%d%m%y},,,R"))
        lines.append(sentence("$", f"GPGGA,{clock},{place},4,14,0.7,12.0,M,45.0,M,1.0,0001"))
        lines.append(sentence("$", f"HEHDT,{(heading + draw.gauss(0, 0.02)) % 360:.2f},T"))
        lines.append(sentence("$", f"TIROT,{turn:.1f},A"))
        lines.append(sentence("$", "GPVTG,270.0,T,,M,0.20,N,0.37,K,R"))
    # A line that was cut.
    lines[57] = lines[57][:9]
    (HERE / "pilot_unit.nmea").write_text("\r\n".join(lines) + "\r\n")


def armoured(bits):
    bits += "0" * (-len(bits) % 6)
    values = [int(bits[i : i + 6], 2) for i in range(0, len(bits), 6)]
    return "".join(chr(v + 48 if v < 40 else v + 56) for v in values)


def field(value, width):
    return format(value & ((1 << width) - 1), f"0{width}b")


def text_field(text, letters):
    codes = [ord(c) - 64 if c >= "@" else ord(c) for c in text.ljust(letters, "@")]
    return "".join(field(c, 6) for c in codes)


def position_report(mmsi, latitude, longitude, speed_kn, course, heading, second):
    return (
        field(1, 6) + field(0, 2) + field(mmsi, 30) + field(0, 4) + field(-128, 8) + field(round(speed_kn * 10), 10)
        + field(1, 1) + field(round(longitude * 600000), 28) + field(round(latitude * 600000), 27)
        + field(round(course * 10) % 3600, 12) + field(round(heading) % 360, 9) + field(second, 6) + field(0, 25)
    )


def static_data(mmsi, name, kind, extent, draught):
    bits = field(5, 6) + field(0, 2) + field(mmsi, 30) + field(0, 2) + field(0, 30) + text_field("MADEUP", 7)
    bits += text_field(name, 20) + field(kind, 8) + field(extent[0], 9) + field(extent[1], 9) + field(extent[2], 6)
    return bits + field(extent[3], 6) + field(1, 4) + field(0, 20) + field(round(draught * 10), 8) + text_field("", 20) + "00"


def ais():
    """Reports of an AIS receiver, each with the time of the logger: the ship every 10 s, and a tug that works at her."""
    draw = random.Random(5)
    poses, touch = approach(60, 0.45, 0.13, 1.0, 0.0, 0.02, after_s=900)
    begin = datetime.datetime(2025, 9, 7, 4, 40, 0)
    lines = []

    def add(at, bits):
        letters = armoured(bits)
        parts = [letters[i : i + 56] for i in range(0, len(letters), 56)]
        for number_of, part in enumerate(parts, 1):
            sequence = "3" if len(parts) > 1 else ""
            fill = (-len(bits) % 6) if number_of == len(parts) else 0
            body = f"AIVDM,{len(parts)},{number_of},{sequence},A,{part},{fill}"
            lines.append(f"{at:%Y-%m-%dT%H:%M:%SZ} " + sentence("!", body))

    # The receiver sees the ship 2.5 m from where she is, and its error wanders.
    error = [2.0, -1.5]
    for index in range(0, len(poses), 100):
        at = begin + datetime.timedelta(seconds=index / 10)
        error = [e + draw.gauss(0, 0.08) for e in error]
        north, east, per_north, per_east, heading = antenna(poses[index], -70, 0)
        latitude = ORIGIN[0] + (north + error[0] + draw.gauss(0, 0.15)) * per_north
        longitude = ORIGIN[1] + (east + error[1] + draw.gauss(0, 0.15)) * per_east
        ahead = poses[min(index + 10, len(poses) - 1)]
        speed_kn = math.hypot(ahead[0] - poses[index][0], ahead[1] - poses[index][1]) * 3600 / 1852
        if index % 3000 == 0:
            add(at, static_data(244000123, "MADE UP STAR", 70, (162, 23, 15, 15), 10.5))
            add(at, static_data(244000456, "MADE UP TUG", 52, (12, 18, 6, 6), 5.0))
        add(at, position_report(244000123, latitude, longitude, speed_kn, 90, heading, at.second))
        add(at, position_report(244000456, latitude + 20 * per_north, longitude - 40 * per_east, 0.4, 90, 95, at.second))
    (HERE / "ais.nmea").write_text("\n".join(lines) + "\n")


laser()
feet()
portable()
nmea()
ais()
