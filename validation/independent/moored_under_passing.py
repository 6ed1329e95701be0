"""A ship on linear springs and dampers, passed by another one: motion in surge, sway and yaw.

    python3 validation/independent/moored_under_passing.py

prints time, surge, sway and yaw every 10 s: the reference of a test in crates/scenario/tests/passing.rs. Forces are the integrals of
Wang (1975) by Gauss's rule (passing_ships.py) at the place where the moored ship lies at rest; her motion is integrated by the classical
method of Runge and Kutta. It has nothing from the program, and no drag of the hull.
"""

from passing_ships import forces

KNOT = 1852.0 / 3600.0
DENSITY = 1025.0
LENGTHS = (243.5, 185.4)
AREAS = (0.98 * 39.0 * 15.3, 0.98 * 25.8 * 6.8)
SPEED = 10.0 * KNOT
ACROSS = -110.0  # to port
ABREAST = 150.0
MASS = (1e8 + 5e6, 1e8 + 8e7, 1e8 * (0.25 * 243.5) ** 2 + 3e11)
SPRING = (2e6, 2e6, 1.5e10)
DAMPER = (3e6, 5e6, 4e10)


def accelerations(t, state):
    unit = DENSITY * SPEED**2 * AREAS[0] * AREAS[1]
    along = SPEED * (t - ABREAST) - state[0]
    push = [unit * part for part in forces(LENGTHS[0], LENGTHS[1], along, ACROSS - state[1])]
    return [
        (push[i] - SPRING[i] * state[i] - DAMPER[i] * state[3 + i]) / MASS[i] for i in range(3)
    ]


def slope(t, state):
    return list(state[3:]) + accelerations(t, state)


def run(step=0.5, end=300.0, every=10.0):
    state, rows = [0.0] * 6, []
    for index in range(round(end / step) + 1):
        t = index * step
        if index % round(every / step) == 0:
            rows.append((t, *state[:3]))
        k1 = slope(t, state)
        k2 = slope(t + step / 2, [s + step / 2 * k for s, k in zip(state, k1)])
        k3 = slope(t + step / 2, [s + step / 2 * k for s, k in zip(state, k2)])
        k4 = slope(t + step, [s + step * k for s, k in zip(state, k3)])
        state = [
            s + step / 6 * (a + 2 * b + 2 * c + d)
            for s, a, b, c, d in zip(state, k1, k2, k3, k4)
        ]
    return rows


if __name__ == "__main__":
    for t, surge, sway, yaw in run():
        print(f"    [{t:.1f}, {surge:.6e}, {sway:.6e}, {yaw:.6e}],")
