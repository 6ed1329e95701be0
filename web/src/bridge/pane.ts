/**
 * The view out of the window as a part of the page: canvas, buttons for the places of the eye, looking around by drag, touch
 * and keys. What draws the picture is loaded when the view is first shown. Without it the page stays usable and says so.
 */
import { bearingOf } from "./bearing";
import { Film } from "./film";
import { figures } from "./in_picture";
import { placed } from "./labels";
import {
  EYES,
  EYE_LIMITS_M,
  EYE_NAMES,
  type Eye,
  type Look,
  USUAL_EYE_M,
  VIEW_LIMITS,
  lookOf,
} from "./look";
import type { Picture } from "./picture";
import { isSoftware } from "./software";
import { writeInto } from "./written";
import { hasHeadset, whyNot } from "./xr";
import { fileNameOf } from "../file_name";
import { clamp } from "../geometry";
import { Motion } from "../instruments/motion";
import type { Live } from "../live";
import type { PaletteName } from "../palette";
import type { Frame, Hello, Pair } from "../protocol";
import { button, h, setAttribute, setClass, setText } from "../ui/dom";
import { fixed, heading, spoken, toDegrees, wrapped } from "../units";

const DEG = Math.PI / 180;
/** A key turns the eye by this share of the angle of view. */
const KEY_SHARE = 0.12;
const ZOOM_STEP = 1.25;
/** A key lifts the eye by so much [m]. */
const LIFT_STEP_M = 0.1;
/** Size of the picture of the largest fender load [px]. */
const MOMENT: Pair = [1280, 720];
/** Slower drawing than this makes the picture coarser [ms]. */
const SLOW_MS = 45;
const SLOWEST_MS = 125;
/** Drawings whose time of script is remembered. */
const REMEMBERED = 40;
/** Time between two changes of the detail [ms]. */
const SETTLES_MS = 2500;
const LEAST_DETAIL = 0.5;
const DETAIL_STEP = 0.75;
/** Quicker drawing than this, for so long, makes the picture finer again [ms]. */
const QUICK_MS = 22;
const REFINES_MS = 10_000;
/** A longer time between two drawings is a pause [ms]. */
const PAUSE_MS = 1000;
/** A browser has fetched a saved picture by then [ms]. */
const SAVED_MS = 10_000;
/** Distances of the free eye [m]. */
const OFF_LIMITS: Pair = [25, 3000];

/** The size of the words over the picture is asked again after this time [ms]. */
const MEASURED_EVERY_MS = 500;
/** A view in which nothing has changed for so many drawings rests: it is drawn anew after this time only [ms]. */
const DRAWINGS_TO_REST = 4;
const RESTS_MS = 1000;
/** How often the loading of the view is looked at before it counts as failed. */
const LOADS_IN = 300;

/** How the view shares the place of the plan with it. */
export type Share = "plan" | "view" | "both";

export interface Around {
  /** Shares the place with the plan, and closes the view. */
  share(how: Share): void;
  say(text: string): void;
  /** The bytes of the user's model of a vessel, by its number and the name of its file. Fails with the reason. */
  model(vessel: number, file: string): Promise<ArrayBuffer>;
}

