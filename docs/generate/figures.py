"""The figures of the book. Numbers come from runs of the program; sketches of geometry are computed here.

Each function draws one figure; its name is the file's name.
"""

import csv
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent.parent
# The polygon overlap of the second implementation.
sys.path.insert(0, str(ROOT / "validation" / "independent"))
from coupled.polygons import overlaps  # noqa: E402

BLUE, ORANGE, GREEN, RED, GREY = "#0b6aa2", "#d9730d", "#2f7d32", "#b3261e", "#6b7280"
plt.rcParams.update({
    "figure.figsize": (7.0, 3.6), "font.size": 10, "axes.spines.top": False, "axes.spines.right": False,
    "axes.grid": True, "grid.color": "#e5e7eb", "legend.frameon": False, "lines.linewidth": 1.6,
    "svg.hashsalt": "fenderline", "savefig.bbox": "tight",
})


class Program:
    """Runs scenarios, each once."""

    def __init__(self, path: str, folder: Path):
        self.path, self.folder, self.count = path, folder, 0

    def run(self, scenario: str, **keys) -> Path:
        self.count += 1
        out = self.folder / str(self.count)
        settings = [part for key, value in keys.items() for part in ("--set", f"{key.replace('__', '.')}={value}")]
        command = [self.path, "run", str(ROOT / "scenarios" / f"{scenario}.toml"), "--out", str(out), "--allow-failures", *settings]
        subprocess.run(command, check=True, capture_output=True)
        return out


def table(run: Path, name: str, where=lambda row: True) -> dict[str, list]:
    """The columns of a result table, numbers as numbers; of the rows that `where` accepts."""
    with open(run / f"{name}.csv", newline="", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if where(row)]
    return {key: [number(row[key]) for row in rows] for key in (rows[0] if rows else {})}


def number(text: str):
    try:
        return float(text)
    except ValueError:
        return text


def draw_all(program: str, folder: Path) -> None:
    with tempfile.TemporaryDirectory() as runs:
        runner = Program(program, Path(runs))
        for draw in [contact_geometry, shear_spring, stick_and_slip, steps_and_peaks, leaning, half_steps,
                     rubber_loop, split_contact, learning]:
            figure = draw(runner)
            figure.savefig(folder / f"{draw.__name__}.svg", metadata={"Date": None})
            plt.close(figure)


def polygon(axes, corners, **style):
    """x is north, so that it is drawn upwards, and y is east."""
    points = [(y, x) for x, y in corners]
    axes.add_patch(plt.Polygon(points, **style))


def arrow(axes, start, end, color, label, offset=(0.0, 0.0)):
    axes.annotate("", xy=(end[1], end[0]), xytext=(start[1], start[0]),
                  arrowprops={"arrowstyle": "-|>", "color": color, "linewidth": 1.8})
    axes.text(end[1] + offset[1], end[0] + offset[0], label, color=color, fontsize=12)


