/** Where the ship is on her passage plan: cross-track distance, next waypoint, course of the leg, next wheel-over point. */
import type { Frame } from "../protocol";
import { minus } from "../geometry";
import type { Live } from "../live";
import { h, setClass, setText } from "../ui/dom";
import { clock, distance, fixed, heading, knots } from "../units";

/** A slower ship has no time to her waypoint [m/s]. */
const UNDER_WAY_MPS = 0.3;

export class PlanReadout {
  private readonly cells = new Map<string, HTMLElement>();
  readonly root = h("dl", { class: "on-plan hidden", "aria-label": "Passage plan" });

  constructor() {
    for (const [key, name] of [
      ["XTD", "Cross-track distance, and the side of the track that the ship is on"],
      ["NEXT", "Next waypoint"],
      ["DIST", "Distance to the next waypoint along the track"],
      ["TIME", "Time to the next waypoint at the present speed"],
      ["LEG", "Course of the leg"],
      ["THEN", "Course of the leg after the next waypoint"],
      ["WHEEL", "Distance to the next wheel-over point"],
      ["PLAN", "Planned speed on the leg"],
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

  /** Whether the ship has a plan. */
  get isShown(): boolean {
    return !this.root.classList.contains("hidden");
  }

  tick(frame: Frame, live: Live): void {
    const now = frame.vessels[live.ship()]?.plan;
    const plan = live.vessel(live.ship())?.plan;
    setClass(this.root, "hidden", !now || !plan);
    const body = frame.bodies[live.body()];
    if (!now || !plan || !body) return;
    const off = Math.abs(now.cross_track_m);
    const side = off < 0.5 ? "" : now.cross_track_m < 0 ? " P" : " S";
    const isOver = now.to_waypoint_m < 0;
    this.set("XTD", isOver ? "–" : `${fixed(off, 0)} m${side}`);
    const next = plan.waypoints[now.leg + 1];
    this.set("NEXT", isOver ? "end of plan" : next?.name || `WP ${now.leg + 2}`);
    this.set("DIST", isOver ? "–" : distance(now.to_waypoint_m));
    const speed = Math.hypot(body[3], body[4]);
    const hasTime = !isOver && speed > UNDER_WAY_MPS;
    this.set("TIME", hasTime ? clock(now.to_waypoint_m / speed) : "–");
    this.set("LEG", heading(now.course_rad));
    const after = plan.waypoints[now.leg + 2]?.at_m;
    const then = next && after && minus(after, next.at_m);
    this.set("THEN", then ? heading(Math.atan2(then[1], then[0])) : "–");
    this.set("WHEEL", now.to_wheel_over_m === null ? "–" : distance(now.to_wheel_over_m));
    this.set("PLAN", now.speed_mps === null ? "–" : knots(now.speed_mps));
    const cell = this.cells.get("XTD");
    if (cell) setClass(cell, "alarm", now.half_width_m !== null && off > now.half_width_m);
  }
}