export class Pane {
  private readonly canvas = h("canvas", {
    role: "img",
    tabindex: "0",
    "aria-label": "View out of the window",
  });
  private readonly caption = h("p", { class: "window-caption", "aria-live": "off" });
  /** Figures over the picture, and labels in it. */
  private readonly figures = h("div", { class: "window-figures hidden", "aria-live": "off" });
  private readonly words = h("div", { class: "window-words" }, this.caption, this.figures);
  private readonly labels = h("div", { class: "window-labels", "aria-hidden": "true" });
  private readonly motion = new Motion("motion");
  private readonly film = new Film();
  private readonly message = h("p", { class: "window-message hidden", role: "status" });
  private readonly marksButton = button("Marks", () => this.toggleMarks(), {
    name: "Marks: distances, path, forces and loads in the picture (M)",
    "aria-pressed": "false",
  });
  private readonly filmButton = button("Film", () => void this.roll(), {
    name: "Film: record this view into a file, until pressed again",
    "aria-pressed": "false",
  });
  private readonly headsetButton = button("Headset", () => void this.wear(), {
    name: "Headset: look around in a headset from this place, until pressed again",
    "aria-pressed": "false",
    class: "hidden",
  });
  private readonly eyes: [Eye, HTMLButtonElement][];
  private readonly bothButton = button("Both", () => this.both(), {
    name: "Both: plan below the view, or not",
    "aria-pressed": "false",
  });
  readonly root: HTMLElement;
  private picture: Picture | null = null;
  private state: "closed" | "loading" | "open" | "failed" | "lost" = "closed";
  private built: Hello | null = null;
  private readonly pointers = new Map<number, Pair>();
  private look: Look = {
    eye: "bridge",
    vessel: 0,
    bollard: 0,
    turn_rad: 0,
    raise_rad: 0,
    view_rad: null,
    off_m: 320,
    lifted_m: 0,
    fender: null,
    marks: false,
    panorama_rad: null,
  };
  /** The look that each eye was left with. */
  private readonly left = new Map<Eye, Pick<Look, "turn_rad" | "raise_rad" | "view_rad">>();
  private detail = 1;
  /** The last change of the detail made the picture finer. */
  private refined = false;
  /** The picture must be quick for so long before it is made finer [ms]. */
  private refines_ms = REFINES_MS;
  private interval_ms = 16;
  private drawn_ms = 0;
  private turns = 0;
  private settled_ms = 0;
  /** Time of script of the last drawings [ms]. */
  private readonly scripts: number[] = [];
  private palette: PaletteName = "day";

  constructor(
    private readonly live: Live,
    private readonly around: Around,
    search = "",
  ) {
    const asked = lookOf(search);
    if (asked) Object.assign(this.look, asked);
    // One of several windows of a panorama keeps the direction and the angle that its address gives.
    if (asked && asked.panorama_rad !== null) {
      const { turn_rad, panorama_rad } = asked;
      this.lookAsked = { turn_rad, panorama_rad };
    }
    this.asked = asked === null ? null : asked.panorama_rad === null ? "view" : "alone";
    this.eyes = EYES.map((eye, i) => [
      eye,
      button(EYE_NAMES[eye][0], () => this.choose(eye), {
        name: `${EYE_NAMES[eye][0]}: view from the ${EYE_NAMES[eye][1]} (${i + 1})`,
        "aria-pressed": "false",
      }),
    ]);
    this.root = h(
      "section",
      { class: "window", "aria-label": "View out of the window" },
      this.motion.root,
      h("div", { class: "window-picture" }, this.canvas, this.labels, this.words, this.message),
      h(
        "div",
        { class: "window-tools", role: "toolbar", "aria-label": "View" },
        ...this.eyes.map(([, each]) => each),
        button("+", () => this.zoom(ZOOM_STEP), { name: "Narrower view (+)" }),
        button("−", () => this.zoom(1 / ZOOM_STEP), { name: "Wider view (−)" }),
        button("Reset", () => this.reset(), { name: "Reset: look ahead again (Home)" }),
        this.marksButton,
        button("Picture", () => void this.save(), { name: "Picture: save this view" }),
        this.filmButton,
        this.headsetButton,
        this.bothButton,
        button("Plan", () => this.around.share("plan"), { name: "Plan: close the view (,)" }),
      ),
    );
    setAttribute(this.marksButton, "aria-pressed", String(this.look.marks));
    this.listen();
  }

  /** Whether this page may show marks: an exercise may leave them to the instructor. */
  private mayMark(): boolean {
    const { role, exercise } = this.live.hello ?? {};
    return role?.name === "instructor" || exercise?.view_marks !== false;
  }

  private toggleMarks(): void {
    if (!this.mayMark()) return this.around.say("This exercise has no marks in the view.");
    this.look.marks = !this.look.marks;
    setAttribute(this.marksButton, "aria-pressed", String(this.look.marks));
    this.drawLabels();
  }

  /** What the address of the page asks for: a view, or nothing but a view; `null` if it asks for no view. */
  readonly asked: "view" | "alone" | null;

