/** The plan: an electronic chart of the harbour around the ship. */
import { drawBeyond } from "../draw/beyond";
import { drawChart, drawChartMarks } from "../draw/chart";
import { drawFog } from "../draw/fog";
import { drawAnchors } from "../draw/anchors";
import { drawPlace } from "../draw/place";
import * as scene from "../draw/scene";
import { limits } from "../draw/depths";
import { type Box, type Label, type Placed, Rank, place } from "../draw/labels";
import { drawGhost } from "../draw/ghost";
import { drawPassagePlan } from "../draw/passage_plan";
import { drawPassages } from "../draw/passages";
import { drawPlacing } from "../draw/placing";
import { drawTraffic } from "../draw/traffic";
import { drawTrial } from "../draw/trial";
import { FONT, arrow, drawLabel, labelFont, stroke } from "../draw/marks";
import {
  type Camera,
  add,
  fitted,
  minus,
  roundLength,
  toEarth,
  toScreen,
  zoomed,
  around,
} from "../geometry";
import type { Live } from "../live";
import { type Palette, palette } from "../palette";
import { Motion } from "../instruments/motion";
import type { BodyNow, Frame, Pair } from "../protocol";
import type { Placing } from "../placing";
import type { Trial } from "../trial";
import { button, canvas, h, setAttribute, setText } from "../ui/dom";
import { fixed } from "../units";
import { PlanReadout } from "./plan_readout";
import { Safety } from "./safety";
import { Tools } from "./tools";
import type { View } from "./view";

export type Up = "north" | "head" | "berth";
const UP_NAMES: Record<Up, string> = { north: "North up", head: "Head up", berth: "Berth up" };
const ZOOM_STEP = 1.35;
/** After this time labels may change their places without need. */
/** What is farther from a tug does not make her plan smaller [m]. */
const NEAR_TUG_M = 400;
const SETTLE_MS = 2000;
/** Time after which what lies over the canvas is measured again. */
const LOOK_MS = 100;
const MOST_WIDTHS = 1000;
/** A pointer that moved less was a click or a tap. */
const TAP_PX = 6;

/** With the labels of the last drawing, for tests, which cannot read a canvas. */
type PlanCanvas = HTMLCanvasElement & { labelled?: { placed: Placed[]; taken: Box[] } };

/** A canvas of at most this width is a phone's. */
const PHONE_PX = 480;
/** A plan narrower than this has no room for its scale bar beside the tools [px]. */
const TOOLS_PX = 900;
/** On a broader plan the buttons are beside the rose. */
const ROSE_PX = 790;

export class Plan implements View {
  readonly root: HTMLElement;
  private readonly surface: ReturnType<typeof canvas> & { root: PlanCanvas } = canvas(
    "Plan of ship, berth, tugs and lines",
  );
  private camera: Camera = { centre: [0, 0], pixels_per_m: 1, up_rad: 0, width: 1, height: 1 };
  private looked = false;
  /** The next look shows everything, as *Fit* does. */
  private fits = false;
  private follows = true;
  /** Position of the followed ship when the camera was last moved with her [m]. */
  private lastShip: Pair | null = null;
  private up: Up = "north";
  private readonly pointers = new Map<number, Pair>();
  private readonly readout = new Motion("readout");
  private readonly onPlan = new PlanReadout();
  private readonly measuring = new Tools();
  private readonly safety = new Safety(() => this.draught());
  /** The pointer that turns the bearing line. */
  private turning: number | null = null;
  private readonly tools: HTMLElement;
  /** The boxes of what lies over the canvas. */
  private covered: Box[] = [];
  /** The place of each label in the last drawing, by its key. */
  private readonly places = new Map<string, number>();
  private settled_ms = -Infinity;
  private looked_ms = -Infinity;
  private readonly widths = new Widths();
  private readonly followButton = button("Follow", () => this.follow(), {
    name: "Follow the ship (F)",
    "aria-pressed": "true",
  });
  private readonly upButton = button("North up", () => this.turnUp(), {
    name: "North up: which way is up (U)",
  });
  private prediction = true;
  private readonly pathButton = button("Path", () => this.togglePath(), {
    name: "Predicted path (V)",
    "aria-pressed": "true",
  });