def contact_geometry(_):
    """A corner of one hull in another: overlap, chord, normal and tangent."""
    body_1 = [(-4.0, -6.0), (1.5, -6.0), (1.5, 6.0), (-4.0, 6.0)]
    turn, shift = math.radians(28.0), (3.2, -1.2)
    square = [(-2.6, -3.4), (2.6, -3.4), (2.6, 3.4), (-2.6, 3.4)]
    body_2 = [(shift[0] + x * math.cos(turn) - y * math.sin(turn), shift[1] + x * math.sin(turn) + y * math.cos(turn))
              for x, y in square]
    [(corners, chord)] = overlaps(body_1, body_2)
    doubled = [a[0] * b[1] - b[0] * a[1] for a, b in zip(corners, corners[1:] + corners[:1])]
    area = sum(doubled) / 2
    centroid = [sum((a[i] + b[i]) * d for (a, b), d in zip(zip(corners, corners[1:] + corners[:1]), doubled)) / (6 * area)
                for i in (0, 1)]
    length = math.hypot(*chord)
    normal = (chord[1] / length, -chord[0] / length)
    tangent = (-normal[1], normal[0])
    ends = [point for point in corners if abs(point[0] - 1.5) < 1e-9]
    ends.sort(key=lambda p: p[0] * chord[0] + p[1] * chord[1])
    figure, axes = plt.subplots(figsize=(6.4, 4.4))
    polygon(axes, body_1, facecolor="#dbeafe", edgecolor=BLUE)
    polygon(axes, body_2, facecolor="#ffedd5", edgecolor=ORANGE, alpha=0.85)
    polygon(axes, corners, facecolor="#fca5a5", edgecolor=RED, linewidth=1.2)
    axes.plot([ends[0][1], ends[1][1]], [ends[0][0], ends[1][0]], "--", color=RED)
    for point, label in zip(ends, ["$P_{in}$", "$P_{out}$"]):
        axes.plot(point[1], point[0], "o", color=RED, markersize=4)
        axes.text(point[1] - 0.35, point[0] + 0.22, label, color=RED, fontsize=11)
    end = lambda direction: (centroid[0] + 1.7 * direction[0], centroid[1] + 1.7 * direction[1])  # noqa: E731
    arrow(axes, centroid, end(normal), GREEN, "n", (0.05, 0.15))
    arrow(axes, centroid, end(tangent), GREEN, "t", (-0.5, 0.0))
    axes.plot(centroid[1], centroid[0], "o", color="black", markersize=4)
    axes.text(centroid[1] + 0.12, centroid[0] - 0.55, "C", fontsize=12)
    axes.text(-5.8, -3.8, "body 1", color=BLUE, fontsize=12)
    axes.text(-2.6, 4.4, "body 2", color=ORANGE, fontsize=12)
    axes.set(xlim=(-6.3, 6.3), ylim=(-4.3, 6.6), xlabel="east y [m]", ylabel="north x [m]", aspect="equal")
    return figure


def shear_spring(_):
    """Force of the shear spring against relative slip, with the two limits of friction."""
    figure, axes = plt.subplots(figsize=(6.4, 3.4))
    static, dynamic, stiffness = 1.0, 0.75, 1.0
    there = [0.0, static, static, 2.0]
    force = [0.0, static, dynamic, dynamic]
    back = [2.0, 2.0 - 2 * dynamic, 0.0]
    axes.plot(there, force, color=BLUE, label="slip grows: sticks, then slides")
    axes.plot(back, [dynamic, -dynamic, -dynamic], "--", color=ORANGE, label="slip turns back: sticks, then slides")
    for level, name in [(static, r"$\mu_s N$"), (dynamic, r"$\mu_k N$"), (-dynamic, r"$-\mu_k N$")]:
        axes.axhline(level, color=GREY, linewidth=0.8, linestyle=":")
        axes.text(2.25, level, name, va="center", fontsize=11)
    axes.text(0.55, 0.36, r"slope $k_s$", color=BLUE)
    axes.set(xlabel="relative slip of the two bodies", ylabel="$-T$", xticks=[], yticks=[0], xlim=(-0.05, 2.2),
             ylim=(-1.45, 1.2))
    axes.legend(loc="lower right", fontsize=9)
    return figure


def stick_and_slip(program):
    """A barge grazes a fender: the tangential force stays at the sliding limit, at any time step."""
    figure, axes = plt.subplots()
    for step, color in [(0.5, ORANGE), (0.01, BLUE)]:
        run = program.run("closed_form/grazing_slide", time__step=f'"{step} s"')
        found = table(run, "contacts")
        forces = [abs(f) / 1e3 for f in found["tangential_force_n"]]
        axes.step([*found["t_s"], found["t_s"][-1] + step], [*forces, forces[-1]], where="post", color=color,
                  label=f"mean |T| of steps of {step} s")
        if step == 0.01:
            axes.plot(found["t_s"], [0.3 * f / 1e3 for f in found["normal_force_n"]], color=GREY, linestyle=":",
                      label=r"$\mu_s N$")
            axes.plot(found["t_s"], [0.2 * f / 1e3 for f in found["normal_force_n"]], color="black", linestyle="--",
                      linewidth=1.0, label=r"$\mu_k N$")
    axes.set(xlabel="time [s]", ylabel="force [kN]")
    axes.legend()
    return figure