  /** Shows how the view shares its place. */
  shares(how: Share): void {
    setAttribute(this.bothButton, "aria-pressed", String(how === "both"));
    if (how === "plan") return;
    if (this.state === "closed") void this.load();
  }

  private both(): void {
    this.around.share(this.bothButton.getAttribute("aria-pressed") === "true" ? "view" : "both");
  }

  private async load(): Promise<void> {
    this.state = "loading";
    this.tell("Loading the view …");
    try {
      const { Picture } = await import("./picture");
      this.picture = new Picture(this.canvas, this.live, {
        cheap: isSoftware(),
        model: (vessel, file) => this.around.model(vessel, file),
      });
      this.picture.palette(this.palette);
      this.state = "open";
      this.tell("");
      setClass(this.headsetButton, "hidden", !(await hasHeadset(navigator.xr)));
    } catch (error) {
      this.state = "failed";
      this.tell(
        "This browser draws no view: it has no WebGL, or the view could not be loaded. Plan and instruments work as before.",
      );
      setAttribute(this.root, "data-why", error instanceof Error ? error.message : String(error));
    }
  }

  private tell(text: string): void {
    setText(this.message, text);
    setClass(this.message, "hidden", text === "");
  }

  setPalette(name: PaletteName): void {
    this.palette = name;
    this.picture?.palette(name);
  }

  // ------------------------------------------------------------------------------------------------------- eyes

  private choose(eye: Eye): void {
    const again = eye === this.look.eye;
    this.look.fender = null;
    if (eye === "tug") this.look.vessel = this.next(this.tugs(), again ? this.look.vessel : null);
    else if (eye === "bollard") this.look.bollard = this.nextBollard(again);
    if (!again) {
      const { turn_rad, raise_rad, view_rad } = this.look;
      this.left.set(this.look.eye, { turn_rad, raise_rad, view_rad });
      Object.assign(
        this.look,
        this.left.get(eye) ?? { turn_rad: 0, raise_rad: 0, view_rad: null },
        { eye, panorama_rad: null },
        // One of several windows keeps its direction, whatever the eye.
        this.lookAsked,
      );
    }
    if (eye !== "tug") this.look.vessel = this.live.conned();
    this.mark();
  }

  /** Chooses the eye with a number from 1. */
  private numbered(number: number): boolean {
    const found = this.eyes[number - 1];
    if (!found || found[1].hidden) return false;
    this.choose(found[0]);
    return true;
  }

  private next(all: number[], now: number | null): number {
    const at = now === null ? -1 : all.indexOf(now);
    return all[(at + 1) % Math.max(1, all.length)] ?? 0;
  }

  /** The tugs as numbers of a look: first the own tug of a tugmaster. */
  private tugs(): number[] {
    const { vessels = [], tugs = [] } = this.live.hello ?? {};
    const all = vessels.flatMap(({ is_tug }, i) => (is_tug ? [i] : []));
    all.push(...tugs.map((_, i) => vessels.length + i));
    const own = this.ownTug();
    return own === null ? all : [own, ...all.filter((each) => each !== own)];
  }

  /** The tugmaster's own tug, as the number of a look. */
  private ownTug(): number | null {
    const { role, vessels } = this.live.hello ?? {};
    if (role?.name !== "tugmaster") return null;
    const conned = this.live.conned();
    return vessels?.[conned]?.is_tug ? conned : this.ownVector();
  }

  /** The own vector tug of a tugmaster, as the number of a look. */
  private ownVector(): number | null {
    const { role, vessels, tugs } = this.live.hello ?? {};
    if (role?.name !== "tugmaster" || !vessels || !tugs) return null;
    const own = tugs.findIndex(({ name }) => name === role.tug);
    return own < 0 ? null : vessels.length + own;
  }

  /** The bollard in the middle at first, then the next. */
  private nextBollard(again: boolean): number {
    const count = this.live.hello?.bollards.length ?? 0;
    if (again) return (this.look.bollard + 1) % Math.max(1, count);
    return this.left.has("bollard") ? this.look.bollard : Math.floor(count / 2);
  }

