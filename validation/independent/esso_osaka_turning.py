#!/usr/bin/env python3
"""Turning circles of the Esso Osaka model of 3 m, written a second time.

    python3 validation/independent/esso_osaka_turning.py

Form and coefficients are those of Miyauchi et al. (2022), J. Mar. Sci. Technol. 27, read in the authors' public
implementation (github.com/NAOE-5thLab/mmg-1p1r-simulator): the initial parameters of their search, Fujii's rudder,
their wake in a turn. 10 revolutions per second, no wind, rudder over at once. Prints advance and tactical diameter
in lengths, U/U0, r' and the drift angle in degrees, for validation/esso_osaka.toml.
"""

import math

RHO, L, D = 998.0, 3.0, 0.20114
UNIT = 0.5 * RHO * L * L * D
M, MX, MY = 0.27078 * UNIT, 0.0467 * UNIT, 0.2579 * UNIT
INERTIA, XG = 0.0286 * UNIT * L * L, 0.03119 * L
AHEAD, ASTERN, XVR = -0.02139, -0.03189, -0.0081
YV, YR, NV, NR = -0.3728, 0.116, -0.1458, -0.04849
CD, CRY, CRN = 0.9665, 2.217, 0.8097
STRIPS = 200
PROPELLER, REVOLUTIONS = 0.084, 10.0
RUDDER, ASPECT = 0.01063, 1.539
EPSILON, KX = 1.42, 0.288


def cross_flow(v, r, gain, arm):
    total = 0.0
    for k in range(STRIPS):
        x = (k + 0.5) / STRIPS - 0.5
        w = v + gain * r * L * x
        total += w * abs(w) * (x if arm else 1.0) / STRIPS
    return total


def forces(u, v, r, rudder):
    speed = math.hypot(u, v)
    beta = math.atan2(-v, u)
    q = 0.5 * RHO * L * D
    x = q * ((AHEAD + (ASTERN - AHEAD) * abs(beta) / math.pi) * u * speed + XVR * v * r * L)
    y = q * (YV * v * abs(u) + YR * r * L * u - CD * cross_flow(v, r, CRY, False))
    n = q * L * (NV * v * u + NR * r * L * abs(u) - CD * cross_flow(v, r, CRN, True))
    at_propeller = (v - 0.517 * r * L) / speed
    left = 1.0 - (0.614 - 0.871 * abs(at_propeller) + 0.359 * at_propeller**2)
    advance = u * min(1.0, left)
    j = advance / (REVOLUTIONS * PROPELLER)
    kt = 0.3278 - 0.3323 * j - 0.156 * j * j
    x += (1 - 0.22) * RHO * REVOLUTIONS**2 * PROPELLER**4 * kt
    eta = PROPELLER / math.sqrt(RUDDER * ASPECT)
    race = math.sqrt(advance**2 + 8 * kt * (REVOLUTIONS * PROPELLER) ** 2 / math.pi) - advance
    ur = EPSILON * math.sqrt(eta * (advance + KX / EPSILON * race) ** 2 + (1 - eta) * advance**2)
    vr = -(0.3506 if v - 0.5 * L * r >= 0 else 0.4406) * (v - 1.08 * L * r)
    lift = 6.13 * ASPECT / (2.25 + ASPECT) * math.sin(rudder - math.atan2(vr, ur))
    normal = 0.5 * RHO * RUDDER * (ur * ur + vr * vr) * lift
    x -= (1 - 0.19) * normal * math.sin(rudder)
    y -= (1 + 0.393) * normal * math.cos(rudder)
    n -= (-0.5 - 0.393 * 0.45) * L * normal * math.cos(rudder)
    return x, y, n


def slope(state, rudder):
    _, _, heading, u, v, r = state
    x, y, n = forces(u, v, r, rudder)
    a, b, c = M + MY, XG * M, INERTIA + XG * XG * M
    right_y, right_n = y - (M + MX) * u * r, n - XG * M * u * r
    det = a * c - b * b
    return (
        u * math.cos(heading) - v * math.sin(heading),
        u * math.sin(heading) + v * math.cos(heading),
        r,
        (x + (M + MY) * v * r + XG * M * r * r) / (M + MX),
        (right_y * c - right_n * b) / det,
        (a * right_n - b * right_y) / det,
    )


def turn(degrees, step=0.05):
    u = 0.4
    for _ in range(4000):
        u += 0.1 * forces(u, 0.0, 0.0, 0.0)[0] / (M + MX)
    start, side, rudder = u, math.copysign(1.0, degrees), math.radians(degrees)
    state, marks = (0.0, 0.0, 0.0, u, 0.0, 0.0), []
    while abs(state[2]) < 4 * math.pi:
        before = state
        k1 = slope(state, rudder)
        k2 = slope([s + 0.5 * step * k for s, k in zip(state, k1)], rudder)
        k3 = slope([s + 0.5 * step * k for s, k in zip(state, k2)], rudder)
        k4 = slope([s + step * k for s, k in zip(state, k3)], rudder)
        state = tuple(
            s + step / 6 * (a + 2 * b + 2 * c + d) for s, a, b, c, d in zip(state, k1, k2, k3, k4)
        )
        for mark, place in ((math.pi / 2, 0), (math.pi, 1)):
            done = abs(state[2])
            if abs(before[2]) < mark <= done:
                share = (mark - abs(before[2])) / (done - abs(before[2]))
                marks.append((before[place] + share * (state[place] - before[place])) / L)
    _, _, _, u, v, r = state
    speed = math.hypot(u, v)
    return marks[0], side * marks[1], speed / start, abs(r) * L / speed, math.degrees(math.atan2(-v, u))


for rudder_deg in (35, -35, 20, -20):
    print(rudder_deg, *(f"{value:.3f}" for value in turn(rudder_deg)))
