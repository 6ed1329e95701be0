#!/usr/bin/env python3
"""Open-water propellers a second time: the first quadrant by another fit, all four by a plain sum.

    python3 validation/independent/propeller_quadrants.py

Prints K_T and K_Q of the Wageningen B4-70 propellers by the polynomials of Oosterveld & van Oossanen (1975) as Bernitsas,
Ray & Kinley (1981) print them, taken from public programs that agree; and C_T* and C_Q* of the four-quadrant series in
crates/ship/src/hydro/propeller_series.rs, term by term with cosines and sines: the engine sums by recurrences.
"""

import math
import re
from pathlib import Path

# Powers of J, P/D, A_E/A_0 and Z, and the coefficient.
KT = """
0 0 0 0 .00880496  0 0 0 1 .0144043  0 0 0 2 -.000606848  0 0 1 1 -.0125894  0 0 1 2 .000690904  0 0 2 0 -.0507214
0 1 0 0 .166351  0 1 0 1 .0143481  0 2 0 0 .158114  0 2 1 0 .415437  0 2 2 1 -.00410798  0 3 0 0 -.133698
0 3 0 1 -.00841728  0 3 1 1 -.0317791  0 3 1 2 .00421749  0 3 2 2 -.00146564  0 6 0 0 .00638407  1 0 0 0 -.204554
1 0 0 2 -.0049819  1 0 1 1 .0109689  1 0 2 1 .018604  1 1 0 1 .0606826  1 1 1 0 -.481497  1 2 0 2 -.00163652
1 3 0 1 .0168424  1 6 0 2 -.000328787  1 6 2 0 .010465  2 0 0 1 -.0530054  2 0 0 2 .0025983  2 0 1 0 -.147581
2 0 2 0 .0854559  2 6 0 0 -.00132718  2 6 0 2 .000116502  2 6 2 0 -.00648272  3 0 0 2 -.000560528  3 0 1 0 .168496
3 0 2 0 -.0504475  3 3 0 1 -.00102296  3 6 1 2 .0000565229
"""
KQ = """
0 0 0 0 .00379368  0 0 2 0 .015896  0 0 2 2 -.0001843  0 1 0 1 .00513696  0 1 1 0 -.0408811  0 1 2 0 -.0502782
0 2 0 0 .00344778  0 2 1 0 .188561  0 2 1 1 -.0269403  0 2 1 2 .00155334  0 2 2 1 .0126803  0 3 1 0 .0161886
0 3 2 0 -.0397722  0 3 2 2 -.000425399  0 6 0 1 -.000313912  0 6 1 1 -.00142121  0 6 1 2 .000302683
0 6 2 0 -.00350024  0 6 2 1 .00334268  0 6 2 2 -.0004659  1 0 0 1 -.00370871  1 0 1 2 .000269551  1 0 2 0 .0471729
1 0 2 1 -.00383637  1 1 0 0 -.032241  1 1 0 1 .0209449  1 1 0 2 -.00183491  1 1 1 0 -.108009  1 1 1 1 .00438388
1 3 1 0 .00318086  1 6 2 2 .0000554194  2 0 0 0 .00886523  2 0 1 1 -.00723408  2 0 1 2 .00083265  2 1 0 1 .00474319
2 1 1 0 -.0885381  2 2 2 0 .0417122  2 3 2 1 -.00318278  3 0 0 1 -.0106854  3 0 1 0 .0558082  3 0 1 1 .0035985
3 0 2 0 .0196283  3 1 2 0 -.030055  3 2 0 2 .000112451  3 3 0 1 .00110903  3 3 2 2 .0000869243  3 6 0 2 -.0000297228
"""
AREA_RATIO, BLADES = 0.7, 4
SERIES = Path(__file__).parents[2] / "crates/ship/src/hydro/propeller_series.rs"


def polynomial(table, advance, pitch):
    numbers = [float(word) for word in table.split()]
    rows = [numbers[i : i + 5] for i in range(0, len(numbers), 5)]
    return sum(c * advance**j * pitch**p * AREA_RATIO**a * BLADES**z for j, p, a, z, c in rows)


def harmonics(pitch):
    name = f"B4_70_PITCH_{pitch:.1f}".replace(".", "_")
    body = SERIES.read_text().split(f"static {name}: Harmonics = [")[1].split("];")[0]
    return [[float(word) for word in row.split(",")] for row in re.findall(r"\[([^\]]+)\]", body)]


def quadrants(rows, degrees):
    beta = math.radians(degrees)
    thrust = sum(a * math.cos(k * beta) + b * math.sin(k * beta) for k, (a, b, _, _) in enumerate(rows)) / 100
    torque = sum(a * math.cos(k * beta) + b * math.sin(k * beta) for k, (_, _, a, b) in enumerate(rows)) / -1000
    return thrust, torque


for pitch in (0.8, 1.0):
    for advance in (0.0, 0.4, 0.8):
        print(f"P/D {pitch} J {advance}: K_T {polynomial(KT, advance, pitch):.4f} K_Q {polynomial(KQ, advance, pitch):.5f}")
    for degrees in (90, 150, 210, 330):
        print(f"P/D {pitch} beta {degrees}: C_T {{:.4f}} C_Q {{:.5f}}".format(*quadrants(harmonics(pitch), degrees)))