  private mark(): void {
    const { hello } = this.live;
    for (const [eye, each] of this.eyes) {
      setAttribute(each, "aria-pressed", String(eye === this.look.eye));
      const isThere =
        eye === "tug"
          ? this.tugs().length > 0
          : eye === "bollard"
            ? (hello?.bollards.length ?? 0) > 0
            : true;
      if (each.hidden === isThere) each.hidden = !isThere;
    }
  }

  /** Name of the place, direction and angle of view. */
  private describe(now_ms: number): void {
    const { hello } = this.live;
    if (!this.picture || !hello) return;
    const { elevation_rad, view_rad, ...gaze } = this.picture.gaze();
    const { eye, vessel, bollard } = this.look;
    const [, words] = EYE_NAMES[eye];
    const whose =
      eye === "bollard"
        ? spoken(hello.bollards[bollard]?.name ?? "")
        : spoken((hello.vessels[vessel] ?? hello.tugs[vessel - hello.vessels.length])?.name ?? "");
    const { bearing_rad, side_rad } = bearingOf(
      this.look,
      gaze.bearing_rad,
      hello,
      this.live.bodies(now_ms),
      this.live.seenBodies(now_ms),
    );
    const relative =
      side_rad === null
        ? ""
        : Math.abs(side_rad) < 0.5 * DEG
          ? " (ahead)"
          : Math.abs(side_rad) > 179.5 * DEG
            ? " (astern)"
            : ` (${side_rad < 0 ? "P" : "S"} ${fixed(Math.abs(toDegrees(side_rad)), 0)}°)`;
    setText(
      this.caption,
      `${words.replace(/^./, (c) => c.toUpperCase())}${whose ? `, ${whose}` : ""}: ${heading(bearing_rad, 0)}${relative}, ${elevation_rad < 0 ? "down" : "up"} ${fixed(Math.abs(toDegrees(elevation_rad)), 0)}°, view ${fixed(toDegrees(view_rad), 0)}°${this.detail < 1 ? "; coarse, because this machine draws slowly" : ""}${this.lift()}${this.picture.troubles.map((each) => `; ${each}`).join("")}`,
    );
    setAttribute(
      this.canvas,
      "aria-label",
      `View from the ${words}${whose ? ` of ${whose}` : ""}, towards ${heading(bearing_rad, 0)}`,
    );
  }

  private lift(): string {
    const { lifted_m, eye } = this.look;
    if (eye === "free" || eye === "bollard" || Math.abs(lifted_m) < 0.01) return "";
    return `; eye ${fixed(USUAL_EYE_M + lifted_m, 1)} m above the deck`;
  }

  private described_ms = 0;
  private drawings = 0;

  private measured_ms = -Infinity;
  /** Right and lower edge of the words over the picture [px]. */
  private wordsTo: Pair = [0, 0];

  /** The figures over the picture. The row above the picture has the motion of the page's own vessel already, unless `all`. */
  private figureText(frame: Frame, hello: Hello, all: boolean): string {
    const ofEye = this.look.vessel;
    const vessel = hello.vessels[ofEye] ? ofEye : this.live.ship();
    const isOwn = vessel === this.live.conned();
    const lines = figures(frame, hello, vessel, this.live.ship(), isOwn && !all);
    if (!isOwn && lines[0] !== undefined)
      lines[0] = `${spoken(hello.vessels[vessel]?.name ?? "")}: ${lines[0]}`;
    return lines.join("\n");
  }

  private measureWords(): void {
    const now_ms = performance.now();
    if (now_ms - this.measured_ms < MEASURED_EVERY_MS) return;
    this.measured_ms = now_ms;
    const all = [this.caption, this.figures].filter((each) => each.offsetHeight > 0);
    const { offsetLeft, offsetTop } = this.words;
    this.wordsTo = [
      Math.max(0, ...all.map((each) => offsetLeft + each.offsetLeft + each.offsetWidth)),
      all.length === 0 ? 0 : offsetTop + this.words.offsetHeight,
    ];
  }

