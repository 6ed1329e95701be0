/** A ring that sets a direction, by touch, by dragging, or by the arrow keys in steps of five degrees. */
import { FONT, arrow, polygon, stroke } from "../draw/marks";
import { palette } from "../palette";
import type { Pair } from "../protocol";
import { toDegrees, toRadians, wrapped } from "../units";
import { canvas, setAttribute } from "./dom";

const STEP_DEG = 5;

export class Ring {
  private readonly surface;
  readonly root: HTMLCanvasElement;
  private order_rad = 0;
  private enabled = true;

  /** `about`: what its zero is: the bow of the ship, the bow of the tug herself, or north. */
  constructor(
    label: string,
    private readonly about: "ship" | "tug" | "north",
    private readonly turn: (rad: number) => void,
  ) {
    this.surface = canvas(label);
    this.root = this.surface.root;
    this.root.classList.add("ring");
    for (const [name, value] of [
      ["role", "slider"],
      ["tabindex", "0"],
      ["aria-valuemin", "-180"],
      ["aria-valuemax", "180"],
      ["aria-valuenow", "0"],
    ] as const) {
      this.root.setAttribute(name, value);
    }
    const point = (event: PointerEvent) => {
      const box = this.root.getBoundingClientRect();
      const raw = Math.atan2(
        event.clientX - box.left - box.width / 2,
        box.top + box.height / 2 - event.clientY,
      );
      this.set(toRadians(Math.round(toDegrees(raw) / STEP_DEG) * STEP_DEG));
    };
    this.root.addEventListener("pointerdown", (event) => {
      if (!this.enabled) return;
      this.root.setPointerCapture(event.pointerId);
      point(event);
    });
    this.root.addEventListener("pointermove", (event) => {
      if (this.enabled && this.root.hasPointerCapture(event.pointerId)) point(event);
    });
    this.root.addEventListener("keydown", (event) => {
      const by = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
      if (by === 0 || !this.enabled) return;
      event.preventDefault();
      event.stopPropagation();
      this.nudge(by);
    });
  }

  /** Turns by steps of five degrees, positive to starboard. */
  nudge(by: number): void {
    this.set(this.order_rad + toRadians(by * STEP_DEG));
  }

  get value(): number {
    return this.order_rad;
  }

  private set(rad: number): void {
    const next = wrapped(rad);
    if (Math.abs(next - this.order_rad) < 1e-6) return;
    this.order_rad = next;
    this.turn(next);
  }

  /** Shows an order that another page or the server gave. */
  follow(rad: number): void {
    this.order_rad = wrapped(rad);
  }

  enable(on: boolean): void {
    this.enabled = on;
    setAttribute(this.root, "aria-disabled", String(!on));
  }

  draw(actual_rad: number, share: number): void {
    const begun = this.surface.begin();
    setAttribute(this.root, "aria-valuenow", String(Math.round(toDegrees(this.order_rad))));
    setAttribute(
      this.root,
      "aria-valuetext",
      `${Math.abs(Math.round(toDegrees(this.order_rad)))} degrees ${this.order_rad < 0 ? "port" : "starboard"}`,
    );
    if (!begun) return;
    const { to, width, height } = begun;
    const colours = palette();
    const [x, y, r] = [width / 2, height / 2, Math.min(width, height) / 2 - 12];
    const on = (angle: number, far: number): Pair => [
      x + Math.sin(angle) * far,
      y - Math.cos(angle) * far,
    ];
    to.clearRect(0, 0, width, height);
    to.beginPath();
    to.arc(x, y, r, 0, 2 * Math.PI);
    to.fillStyle = colours.button;
    to.fill();
    to.strokeStyle = colours.button_edge;
    to.lineWidth = 2;
    to.stroke();
    for (let degree = 0; degree < 360; degree += 15) {
      const angle = toRadians(degree);
      stroke(to, on(angle, r), on(angle, r - (degree % 45 === 0 ? 10 : 5)), colours.dim, 1.5);
    }
    if (this.about === "north") {
      to.fillStyle = colours.text;
      to.font = `600 14px ${FONT}`;
      to.textAlign = "center";
      to.textBaseline = "middle";
      to.fillText("N", x, y - r + 20);
    } else {
      const [long, half] = this.about === "ship" ? [r * 0.5, r * 0.13] : [r * 0.34, r * 0.15];
      polygon(to, [
        [x, y - long],
        [x + half, y - long * 0.6],
        [x + half, y + long],
        [x - half, y + long],
        [x - half, y - long * 0.6],
      ]);
      to.fillStyle = this.about === "ship" ? colours.own : colours.tug;
      to.globalAlpha = 0.5;
      to.fill();
      to.globalAlpha = 1;
    }
    if (share > 0.005) arrow(to, [x, y], on(actual_rad, Math.max(18, r * share)), colours.force, 6);
    // The knob: the order.
    const knob = on(this.order_rad, r - 4);
    to.beginPath();
    to.arc(knob[0], knob[1], 13, 0, 2 * Math.PI);
    to.fillStyle = this.enabled ? colours.chosen : colours.dim;
    to.fill();
    to.strokeStyle = colours.text;
    to.lineWidth = 2;
    to.stroke();
  }
}
