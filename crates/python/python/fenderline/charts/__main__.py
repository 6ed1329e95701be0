"""``python -m fenderline.charts``."""

from __future__ import annotations

import argparse
import sys

from fenderline.charts import ChartError, convert


def main(arguments: list[str] | None = None) -> int:
    """Runs the command; returns its exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m fenderline.charts",
        description="Converts electronic charts (S-57), surveys (GeoTIFF, BAG, NetCDF) and currents (NetCDF, SELAFIN) to the files that a scenario names. Not for navigation.",
    )
    parser.add_argument("files", nargs="*", metavar="FILE", help="a cell (.000; its updates are applied), or a survey (.tif, .bag, .nc)")
    parser.add_argument("--area", metavar="W,S,E,N", help="what is cut out (degrees); write --area=-76.47,38.97,-76.43,39.00")
    parser.add_argument("-o", "--out", required=True, metavar="FOLDER", help="the folder to make")
    parser.add_argument("--origin", metavar="LAT,LON", help="origin of the scenario (degrees); the middle of the area if left out")
    parser.add_argument("--cell", type=float, metavar="METRES", help="side of a survey's cell; as in its file if left out")
    parser.add_argument("--crs", help="coordinate system of a survey whose file does not say it, such as EPSG:32618")
    parser.add_argument("--variable", help="variable of a NetCDF file")
    parser.add_argument("--current", metavar="FILE", help="current of a hydrodynamic model: NetCDF (regular, curvilinear, UGRID) or SELAFIN (.slf)")
    parser.add_argument("--current-variables", metavar="EAST,NORTH", help="names of the two components of the current, such as ubar,vbar")
    parser.add_argument("--current-axes", choices=("east", "grid"), help="of a curvilinear grid: components to the east and north, or along the grid")
    parser.add_argument("--current-layer", type=int, metavar="N", help="layer of a current by depth, from 0 in the order of the file")
    parser.add_argument("--current-start", metavar="TIME", help="time of the file that is time 0 of the scenario, such as 2026-05-01T06:00; the first if left out")
    parser.add_argument("--current-hours", type=float, metavar="HOURS", help="how long the current must cover from its start; all of the file if left out")
    parser.add_argument("--current-cell", type=float, metavar="METRES", help="distance of the nodes of the current; as in the model if left out")
    given = parser.parse_args(_joined(sys.argv[1:] if arguments is None else arguments))
    try:
        origin = None if given.origin is None else _origin(given.origin)
        converted = convert(
            given.files,
            given.out,
            area=given.area,
            origin=origin,
            cell_m=given.cell,
            crs=given.crs,
            variable=given.variable,
            current=given.current,
            current_variables=None if given.current_variables is None else tuple(name.strip() for name in given.current_variables.split(",")),
            current_axes=given.current_axes,
            current_layer=given.current_layer,
            current_start=given.current_start,
            current_hours=given.current_hours,
            current_cell_m=given.current_cell,
        )
    except ChartError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    print(converted)
    print(f"copy the tables of {converted.folder / 'chart.toml'} into a scenario in this folder")
    return 0


def _joined(arguments: list[str]) -> list[str]:
    """Western and southern values begin with a minus, which argparse takes for an option: the value is joined to its option."""
    joined: list[str] = []
    waits = False
    for argument in arguments:
        if waits:
            joined[-1] += "=" + argument
        else:
            joined.append(argument)
        waits = not waits and argument in ("--area", "--origin")
    return joined


def _origin(text: str) -> tuple[float, float]:
    try:
        latitude, longitude = (float(part) for part in text.split(","))
    except ValueError:
        raise ChartError(f"the origin is latitude, longitude in degrees, but is {text!r}") from None
    if not (abs(latitude) <= 84 and abs(longitude) <= 180):
        raise ChartError(f"the origin is latitude, longitude in degrees, but is {text!r}")
    return latitude, longitude


if __name__ == "__main__":
    sys.exit(main())
