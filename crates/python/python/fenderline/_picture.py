"""The plan that a docking environment renders, by Matplotlib."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

RENDER_MODES = ["rgb_array", "human"]

#: From the scenario: outlines of ship and quay in their own axes, and the fenders' faces.
SHIP_M = np.array(
    [(-68, -8), (-60, -10), (40, -10), (58, -6), (68, 0), (58, 6), (40, 10), (-60, 10), (-68, 8)]
)
QUAY_M = np.array([(-120, 0), (120, 0), (120, 20), (-120, 20)])
FENDERS_M = np.array([-50.0, -17.0, 17.0, 37.0])
PROJECTION_M = 1.8


def known_render_mode(mode: str | None, modes: Sequence[str] = tuple(RENDER_MODES)) -> str | None:
    """The mode, if there is one of this name."""
    if mode is not None and mode not in modes:
        raise ValueError(f"render_mode is {mode!r}, but must be None or one of: {', '.join(modes)}")
    return mode


@dataclass
class Plan:
    """What a picture of an episode shows."""

    ship: tuple[float, float, float]
    speeds: tuple[float, float]
    orders: npt.NDArray[np.float64]
    wind: tuple[float, float]
    seconds: int
    share: float
    tugs: Sequence[tuple[float, float]] = ()
    """Force of each tug on the ship at its point along her, metres forward: (along, share of full, positive to starboard)."""


class Picture:
    """A figure of 640 × 320 pixels: north, along the quay, to the right."""

    def __init__(self, window: bool) -> None:
        try:
            import matplotlib.figure
        except ImportError as error:
            raise ImportError("rendering needs Matplotlib: pip install matplotlib") from error
        self._window = window
        if window:
            import matplotlib.pyplot as plt

            self._figure = plt.figure("fenderline", figsize=(6.4, 3.2), dpi=100)
        else:
            from matplotlib.backends.backend_agg import FigureCanvasAgg

            self._figure = matplotlib.figure.Figure(figsize=(6.4, 3.2), dpi=100)
            FigureCanvasAgg(self._figure)
        axes = self._figure.add_axes((0.0, 0.0, 1.0, 1.0))
        # Seen from above: with north to the right, east is down.
        axes.set(xlim=(-280.0, 200.0), ylim=(40.0, -200.0), aspect="equal")
        axes.axis("off")
        self._figure.patch.set_facecolor("#dbe9f1")
        axes.fill(QUAY_M[:, 0], QUAY_M[:, 1], color="#8a8a86")
        for along in FENDERS_M:
            axes.plot([along, along], [0.0, -PROJECTION_M], color="#1c1c1c", linewidth=5.0)
        axes.fill(SHIP_M[:, 0], SHIP_M[:, 1] - 10.0 - PROJECTION_M, fill=False, edgecolor="#2b7a4b", linestyle=":")
        (self._ship,) = axes.fill(SHIP_M[:, 0], SHIP_M[:, 1], color="#b5452c")
        (self._thrust,) = axes.plot([], [], color="#14506e", linewidth=2.0)
        self._text = axes.text(-275.0, -190.0, "", fontsize=8, family="monospace", va="top")
        self._axes = axes

    def draw(self, plans: Sequence[Plan]) -> None:
        """Draws the plan."""
        (plan,) = plans
        north, east, heading = plan.ship
        cosine, sine = np.cos(heading), np.sin(heading)

        def at(along: float, across: float) -> tuple[float, float]:
            return (
                north + along * cosine - across * sine,
                east + along * sine + across * cosine,
            )

        self._ship.set_xy(np.array([at(*point) for point in SHIP_M]))
        lines: list[tuple[float, float]] = []
        nothing = (float("nan"), float("nan"))
        forces = [(55.0, float(plan.orders[2])), (-52.0, float(plan.orders[3]))]
        for along, share in [*forces, *plan.tugs]:
            # The jet or the tug is on the side from which it pushes.
            side = -10.0 if share >= 0.0 else 10.0
            lines += [at(along, side), at(along, side - 30.0 * share), nothing]
        lines += [at(-68.0, 0.0), at(-68.0 - 40.0 * float(plan.orders[1]), 0.0)]
        self._thrust.set_data([x for x, _ in lines], [y for _, y in lines])
        wind = float(np.hypot(*plan.wind))
        self._text.set_text(
            f"{plan.seconds:4d} s\n{plan.speeds[0]:+.2f} m/s along\n{plan.speeds[1]:+.2f} m/s in\n"
            f"wind {wind:.0f} m/s\nfenders {plan.share:.0%}"
        )
        if self._window:
            import matplotlib.pyplot as plt

            plt.show(block=False)
            self._figure.canvas.draw_idle()
            self._figure.canvas.flush_events()

    def image(self) -> npt.NDArray[np.uint8]:
        """The picture as (height, width, 3) bytes."""
        canvas: Any = self._figure.canvas
        canvas.draw()
        pixels: npt.NDArray[np.uint8] = np.asarray(canvas.buffer_rgba())[..., :3].copy()
        return pixels

    def close(self) -> None:
        """Closes the window, if there is one."""
        if self._window:
            import matplotlib.pyplot as plt

            plt.close(self._figure)
