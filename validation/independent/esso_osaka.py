#!/usr/bin/env python3
"""Low-speed hull forces of the Esso Osaka model of 3 m, written a second time, with sums over strips.

    python3 validation/independent/esso_osaka.py

The form and the coefficients are those of Miyauchi et al. (2022), as in the authors' public implementation. Prints
X/(½ρLdV²), Y/(½ρLdV²) and N/(½ρL²dV²), V² = u² + v² + (rL)², for the states of validation/low_speed.toml.
"""

import math

L, D = 3.0, 0.201
AHEAD, ASTERN, XVR = -0.0214, -0.0319, -0.0081
YV, YR, NV, NR = -0.3728, 0.116, -0.1458, -0.0485
CD, CRY, CRN = 0.9665, 2.217, 0.8097
STRIPS = 200_000


def coefficients(u, v, r):
    speed = math.hypot(u, v)
    beta = abs(math.atan2(-v, u))
    sway = yaw = 0.0
    for k in range(STRIPS):
        x = (k + 0.5) / STRIPS - 0.5
        wy, wn = v + CRY * r * L * x, v + CRN * r * L * x
        sway += wy * abs(wy) / STRIPS
        yaw += wn * abs(wn) * x / STRIPS
    scale = u * u + v * v + (r * L) ** 2
    return (
        ((AHEAD + (ASTERN - AHEAD) * beta / math.pi) * u * speed + XVR * v * r * L) / scale,
        (YV * v * abs(u) + YR * r * L * u - CD * sway) / scale,
        (NV * v * u + NR * r * L * abs(u) - CD * yaw) / scale,
    )


STATES = {"ahead": (0.2, -0.05, 0.03), "astern": (-0.15, 0.1, 0.08), "crabbing": (0.0, 0.2, -0.1)}

for name, state in STATES.items():
    print(name, *(f"{value:.6f}" for value in coefficients(*state)))
