/**
 * The plan's measuring tools: scale bar, range rings, electronic bearing line, position under the pointer, bearing and distance
 * between two points. Each can be turned off; a browser keeps which are on.
 */
import {
  type ToolsScene,
  drawBearingLine,
  drawMeasured,
  drawRings,
  fromTo,
  knob,
} from "../draw/tools";
import { type Camera, minus, toEarth } from "../geometry";
import type { BodyNow, Pair } from "../protocol";
import { button, h, setAttribute, setClass, setText } from "../ui/dom";
import { fixed, toRadians } from "../units";

const TOOLS = [
  { key: "scale", text: "Scale", name: "Scale bar" },
  { key: "rings", text: "Rings", name: "Rings: distances from the ship" },
  { key: "bearing", text: "EBL", name: "EBL: electronic bearing line, drag its knob" },
  {
    key: "cursor",
    text: "Cursor",
    name: "Cursor: its position, and bearing and distance from the ship",
  },
  {
    key: "two",
    text: "2 points",
    name: "2 points: bearing and distance; touch one, then the other",
  },
] as const;
type Tool = (typeof TOOLS)[number]["key"];

const KEPT = "plan tools";
/** The knob is taken by a finger within this distance. */
const FINGER_PX = 24;
const STEP_RAD = toRadians(1);

export class Tools {
  private readonly on = new Set<Tool>(kept());
  private bearing_rad = 0;
  /** The points of the two-point tool, on the earth: none, one, or both. */
  private points: Pair[] = [];
  /** The place under the pointer, or that was touched last. */
  private under: Pair | null = null;
  private readonly buttons = new Map<Tool, HTMLButtonElement>();
  private readonly turners: HTMLElement;
  /** The row of buttons. */
  readonly row: HTMLElement;
  /** Shows and hides the row. */
  readonly opener: HTMLButtonElement;
  /** The position under the pointer. */
  readonly cursor = h("output", { class: "cursor hidden", "aria-label": "Cursor" });

  constructor() {
    for (const { key, text, name } of TOOLS)
      this.buttons.set(
        key,
        button(text, () => this.toggle(key), { name }),
      );
    const turn = (by: number) => () => {
      this.bearing_rad += by * STEP_RAD;
    };
    this.turners = h(
      "span",
      { class: "turners" },
      button("−1°", turn(-1), { name: "Bearing line −1°" }),
      button("+1°", turn(1), { name: "Bearing line +1°" }),
    );
    this.row = h(
      "div",
      { class: "measuring hidden", role: "group", "aria-label": "Measuring tools" },
      this.turners,
      ...this.buttons.values(),
    );
    this.opener = button("Measure", () => this.open(), {
      name: "Measure: tools (I)",
      "aria-expanded": "false",
    });
    this.show();
  }

  open(): void {
    const opens = this.row.classList.contains("hidden");
    setClass(this.row, "hidden", !opens);
    setAttribute(this.opener, "aria-expanded", String(opens));
  }

  private toggle(tool: Tool): void {
    if (!this.on.delete(tool)) this.on.add(tool);
    this.points = [];
    localStorage.setItem(KEPT, JSON.stringify([...this.on]));
    this.show();
  }

  private show(): void {
    for (const [tool, own] of this.buttons)
      setAttribute(own, "aria-pressed", String(this.has(tool)));
    setClass(this.turners, "hidden", !this.has("bearing"));
    setClass(this.cursor, "hidden", !this.has("cursor"));
  }

  has(tool: Tool): boolean {
    return this.on.has(tool);
  }

  /** Whether a pointer at a point of the canvas takes the knob of the bearing line. */
  takes(camera: Camera, ship: BodyNow | null, at: Pair): boolean {
    if (!ship || !this.has("bearing")) return false;
    const [x, y] = minus(at, knob(camera, ship, this.bearing_rad));
    return Math.hypot(x, y) <= FINGER_PX;
  }

  /** Turns the bearing line to a point of the canvas. */
  turn(camera: Camera, ship: BodyNow | null, at: Pair): void {
    if (!ship) return;
    const [north, east] = minus(toEarth(camera, at), [ship[0], ship[1]]);
    this.bearing_rad = Math.atan2(east, north);
  }

  /** The pointer is over a point of the canvas. */
  over(camera: Camera, at: Pair): void {
    this.under = toEarth(camera, at);
  }

  /** A click, or a touch that did not move. */
  tap(camera: Camera, at: Pair): void {
    this.over(camera, at);
    if (!this.has("two")) return;
    if (this.points.length >= 2) this.points = [];
    this.points.push(toEarth(camera, at));
  }

  draw(scene: ToolsScene): void {
    if (this.has("rings")) drawRings(scene);
    if (this.has("bearing")) drawBearingLine(scene, this.bearing_rad);
    const [from, till] = [this.points[0], this.points[1] ?? this.under];
    if (this.has("two") && from && till) drawMeasured(scene, from, till);
    if (!this.has("cursor")) return;
    const ship: Pair = [scene.ship[0], scene.ship[1]];
    setText(
      this.cursor,
      this.under
        ? `N ${fixed(this.under[0], 0)} m, E ${fixed(this.under[1], 0)} m; from the ship ${fromTo(ship, this.under)}`
        : "Point at the plan, or touch it.",
    );
  }
}

/** The tools that are on: those that this browser had last. */
function kept(): Tool[] {
  const text = localStorage.getItem(KEPT);
  if (text === null) return ["scale"];
  const names = JSON.parse(text) as string[];
  return TOOLS.map(({ key }) => key).filter((key) => names.includes(key));
}