  /** Figures and labels of the marks, at the places of this drawing. */
  private drawLabels(all = this.asked === "alone"): void {
    const { hello, frame } = this.live;
    const shown = this.look.marks && this.picture && hello && frame;
    setText(this.figures, shown ? this.figureText(frame, hello, all) : "");
    setClass(this.figures, "hidden", this.figures.textContent === "");
    const { clientWidth, clientHeight } = this.labels;
    const seen = shown ? (this.picture?.labelled([clientWidth, clientHeight]) ?? []) : [];
    if (seen.length > 0) this.measureWords();
    const labels = placed(seen, this.wordsTo);
    while (this.labels.children.length < labels.length) this.labels.append(h("span"));
    [...this.labels.children].forEach((each, i) => {
      const label = labels[i];
      const span = each as HTMLElement;
      if (span.hidden !== !label) span.hidden = !label;
      if (!label) return;
      setText(span, label.text);
      span.className = label.level;
      span.style.left = `${label.x.toFixed(1)}px`;
      span.style.top = `${label.y.toFixed(1)}px`;
    });
  }

  // ---------------------------------------------------------------------------------------------------- drawing

  private moved: Frame | null = null;

  draw(now_ms: number): void {
    const { canvas, picture } = this;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    const { hello, frame } = this.live;
    if (frame && frame !== this.moved && this.root.offsetParent !== null) {
      this.moved = frame;
      this.motion.tick(frame, this.live);
    }
    // A headset has its own turns.
    if (picture?.headset.runs) return;
    if (!picture || this.state !== "open" || !hello || !frame || width === 0 || height === 0) {
      this.drawn_ms = 0;
      return;
    }
    if (this.rests(now_ms)) {
      this.drawn_ms = 0;
      return;
    }
    // On a machine that is slow even with a coarse picture the instruments have every second turn for themselves.
    this.turns += 1;
    if (this.detail <= LEAST_DETAIL && this.interval_ms > SLOWEST_MS && this.turns % 2 === 0)
      return;
    const since_ms = now_ms - this.drawn_ms;
    // After a pause, as of a page behind another, the time since the last drawing says nothing of the machine.
    if (this.drawn_ms > 0 && since_ms < PAUSE_MS)
      this.interval_ms += 0.1 * (since_ms - this.interval_ms);
    else this.settled_ms = now_ms;
    this.drawn_ms = now_ms;
    this.settle(now_ms);
    const begun = performance.now();
    const ratio = Math.min(2, window.devicePixelRatio || 1) * this.detail;
    const sized = `${width} ${height} ${ratio}`;
    if (canvas.dataset.sized !== sized) {
      canvas.dataset.sized = sized;
      picture.resize(width, height, ratio);
    }
    this.rebuild(picture, hello, now_ms);
    this.follow();
    picture.draw(now_ms, this.look);
    this.drawings += 1;
    if (this.look.marks) this.drawLabels();
    this.scripts.push(performance.now() - begun);
    if (this.scripts.length > REMEMBERED) this.scripts.shift();
    if (now_ms - this.described_ms > 200) {
      this.described_ms = now_ms;
      this.describe(now_ms);
      // For tests.
      canvas.dataset.script = median(this.scripts).toFixed(2);
      canvas.dataset.drawn = String(this.drawings);
      canvas.dataset.triangles = String(picture.triangles);
      canvas.dataset.interval = this.interval_ms.toFixed(1);
      canvas.dataset.shown = JSON.stringify(picture.shown());
    }
  }

  private seen = "";
  private unchanged = 0;
  private woke_ms = 0;

  /**
   * Whether another drawing would be as the last: the run is paused, and neither the eye nor the size has changed. A debriefing
   * would else keep a processor or a graphics card busy for nothing.
   */
  private rests(now_ms: number): boolean {
    const { canvas, live } = this;
    const size = [canvas.clientWidth, canvas.clientHeight, window.devicePixelRatio, this.detail];
    const { tick, run } = live.frame ?? {};
    const seen = JSON.stringify([this.look, this.palette, size, tick]);
    const same =
      run?.paused === true &&
      seen === this.seen &&
      live.hello === this.built &&
      live.share(now_ms) >= 1;
    this.seen = seen;
    this.unchanged = same ? this.unchanged + 1 : 0;
    const rests =
      this.unchanged > DRAWINGS_TO_REST && now_ms - this.woke_ms < RESTS_MS && !this.film.runs;
    if (!rests) this.woke_ms = now_ms;
    // The caption is of the last drawing.
    else if (this.unchanged === DRAWINGS_TO_REST + 1) this.describe(now_ms);
    return rests;
  }

