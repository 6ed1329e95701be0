"""Charts by PROJ: the points of scenarios/live/harbour.geojson in metres, and places all over the earth.

    python validation/independent/chart_projection.py           compares with the files of chart_projection/
    python validation/independent/chart_projection.py make      computes these files again

It needs pyproj from PyPI (made with 3.7.2, which has PROJ 9.5.1). PROJ's `+proj=etmerc` is Poder and Engsager's algorithm, written
by others than ours; `crates/scenario/tests/chart_projection.rs` compares the program with the files.
"""

import csv
import io
import json
import pathlib
import sys

from pyproj import Transformer

HERE = pathlib.Path(__file__).parent
HARBOUR = HERE / "../../scenarios/live/harbour.geojson"
ORIGIN = (54.02, 8.02)

# Origins (latitude, longitude), and steps from them (degrees): harbours in both hemispheres, near the date line, far north.
ORIGINS = [(54.02, 8.02), (-33.87, 151.2), (1.26, 103.8), (0.0, 0.0), (-16.9, 179.97), (69.65, 18.95), (83.0, -40.0)]
STEPS = [(0.0, 0.0), (0.01, 0.0), (0.0, 0.01), (-0.2, 0.3), (0.7, -0.8), (-1.0, -1.0)]


def projected(proj, origin, places):
    """North and east of the origin (m) of places (latitude, longitude)."""
    to = Transformer.from_crs("+proj=longlat +ellps=WGS84", proj, always_xy=True)
    east_0, north_0 = to.transform(origin[1], origin[0])
    for latitude, longitude in places:
        east, north = to.transform(longitude, latitude)
        yield north - north_0, east - east_0


def through(origin):
    """Transverse Mercator through the origin."""
    return f"+proj=etmerc +lat_0={origin[0]} +lon_0={origin[1]} +k=1 +x_0=0 +y_0=0 +ellps=WGS84 +units=m"


def utm(origin):
    """UTM in the zone of 6 degrees, without the exceptions for Norway and Svalbard: PROJ has none if the zone is given."""
    meridian = origin[1] // 6 * 6 + 3
    return f"+proj=etmerc +lat_0=0 +lon_0={meridian} +k=0.9996 +x_0=500000 +y_0=0 +ellps=WGS84 +units=m"


def flat(coordinates):
    """The positions of nested lists, in their order."""
    if isinstance(coordinates[0], float):
        yield coordinates[1], coordinates[0]
    else:
        for inner in coordinates:
            yield from flat(inner)


def table(columns, rows):
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows(rows)
    return out.getvalue()


def harbour():
    features = json.loads(HARBOUR.read_text(encoding="utf-8"))["features"]
    rows = []
    for number, feature in enumerate(features, 1):
        places = list(flat(feature["geometry"]["coordinates"]))
        for (latitude, longitude), (north, east) in zip(places, projected(through(ORIGIN), ORIGIN, places)):
            rows.append([number, f"{latitude:.8f}", f"{longitude:.8f}", f"{north:.6f}", f"{east:.6f}"])
    return table(["feature", "latitude_deg", "longitude_deg", "north_m", "east_m"], rows)


def places():
    rows = []
    for origin in ORIGINS:
        around = [(origin[0] + north, (origin[1] + east + 180) % 360 - 180) for north, east in STEPS]
        for name, proj in [("transverse_mercator", through(origin)), ("utm", utm(origin))]:
            for (latitude, longitude), (north, east) in zip(around, projected(proj, origin, around)):
                given = [f"{value:.8f}" for value in (*origin, latitude, longitude)]
                rows.append([name, *given, f"{north:.6f}", f"{east:.6f}"])
    columns = ["projection", "origin_latitude_deg", "origin_longitude_deg", "latitude_deg", "longitude_deg"]
    return table([*columns, "north_m", "east_m"], rows)


def main():
    folder = HERE / "chart_projection"
    made = {"harbour.csv": harbour(), "places.csv": places()}
    if sys.argv[1:] == ["make"]:
        folder.mkdir(exist_ok=True)
        for name, text in made.items():
            (folder / name).write_text(text, encoding="utf-8", newline="\n")
        return
    for name, text in made.items():
        kept = list(csv.reader(io.StringIO((folder / name).read_text(encoding="utf-8"))))
        now = list(csv.reader(io.StringIO(text)))
        if len(kept) != len(now):
            sys.exit(f"{name}: {len(kept)} rows are kept, but there are {len(now)} now")
        off = max(abs(float(a) - float(b)) for one, two in zip(kept[1:], now[1:]) for a, b in zip(one[-2:], two[-2:]))
        # Other versions of PROJ may differ in the last bits.
        if off > 1e-5:
            sys.exit(f"{name}: the kept numbers differ by {off} m")
        print(f"{name}: {len(now) - 1} points as kept, to {off:g} m")


main()