  constructor(
    private readonly live: Live,
    /** `null` where nobody steers. */
    private readonly trial: Trial | null = null,
    /** `null` where nobody places ships. */
    private readonly placing: Placing | null = null,
  ) {
    this.tools = h(
      "div",
      { class: "plan-tools", role: "toolbar", "aria-label": "Plan" },
      this.measuring.row,
      this.safety.row,
      button("+", () => this.zoom(ZOOM_STEP), { name: "Zoom in (+)" }),
      button("−", () => this.zoom(1 / ZOOM_STEP), { name: "Zoom out (−)" }),
      button("Fit", () => this.fit(), { name: "Fit: ship and berth (0)" }),
      this.followButton,
      this.upButton,
      this.pathButton,
      this.measuring.opener,
      this.safety.opener,
    );
    this.root = h(
      "section",
      { class: "plan", "aria-label": "Plan view" },
      this.readout.root,
      h(
        "div",
        { class: "plan-surface" },
        this.surface.root,
        this.onPlan.root,
        this.measuring.cursor,
        this.tools,
      ),
    );
    this.listen();
  }

  /** Adds a button at the end of the plan's tools. */
  addTool(tool: HTMLButtonElement): void {
    this.tools.append(tool);
  }

  tick(frame: Frame): void {
    this.readout.tick(frame, this.live);
    this.onPlan.tick(frame, this.live);
  }

  zoom(by: number, about?: Pair): void {
    const { width, height } = this.camera;
    // A ship that is followed stays where she is on the screen.
    const ship = this.follows && this.shipNow(performance.now());
    const own = ship && toScreen(this.camera, [ship[0], ship[1]]);
    const isSeen = own && own[0] > 0 && own[1] > 0 && own[0] < width && own[1] < height;
    this.camera = zoomed(this.camera, by, about ?? (isSeen ? own : [width / 2, height / 2]));
  }

  /** Shows ship and berth, however far apart they are. */
  fit(): void {
    this.looked = false;
    this.fits = true;
    this.setFollow(true);
  }

  /** Shows ship and berth, and stands still while ships are placed. */
  standStill(): void {
    this.looked = false;
    this.lastShip = null;
    this.setFollow(false);
  }

  follow(): void {
    this.setFollow(!this.follows);
  }

  togglePath(): void {
    this.prediction = !this.prediction;
    setAttribute(this.pathButton, "aria-pressed", String(this.prediction));
  }

  /** Shows and hides the measuring tools. */
  measure(): void {
    this.measuring.open();
  }

  /** Shows and hides the choice of the safety contour. */
  depths(): void {
    this.safety.open();
  }

  turnUp(): void {
    const order: Up[] = this.live.hello?.berth ? ["north", "head", "berth"] : ["north", "head"];
    this.setUp(order[(order.indexOf(this.up) + 1) % order.length] ?? "north");
  }

  private setUp(up: Up): void {
    this.up = up;
    setText(this.upButton, UP_NAMES[up]);
    setAttribute(this.upButton, "aria-label", `${UP_NAMES[up]}: which way is up (U)`);
    // Turns about the ship if she is followed.
    this.turn();
    const ship = this.shipNow(performance.now());
    if (ship && this.follows) this.camera.centre = [ship[0], ship[1]];
  }

  private setFollow(on: boolean): void {
    this.follows = on;
    setAttribute(this.followButton, "aria-pressed", String(on));
    const ship = this.shipNow(performance.now());
    if (on && ship) this.camera.centre = [ship[0], ship[1]];
    this.lastShip = null;
  }

  /** The draught of the ship that the page is about, else the deepest one [m]. */
  private draught(): number {
    const { live } = this;
    const own = live.vessel(live.ship());
    if (own && !own.is_tug) return own.draught_m;
    return Math.max(0, ...(live.hello?.vessels ?? []).map((v) => v.draught_m));
  }

