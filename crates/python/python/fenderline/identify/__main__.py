"""``python -m fenderline.identify``."""

from __future__ import annotations

import argparse
import sys

from fenderline._errors import Error
from fenderline.identify import BOUNDS, WORDS, IdentifyError, coefficients, identify


def main(arguments: list[str] | None = None) -> int:
    """Runs the command; returns its exit status: 0, 1 if the data tell none of the chosen coefficients, 2 for bad input."""
    parser = argparse.ArgumentParser(
        prog="python -m fenderline.identify",
        description="Fits coefficients of a vessel to measured tracks of trials or approaches, and refuses what the tracks cannot tell.",
        epilog=f"Words for groups of coefficients: {', '.join(WORDS)}.",
    )
    parser.add_argument("scenario", metavar="SCENARIO", help="the trial: a scenario with the vessel and the orders")
    parser.add_argument("tracks", nargs="*", metavar="TRACK", help="measured tracks (CSV): time, north and east or latitude and longitude, heading")
    parser.add_argument("--trial", nargs=2, action="append", default=[], metavar=("SCENARIO", "TRACK"), help="a further trial with orders of its own; may be repeated")
    parser.add_argument("--mapping", metavar="FILE", help="columns and units of the tracks (TOML)")
    parser.add_argument("--fit", nargs="+", action="extend", default=[], metavar="NAME", help="coefficients, as rudder.lift_gradient or 'rudder force'; NAME=LOW:HIGH bounds the factor, else 0.5 to 2")
    parser.add_argument("--list", action="store_true", help="print the coefficients of the vessel, and stop")
    parser.add_argument("--body", help="the body of the track, where the scenario has several vessels")
    parser.add_argument("--start", choices=("fit", "scenario"), default="fit", help="the state of the ship at time 0: fitted, or that of the scenario")
    parser.add_argument("--threads", type=int, default=2, metavar="N", help="threads for the runs (2)")
    parser.add_argument("--name", help="name of the fitted vessel; NAME-fitted if left out")
    parser.add_argument("-o", "--out", metavar="FILE", help="the vessel file to write (TOML)")
    parser.add_argument("--report", metavar="FILE", help="the report to write (HTML)")
    given = parser.parse_args(arguments)
    try:
        if given.list:
            for path, value in coefficients(given.scenario, given.body).items():
                print(f"{path} = {value}")
            return 0
        if not given.tracks and not given.trial:
            raise IdentifyError("give a track")
        scenarios = [given.scenario] * len(given.tracks) + [own for own, _ in given.trial]
        tracks = [*given.tracks, *(track for _, track in given.trial)]
        found = identify(scenarios, tracks, dict(map(_bounded, given.fit)), mapping=given.mapping, body=given.body, start=given.start, threads=given.threads)
        if given.out is not None:
            found.write(given.out, given.name)
        if given.report is not None:
            found.report(given.report)
    except (Error, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    for remark in found.remarks:
        print(f"note: {remark}", file=sys.stderr)
    print(found.table())
    return 0 if found.fitted else 1


def _bounded(text: str) -> tuple[str, tuple[float, float]]:
    name, is_bounded, bounds = text.partition("=")
    if not is_bounded:
        return name, BOUNDS
    try:
        low, high = (float(part) for part in bounds.split(":"))
    except ValueError:
        raise IdentifyError(f"the bounds of a factor are LOW:HIGH, as in {name}=0.8:1.2, but are {bounds!r}") from None
    return name, (low, high)


if __name__ == "__main__":
    sys.exit(main())