STEPS = [0.01, 0.1, 0.5, 1.0, 2.0]


def steps_and_peaks(program):
    """The paper's tug at 4 knots: peak normal force and greatest depth by time step, by both methods."""
    import json

    figure, (left, right) = plt.subplots(1, 2, figsize=(8.0, 3.4))
    for method, color, marker in [("paper", ORANGE, "s"), ("coupled", BLUE, "o")]:
        peaks, depths = [], []
        for step in STEPS:
            keys = {"contact__method": method, "time__step": f'"{step} s"', "time__duration": '"20 s"'}
            if method == "coupled":
                keys["time__integrator"] = "semi_implicit"
            run = program.run("paper/experiment_2_4kn", **keys)
            summary = json.loads((run / "summary.json").read_text(encoding="utf-8"))
            pair = summary["pairs"][0]
            peaks.append(pair["peak_normal_force_n"] / 1e6)
            depths.append(pair["peak_depth_m"])
        left.plot(STEPS, peaks, marker + "-", color=color, label=method)
        right.plot(STEPS, depths, marker + "-", color=color, label=method)
    for axes, label in [(left, "peak normal force [MN]"), (right, "greatest depth [m]")]:
        axes.set(xscale="log", xlabel="time step [s]", ylabel=label)
        axes.set_ylim(bottom=0.0)
        axes.set_xticks(STEPS, [f"{s:g}" for s in STEPS])
        axes.minorticks_off()
    left.legend()
    figure.tight_layout()
    return figure


def leaning(program):
    """A ship pressed on eight fenders by a steady load, by both methods."""
    figure, axes = plt.subplots()
    for method, color in [("paper", ORANGE), ("coupled", BLUE)]:
        run = program.run("berth/leaning_on_eight_fenders", contact__method=method, time__duration='"20 min"')
        found = table(run, "bodies", lambda row: row["body"] == "ship")
        axes.plot([t / 60 for t in found["t_s"]], found["y_m"], color=color, label=method)
    axes.axhline(0.075, color=GREY, linestyle=":", linewidth=1.2)
    axes.text(21.2, 0.075, "static depth", va="center", color=GREY)
    axes.set(xlabel="time [min]", ylabel="depth in the fenders [m]")
    axes.legend()
    return figure


def half_steps(_):
    """Sub-steps as a leapfrog: positions at their ends, velocities in their middles."""
    figure, axes = plt.subplots(figsize=(7.2, 2.5))
    ends = [0.0, 1.0, 2.0, 2.6, 3.2, 3.8]
    axes.axhline(0.0, color=GREY, linewidth=1.0)
    for index, end in enumerate(ends):
        axes.plot(end, 0.0, "o", color=BLUE, markersize=8)
        axes.text(end, -0.42, f"$x_{index}$", ha="center", color=BLUE, fontsize=12)
    middles = [(a + b) / 2 for a, b in zip(ends, ends[1:])]
    for index, middle in enumerate(middles):
        axes.plot(middle, 0.0, "s", color=ORANGE, markersize=7)
        axes.text(middle, 0.25, f"$v_{{{index}+1/2}}$", ha="center", color=ORANGE, fontsize=11)
    for index, (a, b) in enumerate(zip(middles, middles[1:])):
        axes.annotate("", xy=(b, 0.75 + 0.28 * (index % 2)), xytext=(a, 0.75 + 0.28 * (index % 2)),
                      arrowprops={"arrowstyle": "|-|,widthA=0.25,widthB=0.25", "color": GREEN})
        axes.text((a + b) / 2, 0.83 + 0.28 * (index % 2), rf"$\kappa_{index + 1}$", ha="center", color=GREEN)
    for a, b in zip(ends, ends[1:]):
        axes.text((a + b) / 2, -0.75, "$h$" if b - a > 0.8 else "$h'$", ha="center", color=GREY)
    axes.text(4.25, -0.3, "time", ha="right", color=GREY)
    axes.set(xlim=(-0.2, 4.3), ylim=(-0.95, 1.45))
    axes.axis("off")
    return figure