  /** Height of the values of the passage plan over the canvas [px]. */
  private planHeight(): number {
    return this.onPlan.isShown ? this.onPlan.root.offsetHeight : 0;
  }

  private shipNow(now_ms: number): BodyNow | null {
    return this.live.bodies(now_ms)[this.live.readBody()] ?? null;
  }

  /** Turns the camera to the chosen bearing. */
  private turn(now_ms = performance.now()): void {
    const { hello } = this.live;
    if (this.up === "north") this.camera.up_rad = 0;
    else if (this.up === "berth" && hello?.berth) {
      const heading = this.live.bodies(now_ms)[hello.berth.body]?.[2] ?? 0;
      this.camera.up_rad = heading + Math.atan2(-hello.berth.facing[1], -hello.berth.facing[0]);
    } else this.camera.up_rad = this.shipNow(now_ms)?.[2] ?? 0;
  }

  draw(now_ms: number): void {
    const begun = this.surface.begin();
    const { hello, frame } = this.live;
    if (!begun || !hello || !frame) return;
    const { to, width, height } = begun;
    const resized = width !== this.camera.width || height !== this.camera.height;
    this.camera = { ...this.camera, width, height };
    const bodies = this.live.bodies(now_ms);
    if (!this.looked || (resized && this.follows)) this.firstLook(bodies);
    this.turn(now_ms);
    this.followShip(now_ms);
    const colours = palette();
    const all: scene.Scene = {
      to,
      camera: this.camera,
      colours,
      hello,
      frame,
      bodies,
      live: this.live,
      t_s: this.live.time(now_ms),
      limits: limits(this.draught(), this.safety.clearance_m),
      labels: [],
    };
    scene.drawWater(all);
    drawChart(all);
    scene.drawGrid(all);
    scene.drawLand(all);
    drawChartMarks(all);
    drawFog(all);
    drawPlace(all);
    drawPassagePlan(all);
    scene.drawBerth(all);
    if (this.prediction) {
      scene.drawOtherPaths(all);
      scene.drawPrediction(all);
    }
    scene.drawHulls(all);
    drawTraffic(all);
    drawGhost(all);
    scene.drawFenders(all);
    scene.drawBollards(all);
    scene.drawLines(all);
    drawAnchors(all);
    scene.drawVectorTugs(all);
    scene.drawContacts(all);
    drawPassages(all);
    if (this.prediction) scene.drawMinutes(all);
    const trial = drawTrial(all, this.trial);
    scene.drawBowAndStern(all);
    drawPlacing(all, this.placing);
    const ship = bodies[this.live.readBody()];
    if (ship) this.measuring.draw({ ...all, ship });
    const beyond = ship ? drawBeyond(all, [ship[0], ship[1]], this.planHeight()) : [];
    const taken = [
      ...beyond,
      drawRose(to, this.camera, colours, frame, this.planHeight()),
      ...trial,
    ];
    if (this.measuring.has("scale"))
      taken.push(drawScale(to, this.camera, colours, this.planHeight()));
    this.label(to, all.labels, taken, colours, now_ms);
    // For tests, which cannot read a canvas.
    const { centre, pixels_per_m } = this.camera;
    setAttribute(
      this.surface.root,
      "data-view",
      [...centre, pixels_per_m].map((n) => n.toFixed(3)).join(" "),
    );
    setAttribute(
      this.surface.root,
      "data-hidden",
      String(bodies.filter((body) => body === null).length),
    );
  }

  /** Draws the labels. `taken`: boxes that are kept free of them, as the buttons over the canvas are. */
  private label(
    to: CanvasRenderingContext2D,
    labels: Label[],
    taken: Box[],
    colours: Palette,
    now_ms: number,
  ): void {
    // Now and then each label may go back to where it belongs.
    if (now_ms - this.settled_ms > SETTLE_MS) {
      this.settled_ms = now_ms;
      this.places.clear();
    }
    if (now_ms - this.looked_ms > LOOK_MS) {
      this.looked_ms = now_ms;
      this.covered = [this.tools, this.measuring.cursor, this.onPlan.root].map(
        ({ offsetLeft, offsetTop, offsetWidth, offsetHeight }) => [
          offsetLeft,
          offsetTop,
          offsetWidth,
          offsetHeight,
        ],
      );
    }
    const { width, height } = this.camera;
    const boxes = [...taken, ...this.covered];
    const placed = place(labels, [width, height], boxes, this.places, (label) =>
      this.widths.of(to, label),
    );
    for (const each of placed) {
      this.places.set(each.label.key, each.place);
      drawLabel(to, each, colours.label);
    }
    this.surface.root.labelled = { placed, taken: boxes };
  }

