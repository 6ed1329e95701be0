/** A ring that sets a direction, by touch, by dragging, or by the arrow keys in steps of five degrees. */
import { inSteps, instrument } from "../instruments/instrument";
import { beaufort, currentArrows } from "../instruments/scales";
import { toDegrees, toRadians, wrapped } from "../units";
import { h, setAttribute } from "./dom";

const STEP_DEG = 5;

/** What a ring shows: a thrust or a force about the bow, its share as strength; or wind or current about north, in m/s. */
export type Subject = "thrust" | "wind" | "current";

interface State {
  /** Direction to which the thrust or the current goes, or from which the wind comes. */
  actual_rad: number;
  strength: number;
  ordered_rad: number;
  /** The order of a thrust. */
  ordered_strength: number | undefined;
  /** The ring may be turned, and is being turned. */
  enabled: boolean;
  touching: boolean;
}

/** OpenBridge's instrument in the ring. */
interface Dial {
  root: HTMLElement;
  show(state: State): void;
}

function thrustDial(): Dial {
  const { root, show } = instrument("obc-azimuth-thruster", {
    singleDirection: true,
    starboardPortIndicator: true,
    secondaryTickmarkInterval: 45,
    tertiaryTickmarkInterval: 15,
    tickmarkStyle: "enhanced",
  });
  return {
    root,
    show: (state) =>
      show({
        angle: inSteps(toDegrees(state.actual_rad), 0.5),
        thrust: inSteps(state.strength * 100, 0.5),
        angleSetpoint: inSteps(toDegrees(state.ordered_rad), 0.5),
        thrustSetpoint:
          state.ordered_strength === undefined ? undefined : state.ordered_strength * 100,
        priority: state.enabled ? "enhanced" : "regular",
        touching: state.touching,
      }),
  };
}

function weatherDial(subject: "wind" | "current"): Dial {
  const { root, show } = instrument("obc-watch", {
    northArrow: true,
    showLabels: true,
    crosshairEnabled: true,
    padding: 56,
    // Inside of the ring; the current on the side to which it goes, where the order is.
    windSymbolRadius: 100,
    currentSymbolRadius: -105,
  });
  return {
    root,
    show: (state) => {
      const degrees = inSteps(toDegrees(state.actual_rad), 0.5);
      show({
        angleSetpoint: inSteps(toDegrees(state.ordered_rad), 0.5),
        atAngleSetpoint: Math.abs(wrapped(state.actual_rad - state.ordered_rad)) < toRadians(1),
        priority: state.enabled ? "enhanced" : "regular",
        touching: state.touching,
        ...(subject === "wind"
          ? { wind: beaufort(state.strength), windFromDirectionDeg: degrees }
          : { current: currentArrows(state.strength), currentFromDirectionDeg: degrees + 180 }),
      });
    },
  };
}

export class Ring {
  private readonly dial: Dial;
  readonly root: HTMLElement;
  private order_rad = 0;
  private enabled = true;
  private touching = false;

  constructor(
    label: string,
    subject: Subject,
    private readonly turn: (rad: number) => void,
  ) {
    this.dial = subject === "thrust" ? thrustDial() : weatherDial(subject);
    this.root = h(
      "div",
      {
        class: "ring",
        role: "slider",
        tabindex: 0,
        "aria-label": label,
        "aria-valuemin": -180,
        "aria-valuemax": 180,
        "aria-valuenow": 0,
      },
      this.dial.root,
    );
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
      this.touching = true;
      point(event);
    });
    this.root.addEventListener("pointermove", (event) => {
      if (this.enabled && this.root.hasPointerCapture(event.pointerId)) point(event);
    });
    this.root.addEventListener("lostpointercapture", () => (this.touching = false));
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

  /** Shows the actual direction and strength, and the ordered strength if there is one. */
  draw(actual_rad: number, strength: number, ordered_strength?: number): void {
    setAttribute(this.root, "aria-valuenow", String(Math.round(toDegrees(this.order_rad))));
    setAttribute(
      this.root,
      "aria-valuetext",
      `${Math.abs(Math.round(toDegrees(this.order_rad)))} degrees ${this.order_rad < 0 ? "port" : "starboard"}`,
    );
    const { order_rad: ordered_rad, enabled, touching } = this;
    this.dial.show({ actual_rad, strength, ordered_rad, ordered_strength, enabled, touching });
  }
}