def rubber_loop(program):
    """Reaction against deflection of a buckling fender: the way in, and the way out at a lower reaction."""
    run = program.run("closed_form/rubber_head_on", time__step='"0.005 s"')
    found = table(run, "fenders")
    figure, axes = plt.subplots(figsize=(6.4, 3.6))
    deepest = max(range(len(found["t_s"])), key=lambda i: found["deflection_m"][i])
    for part, color, label in [(slice(0, deepest + 1), BLUE, "compression"), (slice(deepest, None), ORANGE, "retreat")]:
        axes.plot(found["deflection_m"][part], [r / 1e3 for r in found["reaction_n"][part]], color=color, label=label)
    axes.set(xlabel="deflection [m]", ylabel="reaction [kN]")
    axes.set_ylim(bottom=0.0)
    axes.legend()
    return figure


def split_contact(_):
    """A contact that splits: the shear goes to both parts, areas and energies in proportion to the parts' areas."""
    figure, axes = plt.subplots(1, 2, figsize=(8.0, 2.9))
    quay = [(-3.0, -8.0), (0.0, -8.0), (0.0, 8.0), (-3.0, 8.0)]
    # Walked from north to east, as `overlaps` wants it.
    hull = [(-0.9, -6.0), (-0.9, -2.2), (-0.25, -0.6), (-0.25, 0.6), (-0.6, 2.2), (-0.6, 4.4), (3.0, 4.4), (3.0, -6.0)][::-1]
    for ax, lift, title in [(axes[0], 0.0, "one patch"), (axes[1], 0.4, "two patches")]:
        moved = [(x + lift, y) for x, y in hull]
        polygon(ax, quay, facecolor="#dbeafe", edgecolor=BLUE)
        polygon(ax, moved, facecolor="#ffedd5", edgecolor=ORANGE, alpha=0.85)
        patches = overlaps(quay, moved)
        areas = []
        for corners, _ in sorted(patches, key=lambda found: found[0][0][1]):
            polygon(ax, corners, facecolor="#fca5a5", edgecolor=RED)
            area = abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(corners, corners[1:] + corners[:1]))) / 2
            middle = sum(y for _, y in corners) / len(corners)
            areas.append((area, middle))
        for name, (area, middle) in zip(["S"] if len(areas) == 1 else ["S_1", "S_2"], areas):
            ax.text(middle, -2.3, rf"${name}={area:.1f}\,\mathrm{{m^2}}$" + "\n" + r"shear $\Delta s$", ha="center", color=RED)
        ax.text(0.0, 1.7, "hull", ha="center", color=ORANGE)
        ax.text(-7.8, -2.8, "quay", color=BLUE)
        ax.set(title=title, xlim=(-8, 8), ylim=(-3, 3.4), aspect="equal")
        ax.axis("off")
    return figure


def learning(_):
    """Share of unseen starts that a learning policy berths, and how long it takes, over processor time."""
    folder = ROOT / "examples" / "python" / "learning"
    figure, (shares, lengths) = plt.subplots(2, 1, sharex=True, figsize=(7.0, 4.8))
    for name, label, color in [("cloned", "cloning, then practice", BLUE), ("from_nothing", "practice alone", ORANGE)]:
        with open(folder / f"{name}.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        minutes = [float(row["processor_s"]) / 60.0 for row in rows]
        shares.plot(minutes, [100.0 * float(row["berthed"]) for row in rows], color=color, label=label, marker=".")
        lengths.plot(minutes, [float(row["mean_s"]) for row in rows], color=color, marker=".")
    shares.axhline(80.0, color=GREY, linestyle=":", linewidth=1.0)
    shares.set(ylabel="berthed [%]", ylim=(-4.0, 104.0))
    shares.legend()
    lengths.set(ylabel="mean length [s]", xlabel="processor time, one core [min]")
    return figure
