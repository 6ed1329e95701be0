#!/usr/bin/env python3
"""A force provider for fenderline, in nothing but Python's own library.

fenderline starts this program, asks it once a step over its standard input, and puts what it answers on
the body: see scenarios/provider/drag_in_python.toml. One line of JSON a question, one line an answer.
This one is a current that runs north at 0.5 m/s and drags the ship with the square of the relative speed.
"""

import json
import math
import sys

CURRENT_NORTH_MPS = 0.5
DRAG_ALONG = 4.0e4  # N per (m/s)^2
DRAG_ACROSS = 8.0e5  # N per (m/s)^2


def answer(question):
    """The force in the ship's own axes, forward and to starboard."""
    heading = question["heading_rad"]
    # The water's velocity in the ship's axes.
    along = question["u_mps"] - CURRENT_NORTH_MPS * math.cos(heading)
    across = question["v_mps"] + CURRENT_NORTH_MPS * math.sin(heading)
    return {
        "n": question["n"],
        "body_force_n": [-DRAG_ALONG * along * abs(along), -DRAG_ACROSS * across * abs(across)],
        "moment_nm": 0.0,
    }


def main():
    hello = json.loads(sys.stdin.readline())
    assert hello["fenderline"] == 1, hello
    for line in sys.stdin:
        print(json.dumps(answer(json.loads(line))), flush=True)


if __name__ == "__main__":
    main()