  private firstLook(bodies: (BodyNow | null)[]): void {
    const { hello } = this.live;
    if (!hello) return;
    const first = !this.looked && this.lastShip === null && this.camera.pixels_per_m === 1;
    this.looked = true;
    const ship = this.shipNow(performance.now());
    const all = scene.firstLook(hello, bodies, this.live, this.fits);
    // A tugmaster's own vessel is in the middle, with what is near her.
    const isTug = this.live.readBody() !== this.live.body();
    const places = isTug && ship ? around([ship[0], ship[1]], all, NEAR_TUG_M) : all;
    if (
      first &&
      hello.berth &&
      hello.fenders.length > 0 &&
      this.camera.width > this.camera.height * 1.2
    )
      this.setUp("berth");
    this.turn();
    // Where there is room, clear of the rose in the corner.
    const sides = this.camera.width > TOOLS_PX / 1.5 ? 112 : 64;
    this.camera = fitted(this.camera, places, [58 + this.planHeight(), sides, 74]);
    // A followed ship keeps her place on the screen, not its centre, so that the berth stays in view too.
    this.lastShip = ship ? [ship[0], ship[1]] : null;
  }

  private followShip(now_ms: number): void {
    const ship = this.shipNow(now_ms);
    if (!ship || !this.follows) return;
    const place: Pair = [ship[0], ship[1]];
    if (this.lastShip) this.camera.centre = add(this.camera.centre, minus(place, this.lastShip));
    this.lastShip = place;
  }

  private listen(): void {
    const surface = this.surface.root;
    const at = (event: PointerEvent | WheelEvent): Pair => {
      const box = surface.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    let pressed: Pair | null = null;
    // A drag selects no texts of the page.
    surface.addEventListener("mousedown", (event) => event.preventDefault());
    surface.addEventListener("pointerdown", (event) => {
      surface.setPointerCapture(event.pointerId);
      const now = at(event);
      const { hello } = this.live;
      const bodies = this.live.bodies(performance.now());
      if (hello && this.placing?.takes(this.camera, hello, bodies, event.pointerId, now)) return;
      if (this.measuring.takes(this.camera, this.shipNow(performance.now()), now)) {
        this.turning = event.pointerId;
        return;
      }
      // A second finger makes it a pinch.
      pressed = this.pointers.size === 0 ? now : null;
      this.pointers.set(event.pointerId, now);
    });
    surface.addEventListener("pointermove", (event) => {
      const now = at(event);
      this.measuring.over(this.camera, now);
      if (this.placing?.move(this.camera, event.pointerId, now)) return;
      if (this.turning === event.pointerId)
        this.measuring.turn(this.camera, this.shipNow(performance.now()), now);
      if (pressed && Math.hypot(...minus(now, pressed)) > TAP_PX) pressed = null;
      const before = this.pointers.get(event.pointerId);
      if (!before) return;
      const other = [...this.pointers].find(([id]) => id !== event.pointerId)?.[1];
      this.pointers.set(event.pointerId, now);
      if (other) {
        const [was, is] = [before, now].map((p) => Math.hypot(p[0] - other[0], p[1] - other[1]));
        if (was && is && was > 10)
          this.zoom(is / was, [(now[0] + other[0]) / 2, (now[1] + other[1]) / 2]);
        return;
      }
      this.camera.centre = add(
        this.camera.centre,
        minus(toEarth(this.camera, before), toEarth(this.camera, now)),
      );
      // Dragging changes the offset; the ship is still followed.
    });
    for (const end of ["pointerup", "pointercancel"] as const) {
      surface.addEventListener(end, (event) => {
        if (this.placing?.end(event.pointerId, end === "pointerup")) return;
        if (this.turning === event.pointerId) this.turning = null;
        if (pressed && end === "pointerup" && this.pointers.has(event.pointerId))
          this.measuring.tap(this.camera, pressed);
        pressed = null;
        this.pointers.delete(event.pointerId);
      });
    }
    surface.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        this.zoom(Math.exp(-event.deltaY * 0.0015), at(event));
      },
      { passive: false },
    );
  }
}