  /** Builds the picture anew where the scenario has changed. */
  private rebuild(picture: Picture, hello: Hello, now_ms: number): void {
    if (this.built === hello) return;
    this.marksButton.hidden = !this.mayMark();
    if (this.marksButton.hidden && this.look.marks) {
      this.look.marks = false;
      setAttribute(this.marksButton, "aria-pressed", "false");
      this.drawLabels();
    }
    // Claims of helms come with a new greeting of the same scenario.
    if (!this.built || !isSame(this.built, hello)) {
      picture.build(hello, this.live.seenBodies(now_ms));
      const own = this.ownVector();
      if (!this.built && own !== null && this.asked === null)
        Object.assign(this.look, { eye: "tug", vessel: own });
      if (this.look.eye !== "tug") this.look.vessel = this.live.conned();
      else if (!this.tugs().includes(this.look.vessel))
        this.look.vessel = this.next(this.tugs(), null);
      this.mark();
    }
    this.built = hello;
  }

  private conned: number | null = null;
  private lookAsked: Partial<Look> = {};

  /** Goes with the page to another ship, where the instructor has chosen one. */
  private follow(): void {
    const conned = this.live.conned();
    if (this.conned !== null && this.conned !== conned && this.look.eye !== "tug") {
      this.look.vessel = conned;
      this.mark();
    }
    this.conned = conned;
  }

  /** Shows the view in a headset, or ends that. */
  private async wear(): Promise<void> {
    const { picture, canvas } = this;
    if (!picture || this.state !== "open" || !navigator.xr) return;
    const { headset } = picture;
    if (headset.runs) {
      await headset.stop();
      return;
    }
    const draws = () => {
      const now_ms = performance.now();
      const { hello } = this.live;
      if (hello) this.rebuild(picture, hello, now_ms);
      picture.draw(now_ms, this.look);
      // For tests.
      canvas.dataset.head = JSON.stringify(headset.head());
    };
    try {
      await headset.start(navigator.xr, draws, () => {
        setAttribute(this.headsetButton, "aria-pressed", "false");
        canvas.dataset.sized = "";
      });
      setAttribute(this.headsetButton, "aria-pressed", "true");
    } catch (error) {
      this.around.say(`The headset did not start: ${whyNot(error)}.`);
    }
  }

  /**
   * A slow machine gets a coarser picture, so that the instruments do not wait for it, and a finer one again when it is quick. Each
   * time that the finer picture was too slow again, the next try comes later.
   */
  private settle(now_ms: number): void {
    if (now_ms - this.settled_ms < SETTLES_MS) return;
    if (this.interval_ms > SLOW_MS && this.detail > LEAST_DETAIL) {
      this.settled_ms = now_ms;
      if (this.refined) this.refines_ms *= 2;
      this.refined = false;
      this.detail = Math.max(LEAST_DETAIL, this.detail * DETAIL_STEP);
      this.interval_ms = SLOW_MS * 0.8;
    } else if (
      this.interval_ms < QUICK_MS &&
      this.detail < 1 &&
      now_ms - this.settled_ms > this.refines_ms
    ) {
      this.settled_ms = now_ms;
      this.refined = true;
      this.detail = Math.min(1, this.detail / DETAIL_STEP);
    }
  }

  // ------------------------------------------------------------------------------------------------------- input

  zoom(by: number): void {
    if (this.look.eye === "free") {
      this.look.off_m = clamp(this.look.off_m / by, ...OFF_LIMITS);
      return;
    }
    const now = this.look.view_rad ?? this.picture?.gaze().view_rad ?? 0.8;
    const view = 2 * Math.atan(Math.tan(now / 2) / by);
    this.look.view_rad = clamp(view, ...VIEW_LIMITS);
    this.look.panorama_rad = null;
  }

  private reset(): void {
    Object.assign(this.look, {
      turn_rad: 0,
      ...this.lookAsked,
      raise_rad: 0,
      view_rad: null,
      lifted_m: 0,
      fender: null,
    });
    this.look.off_m = 320;
  }

