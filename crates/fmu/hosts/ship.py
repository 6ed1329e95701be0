"""A ship of three degrees of freedom as FMU: it stands for a user's ship model in the guide and the tests.

Mass and added mass about the centre of gravity, Kirchhoff's equations, a constant force, forward Euler with the
master's step. Input: the earth-fixed contact wrench. Outputs: position and earth-fixed velocity.
"""

from math import cos, sin

from pythonfmu import Fmi2Causality, Fmi2Slave, Fmi2Variability, Real

PARAMETERS = {
    # Surge, sway and yaw, added mass included [kg, kg, kg·m²].
    "surge_kg": 1e6,
    "sway_kg": 1e6,
    "yaw_kgm2": 1e8,
    # Start: north, east [m], heading [rad], surge, sway [m/s], rate of turn [rad/s].
    "start_x_m": 0.0,
    "start_y_m": 0.0,
    "start_heading_rad": 0.0,
    "start_u_mps": 0.0,
    "start_v_mps": 0.0,
    "start_r_radps": 0.0,
    # Load other than contact, north and east [N].
    "load_x_n": 0.0,
    "load_y_n": 0.0,
}
INPUTS = ["contact_x_n", "contact_y_n", "contact_moment_nm"]
OUTPUTS = ["x_m", "y_m", "heading_rad", "velocity_x_mps", "velocity_y_mps", "r_radps"]


class Ship(Fmi2Slave):
    description = "A ship of three degrees of freedom, forward Euler"

    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        for name, start in PARAMETERS.items():
            setattr(self, name, start)
            self.register_variable(
                Real(name, causality=Fmi2Causality.parameter, variability=Fmi2Variability.fixed)
            )
        for name in INPUTS:
            setattr(self, name, 0.0)
            self.register_variable(Real(name, causality=Fmi2Causality.input))
        for name in OUTPUTS:
            setattr(self, name, 0.0)
            self.register_variable(Real(name, causality=Fmi2Causality.output))

    def enter_initialization_mode(self):
        # Masters that connect variables during initialization get the initial state.
        self.start()

    def exit_initialization_mode(self):
        self.start()

    def start(self):
        self.x_m, self.y_m = self.start_x_m, self.start_y_m
        self.heading_rad, self.r_radps = self.start_heading_rad, self.start_r_radps
        self.u, self.v = self.start_u_mps, self.start_v_mps
        self.set_velocity()

    def set_velocity(self):
        c, s = cos(self.heading_rad), sin(self.heading_rad)
        self.velocity_x_mps = c * self.u - s * self.v
        self.velocity_y_mps = s * self.u + c * self.v

    def do_step(self, current_time, step_size):
        c, s = cos(self.heading_rad), sin(self.heading_rad)
        x_n, y_n = self.contact_x_n + self.load_x_n, self.contact_y_n + self.load_y_n
        surge_n, sway_n = c * x_n + s * y_n, -s * x_n + c * y_n
        u, v, r = self.u, self.v, self.r_radps
        mu, mv, iz = self.surge_kg, self.sway_kg, self.yaw_kgm2
        # Forward Euler: positions with the old velocities.
        self.x_m += self.velocity_x_mps * step_size
        self.y_m += self.velocity_y_mps * step_size
        self.heading_rad += r * step_size
        self.u += (surge_n + mv * v * r) / mu * step_size
        self.v += (sway_n - mu * u * r) / mv * step_size
        self.r_radps += (self.contact_moment_nm + (mu - mv) * u * v) / iz * step_size
        self.set_velocity()
        return True