/** Widths of texts, which a canvas is slow to measure. */
class Widths {
  private readonly known = new Map<string, number>();

  of(to: CanvasRenderingContext2D, label: Label): number {
    const font = labelFont(label);
    const key = `${font} ${label.text}`;
    let width = this.known.get(key);
    if (width === undefined) {
      if (this.known.size >= MOST_WIDTHS) this.known.clear();
      to.font = font;
      width = to.measureText(label.text).width;
      this.known.set(key, width);
    }
    return width;
  }
}

/** The scale bar. Returns its box. */
function drawScale(
  to: CanvasRenderingContext2D,
  camera: Camera,
  colours: Palette,
  below: number,
): Box {
  const long = roundLength(Math.min(180, camera.width * 0.25) / camera.pixels_per_m);
  // On a phone and on a tablet the tools take the foot.
  const [left, top] = [14, camera.width < TOOLS_PX ? below + 18 : camera.height - 16];
  const right = left + long * camera.pixels_per_m;
  stroke(to, [left, top], [right, top], colours.text, 3);
  for (const x of [left, (left + right) / 2, right])
    stroke(to, [x, top - 6], [x, top + 1.5], colours.text, 2);
  const text = long >= 1000 ? `${fixed(long / 1000, 0)} km` : `${long} m`;
  const box: Box = [right + 6, top - 12, text.length * 8 + 12, 19];
  const label: Label = {
    key: "scale",
    text,
    rank: Rank.Measure,
    at: [right, top],
    colour: colours.text,
    size: 13,
  };
  drawLabel(to, { label, box, place: 0, leads: false }, "transparent");
  return [left, top - 12, box[0] + box[2] - left, 19];
}

/** North, wind and current around one small rose, in the corner that the quay seldom covers. Returns its box. */
function drawRose(
  to: CanvasRenderingContext2D,
  camera: Camera,
  colours: Palette,
  frame: Frame,
  above: number,
): Box {
  const radius = camera.width < PHONE_PX ? 22 : 34;
  // In the lower corner, where the buttons leave it free; else below the scale.
  const isLow = camera.width >= ROSE_PX;
  const centre: Pair = [radius + 24, isLow ? camera.height - radius - 52 : above + radius + 54];
  const on = (bearing: number, far: number): Pair => {
    const angle = bearing - camera.up_rad;
    return [centre[0] + Math.sin(angle) * far, centre[1] - Math.cos(angle) * far];
  };
  to.beginPath();
  to.arc(centre[0], centre[1], radius, 0, 2 * Math.PI);
  to.fillStyle = colours.label;
  to.fill();
  to.strokeStyle = colours.dim;
  to.lineWidth = 1;
  to.stroke();
  stroke(to, on(0, radius - 6), on(0, radius), colours.text, 2);
  to.fillStyle = colours.text;
  to.font = `600 13px ${FONT}`;
  to.textAlign = "center";
  to.textBaseline = "middle";
  to.fillText("N", ...on(0, radius + 9));
  const { wind, current } = frame;
  if (wind.speed_mps > 0.1)
    arrow(to, on(wind.from_rad, radius), on(wind.from_rad, -radius * 0.25), colours.wind, 3.5);
  if (current.speed_mps > 0.01)
    arrow(
      to,
      on(current.to_rad, -radius * 0.6),
      on(current.to_rad, radius * 0.7),
      colours.current,
      3.5,
    );
  // With the letter around it.
  const far = radius + 17;
  return [centre[0] - far, centre[1] - far, 2 * far, 2 * far];
}
