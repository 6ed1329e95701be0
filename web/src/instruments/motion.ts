/** Heading, rate of turn, speed, course, under-keel clearance, wind and current in a row: over the plan and over the view. */
import type { Live } from "../live";
import type { Frame } from "../protocol";
import { h, setClass, setText } from "../ui/dom";
import { fixed, heading, knots, rateOfTurn, toKnots } from "../units";

/** A row of figures: how the vessel of the page moves, the water under her keel, wind and current. */
export class Motion {
  private readonly cells = new Map<string, HTMLElement>();
  readonly root: HTMLElement;

  /** `name`: the class of the row in the page. */
  constructor(name: "readout" | "motion") {
    this.root = h("dl", { class: name, "aria-label": "Motion of the ship" });
    for (const [key, name] of [
      ["HDG", "Heading"],
      ["ROT", "Rate of turn"],
      ["SOG", "Speed over ground"],
      ["COG", "Course over ground"],
      ["UKC", "Under-keel clearance"],
      ["WIND", "Wind, from"],
      ["CURR", "Current, towards"],
    ] as const) {
      const cell = h("dd", {}, "–");
      this.cells.set(key, cell);
      this.root.append(h("div", {}, h("dt", { title: name }, key), cell));
    }
  }

  private set(key: string, text: string): void {
    const cell = this.cells.get(key);
    if (cell) setText(cell, text);
  }

  tick(frame: Frame, live: Live): void {
    // A tugmaster reads the motion of the tug, not of the ship.
    const now = frame.vessels[live.conned()];
    const body = frame.bodies[live.readBody()];
    if (!body) return;
    const [, , head, north, east, rate] = body;
    const under_keel_m = now?.under_keel_m ?? null;
    const speed = Math.hypot(north, east);
    const turn = rateOfTurn(rate);
    this.set("HDG", heading(head));
    this.set(
      "ROT",
      `${Math.abs(turn) < 0.05 ? "" : turn < 0 ? "◀ " : "▶ "}${fixed(Math.abs(turn), 1)}°/min`,
    );
    this.set("SOG", knots(speed, 2));
    this.set("COG", speed < 0.02 ? "–" : heading(Math.atan2(east, north)));
    this.set("UKC", under_keel_m === null ? "–" : `${fixed(under_keel_m, 1)} m`);
    this.set(
      "WIND",
      `${fixed(toKnots(frame.wind.speed_mps), 0)} kn ${heading(frame.wind.from_rad, 0)}`,
    );
    this.set(
      "CURR",
      `${fixed(toKnots(frame.current.speed_mps), 1)} kn ${heading(frame.current.to_rad, 0)}`,
    );
    const cell = this.cells.get("UKC");
    if (cell) setClass(cell, "alarm", (now?.aground ?? false) || (under_keel_m ?? 9) < 0.5);
  }
}