  private turn(by_rad: number, up_rad: number): void {
    this.look.turn_rad = wrapped(this.look.turn_rad + by_rad);
    this.look.raise_rad = clamp(this.look.raise_rad + up_rad, -1.5, 1.5);
  }

  /** Own height of the eye above the deck. */
  private liftBy(by_m: number): void {
    const [least, most] = EYE_LIMITS_M;
    this.look.lifted_m = clamp(this.look.lifted_m + by_m, least - USUAL_EYE_M, most - USUAL_EYE_M);
  }

  private view(): number {
    return this.picture?.gaze().view_rad ?? 0.8;
  }

  private listenToPointers(): void {
    const { canvas } = this;
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
    });
    canvas.addEventListener("pointermove", (event) => {
      const before = this.pointers.get(event.pointerId);
      if (!before) return;
      const now: Pair = [event.clientX, event.clientY];
      const other = [...this.pointers].find(([id]) => id !== event.pointerId)?.[1];
      this.pointers.set(event.pointerId, now);
      if (other) {
        const [was, is] = [before, now].map((p) => Math.hypot(p[0] - other[0], p[1] - other[1]));
        if (was && is && was > 10) this.zoom(is / was);
        return;
      }
      // The picture goes with the finger.
      const per_px =
        this.look.eye === "free" ? 0.006 : this.view() / Math.max(1, canvas.clientHeight);
      this.turn(-(now[0] - before[0]) * per_px, (now[1] - before[1]) * per_px);
    });
    for (const end of ["pointerup", "pointercancel"] as const)
      canvas.addEventListener(end, (event) => this.pointers.delete(event.pointerId));
    canvas.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        this.zoom(Math.exp(-event.deltaY * 0.0015));
      },
      { passive: false },
    );
  }

  private listen(): void {
    const { canvas } = this;
    canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      this.state = "lost";
      this.tell(
        "The graphics of this machine stopped. Plan and instruments work as before; the view comes back by itself if it can.",
      );
    });
    canvas.addEventListener("webglcontextrestored", () => {
      this.state = "open";
      this.built = null;
      this.tell("");
    });
    // One of several windows of a panorama: turned or zoomed alone, it would no longer fit its neighbours.
    if (this.asked !== "alone") this.listenToPointers();
    // A button of the view that was pressed has the focus: the keys of the view work there too.
    this.root.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey) return;
      const step = this.view() * KEY_SHARE;
      const done: Record<string, () => void> = {
        ArrowLeft: () => this.turn(-step, 0),
        ArrowRight: () => this.turn(step, 0),
        ArrowUp: () => this.turn(0, step),
        ArrowDown: () => this.turn(0, -step),
        "+": () => this.zoom(ZOOM_STEP),
        "=": () => this.zoom(ZOOM_STEP),
        "-": () => this.zoom(1 / ZOOM_STEP),
        Home: () => this.reset(),
        PageUp: () => this.liftBy(LIFT_STEP_M),
        PageDown: () => this.liftBy(-LIFT_STEP_M),
        m: () => this.toggleMarks(),
      };
      const turns = /^(Arrow|[+=-]$)/.test(event.key);
      const act = turns && this.asked === "alone" ? () => {} : done[event.key];
      if (act) act();
      else if (!this.numbered(Number(event.key))) return;
      // The rudder has the same arrows elsewhere on the page.
      event.preventDefault();
      event.stopPropagation();
    });
  }

  /** Saves what is seen as a picture, with all detail. */
  private async save(): Promise<void> {
    const { picture, canvas } = this;
    if (!picture || this.state !== "open") return;
    if (picture.headset.runs) {
      this.around.say("The headset has the view: end that first, then save a picture.");
      return;
    }
    const width = Math.max(1280, Math.min(1920, 2 * canvas.clientWidth));
    const height = Math.round((width * canvas.clientHeight) / Math.max(1, canvas.clientWidth));
    await picture.dressed;
    const still = picture.still(width, height, this.look, performance.now());
    if (this.look.marks) this.write(still);
    // The canvas was used for the picture: a resting view is drawn again at once.
    this.unchanged = 0;
    const blob = await pngOf(still);
    if (!blob) {
      this.around.say("The browser made no picture of this view.");
      return;
    }
    this.keep(blob, this.look.eye, "png");
  }

  /** Writes the marks into a picture that is saved, with all figures: the picture has no row of motion above it. */
  private write(still: HTMLCanvasElement): void {
    // More figures are higher: the labels go below them.
    this.measured_ms = -Infinity;
    this.drawLabels(true);
    writeInto(still, this.canvas, [
      this.figures,
      ...(this.labels.children as Iterable<HTMLElement>),
    ]);
    this.measured_ms = -Infinity;
    this.drawLabels();
  }

  /** Hands a file to the browser, which saves it. */
  private keep(blob: Blob, what: string, ending: string): void {
    const url = URL.createObjectURL(blob);
    const t_s = Math.round(this.live.frame?.t_s ?? 0);
    const name = `${fileNameOf(this.live.hello?.title ?? "")}-${what}-${t_s}s.${ending}`;
    h("a", { href: url, download: name }).click();
    setTimeout(() => URL.revokeObjectURL(url), SAVED_MS);
  }

  /** Begins a film of the view, or ends it and saves the file. */
  private async roll(): Promise<void> {
    if (this.film.runs) {
      setAttribute(this.filmButton, "aria-pressed", "false");
      const film = await this.film.stop();
      if (film) this.keep(film, `${this.look.eye}-film`, "webm");
      else this.around.say("The film is empty: nothing was drawn meanwhile.");
      return;
    }
    if (this.state !== "open") return;
    const begun = this.film.start(this.canvas, (why) => {
      setAttribute(this.filmButton, "aria-pressed", "false");
      void this.film.stop();
      this.around.say(`The film broke off: ${why}.`);
    });
    if (begun) setAttribute(this.filmButton, "aria-pressed", "true");
    else this.around.say("This browser records no films of a view; Picture saves single pictures.");
  }

  /**
   * Looks at a fender from the edge of the quay and saves the picture. Resolves to whether a picture was made. The page has
   * gone to the moment before.
   */
  async fenderPicture(fender: number): Promise<boolean> {
    if (this.state === "closed") void this.load();
    for (let i = 0; i < LOADS_IN && this.state !== "open"; i++) {
      if (this.state === "failed" || this.state === "lost") return false;
      await new Promise((done) => setTimeout(done, 100));
    }
    const { picture } = this;
    const { hello } = this.live;
    if (!picture || !hello || picture.headset.runs) return false;
    // The picture may be of a scenario that was open before.
    this.rebuild(picture, hello, performance.now());
    const { turn_rad, raise_rad, view_rad, eye } = this.look;
    if (eye !== "free") this.left.set(eye, { turn_rad, raise_rad, view_rad });
    Object.assign(this.look, { eye: "free", fender, view_rad: null, panorama_rad: null });
    this.mark();
    await picture.dressed;
    const blob = await pngOf(picture.still(...MOMENT, this.look, performance.now()));
    if (blob) this.keep(blob, hello.fenders[fender]?.name ?? "fender", "png");
    return blob !== null;
  }
}

const median = (all: number[]): number =>
  all.toSorted((a, b) => a - b)[Math.floor(all.length / 2)] ?? 0;

const pngOf = (canvas: HTMLCanvasElement): Promise<Blob | null> =>
  new Promise((done) => canvas.toBlob(done, "image/png"));

/** Whether two greetings have the same things in the picture. */
function isSame(a: Hello, b: Hello): boolean {
  const of = ({
    file,
    bodies,
    vessels,
    fenders,
    lines,
    anchors,
    bollards,
    tugs,
    traffic,
    chart,
    role,
    sea,
    daylight,
    rain,
    highest_water_m,
    clearance_datum_m,
  }: Hello) =>
    JSON.stringify([
      file,
      bodies,
      vessels,
      fenders,
      lines,
      anchors,
      bollards,
      tugs,
      traffic,
      chart.map(({ kind, lines, clearance_m }) => [kind, lines[0]?.[0], clearance_m]),
      role,
      sea,
      daylight,
      rain,
      highest_water_m,
      clearance_datum_m,
    ]);
  return of(a) === of(b);
}
