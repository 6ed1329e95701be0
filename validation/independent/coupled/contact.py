"""A contact in one step, and its memory from the first touch to the end."""


class Touch:
    """A contact at the start of a step."""

    __slots__ = (
        "one two nx ny px py depth area force stored tilt material memory v_n v_t law normal shear "
        "an bn at bt linear a_nn slides bounded boxes guess limit".split()
    )

    def grip(self):
        """Levers of n and t about both bodies, speeds, and the change of V_n by a unit of N."""
        one, two, nx, ny = self.one, self.two, self.nx, self.ny
        ax, ay = self.px - one.x, self.py - one.y
        bx, by = self.px - two.x, self.py - two.y
        self.an, self.at = ax * ny - ay * nx, ax * nx + ay * ny
        self.bn, self.bt = bx * ny - by * nx, bx * nx + by * ny
        self.v_n, self.v_t = self.speeds()
        self.linear = (
            (one.ixx + two.ixx) * nx * nx + 2.0 * (one.ixy + two.ixy) * nx * ny + (one.iyy + two.iyy) * ny * ny
        )
        self.a_nn = self.linear + one.irr * self.an * self.an + two.irr * self.bn * self.bn

    def speeds(self):
        """V_n (closing) and V_t of `one` relative to `two`."""
        one, two, nx, ny = self.one, self.two, self.nx, self.ny
        vx, vy = one.vx - two.vx, one.vy - two.vy
        return (
            vx * nx + vy * ny + one.rate * self.an - two.rate * self.bn,
            vy * nx - vx * ny + one.rate * self.at - two.rate * self.bt,
        )

    def column(self, h):
        """The data of coordinate descent: bodies, n with its levers, the change of each body's velocity by one newton for `h`
        seconds, and the resulting change of V_n."""
        one, two, nx, ny = self.one, self.two, self.nx, self.ny
        return (
            one, two, nx, ny, self.an, self.bn,
            h * (one.ixx * nx + one.ixy * ny), h * (one.ixy * nx + one.iyy * ny), h * one.irr * self.an,
            h * (two.ixx * nx + two.ixy * ny), h * (two.ixy * nx + two.iyy * ny), h * two.irr * self.bn,
            h * self.a_nn,
        )

    def push(self, normal_ns, shear_ns):
        """An impulse of N and T on `one`, and its opposite on `two`."""
        fx = -normal_ns * self.nx - shear_ns * self.ny
        fy = -normal_ns * self.ny + shear_ns * self.nx
        one, two = self.one, self.two
        if not one.fixed:
            one.px += fx
            one.py += fy
            one.spin += shear_ns * self.at - normal_ns * self.an
            one.set_velocity()
        if not two.fixed:
            two.px -= fx
            two.py -= fy
            two.spin -= shear_ns * self.bt - normal_ns * self.bn
            two.set_velocity()


class Memory:
    """The memory of a contact, from the first touch to the end."""

    def __init__(self):
        self.new = True
        self.shear_m = 0.0
        self.slides = False
        self.v_ref = 0.0
        self.approaching = False
        self.normal_n = 0.0
        self.factor = 1.0
        self.area = 0.0
        self.taken_j = 0.0
        self.boxes = None
        # For a fender's unloading law.
        self.tops = []

