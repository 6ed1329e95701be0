"""Systems of ships and the engine, shared by the tests with masters."""

from dataclasses import dataclass, field

# Variables of the ship FMU, and those of the engine that they connect to.
STATE = ["x_m", "y_m", "heading_rad", "velocity_x_mps", "velocity_y_mps", "r_radps"]
WRENCH = {"contact_x_n": "force_x_n", "contact_y_n": "force_y_n", "contact_moment_nm": "moment_z_nm"}


@dataclass
class System:
    """Ships by the names of their bodies, each with the parameters of its FMU."""

    scenario: str
    ships: dict
    step_s: float
    until_s: float
    options: list = field(default_factory=list)


def inertia(mass_kg, gyradius_m, surge, sway, yaw):
    """Mass and added mass, the latter as shares of mass and moment of inertia, as in scenarios."""
    moment = mass_kg * gyradius_m**2
    return {"surge_kg": mass_kg * (1 + surge), "sway_kg": mass_kg * (1 + sway), "yaw_kgm2": moment * (1 + yaw)}


CONTAINER_SHIP = inertia(87.8e6, 74.5, 0.031, 0.506, 0.72)
TUG = inertia(930e3, 8.0, 0.086, 0.84, 0.40)

IMPACT = System(
    "scenarios/paper/experiment_2_4kn.toml",
    {
        "ship": CONTAINER_SHIP,
        "tug": TUG | {"start_y_m": -41.0, "start_heading_rad": 1.5707963267948966, "start_u_mps": 4 * 1852 / 3600},
    },
    0.1,
    20.0,
    ["--method", "coupled", "--set", "time.integrator=semi_implicit"],
)
BERTHING = System(
    "scenarios/berth/eight_cones_at_5_deg.toml",
    {
        "ship": CONTAINER_SHIP
        | {"start_heading_rad": 0.08726646259971647, "start_u_mps": 0.0131, "start_v_mps": 0.1494, "load_y_n": 150e3}
    },
    0.1,
    360.0,
)
MOORED = System("scenarios/berth/leaning_on_eight_fenders.toml", {"ship": CONTAINER_SHIP | {"load_y_n": 1.2e6}}, 0.1, 3600.0)


def deviation(got, wanted):
    return abs(got - wanted) / abs(wanted)


def compare_impact(run, peak_n, states):
    """The 4 kn tug: peak force, and the speed at which she leaves."""
    ship, tug = (run.table("bodies", "body", body) for body in ("ship", "tug"))
    last = max(ship)
    direct_peak_n = max(abs(row["force_y_n"]) for row in ship.values())
    assert ship[last]["force_y_n"] == 0.0
    # Bow on, the tug heads east.
    direct_mps = tug[last]["u_mps"] - ship[last]["v_mps"]
    closing_mps = states["tug"]["velocity_y_mps"] - states["ship"]["velocity_y_mps"]
    print(f"\npeak {peak_n / 1e3:.0f} kN, direct {direct_peak_n / 1e3:.0f}; leaves at {closing_mps:.4f} m/s, direct {direct_mps:.4f}")
    assert deviation(peak_n, direct_peak_n) < 0.15
    assert deviation(closing_mps, direct_mps) < 0.03


def compare_berthing(run, peak_n, between, states):
    """The 8-fender berthing: peak force, rate of turn between her two contacts, and final position."""
    ship = run.table("bodies", "body", "ship")
    direct_peak_n = max(abs(row["force_y_n"]) for row in ship.values())
    at, last = ship[50.0], ship[max(ship)]
    # Off the forward fenders she mostly turns: compare the speed of her ends.
    direct_mps, got_mps = at["r_radps"] * 149.0, between["r_radps"] * 149.0
    print(
        f"\npeak {peak_n / 1e3:.0f} kN, direct {direct_peak_n / 1e3:.0f}; her ends at {got_mps:.5f} m/s between, direct"
        f" {direct_mps:.5f}; at rest at {states['ship']['y_m']:.4f} m, direct {last['y_m']:.4f}"
    )
    assert deviation(peak_n, direct_peak_n) < 0.15
    assert deviation(got_mps, direct_mps) < 0.03
    assert abs(states["ship"]["y_m"] - last["y_m"]) < 0.02
