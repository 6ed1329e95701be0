/** The tugmaster's helm: of a vector tug, or of a tug that is a vessel with azimuth units. */
import type { Page } from "../page";
import { limits } from "../orders";
import type {
  Action,
  Frame,
  Hello,
  Pair,
  TugInfo,
  TugNow,
  VesselInfo,
  VesselNow,
} from "../protocol";
import { button, choices, h, setAttribute, setClass, setText } from "../ui/dom";
import { Ring } from "../ui/ring";
import { Slider } from "../ui/slider";
import { TONNE_N, fixed, percent, sided, tonnes, tugCalled } from "../units";
import { ClaimBar, type Group, type KeyAction } from "./group";
import { VesselTug } from "./tugs";

const POWERS = [0, 25, 50, 75, 100];

/** The server's limits of a share, in percent, and the powers within them. */
function inPercent([least, most]: Pair): { least: number; most: number; powers: number[] } {
  const within = (p: number) => p >= least * 100 && p <= most * 100;
  return { least: least * 100, most: most * 100, powers: POWERS.filter(within) };
}

/** A vector tug: push or pull, with force and direction. */
export class VectorHelm implements Group {
  readonly name = "Tug";
  readonly root: HTMLElement;
  readonly keys: KeyAction[];
  private readonly claim: ClaimBar;
  readonly held: HTMLElement;
  private readonly ring: Ring;
  private readonly power: Slider;
  private readonly orders;
  private readonly powers;
  private readonly state = h("output", { class: "big", "aria-label": "Force on the ship" });
  private readonly ordered = h("span", { class: "ordered" });
  /** Why the tug obeys no order. */
  private readonly kept = h("p", { class: "note hidden", role: "status" });
  private readonly range;
  private percent = 25;
  private order: TugNow["order"] = "stop";
  /** The order was given in words, and no frame has its direction yet. */
  private inWords = false;
  private now: TugNow | null = null;

  constructor(
    private readonly page: Page,
    private readonly info: TugInfo,
    private readonly index: number,
    hello: Hello,
  ) {
    this.range = inPercent(hello.limits.tug_power);
    this.claim = new ClaimBar(page, { tug: info.name }, tugCalled(info.name));
    this.held = this.claim.held;
    this.ring = new Ring(`Direction of ${info.name}'s force on the ship`, "thrust", () => {
      this.inWords = false;
      this.send(true);
    });
    this.orders = choices<TugNow["order"]>(
      "Order",
      [
        { value: "push", label: "Push" },
        { value: "stop", label: "Stop" },
        { value: "pull", label: "Pull" },
      ],
      (order) => this.choose(order),
    );
    this.powers = choices(
      "Power",
      this.range.powers.map((p) => ({ value: p, label: `${p} %` })),
      (p) => this.setPower(p),
    );
    this.power = new Slider({
      label: "Power order",
      least: this.range.least,
      most: this.range.most,
      step: 5,
      say: (p) => `${p} % of ${tonnes(info.bollard_pull_n)}`,
      order: (p) => {
        this.percent = p;
        this.send(true);
      },
      marks: this.range.powers.map((p) => ({ at: p, text: String(p) })),
    });
    this.root = h(
      "div",
      { class: "group tugmaster", role: "group", "aria-label": `Helm of ${info.name}` },
      this.claim.root,
      h(
        "section",
        { class: "card", "aria-label": "Direction" },
        h("div", { class: "card-head" }, h("h3", {}, "Direction of the force"), this.ordered),
        this.ring.root,
      ),
      h(
        "section",
        { class: "card power", "aria-label": "Power" },
        h("div", { class: "card-head" }, h("h3", {}, "Force"), this.state),
        h("div", { class: "row wide" }, this.orders.root),
        this.power.root,
        h("div", { class: "row wide" }, this.powers.root),
        h(
          "p",
          { class: "note" },
          "The ring is about the ship, her bow up: the bar is the force on her, the marks are the order.",
        ),
        this.kept,
      ),
    );
    this.keys = [
      { key: "ArrowLeft", text: "Force 5° to port", repeats: true, run: () => this.ring.nudge(-1) },
      {
        key: "ArrowRight",
        text: "Force 5° to starboard",
        repeats: true,
        run: () => this.ring.nudge(1),
      },
      {
        key: "ArrowUp",
        text: "Power up 5 %",
        repeats: true,
        run: () => this.setPower(this.percent + 5, true),
      },
      {
        key: "ArrowDown",
        text: "Power down 5 %",
        repeats: true,
        run: () => this.setPower(this.percent - 5, true),
      },
      { key: "p", text: "Push", run: () => this.choose("push") },
      { key: "l", text: "Pull", run: () => this.choose("pull") },
      { key: "o", text: "Stop", run: () => this.choose("stop") },
    ];
  }

  private choose(order: TugNow["order"]): void {
    // Push and pull begin square to the side; the ring turns them from there.
    if (order !== this.order) this.inWords = true;
    this.order = order;
    this.send(false);
  }

  private setPower(percent: number, held = false): void {
    this.percent = Math.min(this.range.most, Math.max(this.range.least, percent));
    this.send(held);
  }

  private send(dragged: boolean): void {
    const action = this.action();
    if (!dragged) void this.page.order(action);
    else if (this.order !== "stop") this.page.drag("tug", action);
  }

  private action(): Action {
    const tug = this.info.name;
    const power = this.percent / 100;
    if (this.inWords || this.order === "stop")
      return { do: "tug", tug, order: this.order, power, lead: "square", place: "nearest" };
    const force_n = this.info.bollard_pull_n * power;
    return { do: this.order, tug, force_n, direction_rad: this.ring.value };
  }

  tick(frame: Frame): void {
    const now = frame.tugs[this.index];
    if (!now) return;
    const keeps = frame.vessels[this.info.vessel]?.pilot === "station";
    setClass(this.kept, "hidden", !keeps);
    if (keeps)
      setText(
        this.kept,
        "The ship keeps her station by herself and orders her tugs. This tug obeys her master when the pilot steers by hand.",
      );
    const changed =
      this.now?.order !== now.order ||
      this.now.order_n !== now.order_n ||
      this.now.order_direction_rad !== now.order_direction_rad;
    this.now = now;
    // The order may come from the pilot or from a rewind.
    if (changed) {
      this.order = now.order;
      this.inWords = false;
      if (now.order !== "stop") {
        this.ring.follow(now.order_direction_rad);
        this.percent = Math.round(now.power * 100);
      }
    }
    this.orders.show(now.order);
    this.powers.show(this.percent);
    this.power.show(this.percent, (now.force_n / this.info.bollard_pull_n) * 100);
    setText(this.state, tonnes(now.force_n));
    setText(
      this.ordered,
      now.order === "stop"
        ? "stands by"
        : `${now.order} ${tonnes(now.order_n)} at ${sided(now.order_direction_rad)}${now.limited ? ", all she has" : ""}`,
    );
  }

  claims(): void {
    const mine = this.claim.show();
    setClass(this.root, "locked", !mine);
    this.ring.enable(mine);
    this.power.enable(mine);
    for (const each of [...this.orders.buttons, ...this.powers.buttons]) each.disabled = !mine;
  }

  draw(): void {
    this.ring.draw(
      this.now?.direction_rad ?? 0,
      (this.now?.force_n ?? 0) / this.info.bollard_pull_n,
      (this.now?.order_n ?? 0) / this.info.bollard_pull_n,
    );
  }
}

/** A tug that is a vessel: her azimuth units, together or separately. */
export class AzimuthHelm implements Group {
  readonly name = "Tug";
  readonly root: HTMLElement;
  readonly keys: KeyAction[];
  private readonly claim: ClaimBar;
  readonly held: HTMLElement;
  private readonly units: { ring: Ring; power: Slider; figure: HTMLElement }[];
  private readonly togetherButton: HTMLButtonElement;
  private readonly stop: HTMLButtonElement;
  private readonly powers;
  private together = true;
  private work: VesselTug | null = null;
  private now: VesselNow | null = null;

  constructor(
    private readonly page: Page,
    private readonly info: VesselInfo,
    private readonly index: number,
    hello: Hello,
  ) {
    const range = inPercent(limits(hello, "azimuth", "power"));
    this.claim = new ClaimBar(page, { vessel: info.name }, tugCalled(info.name));
    this.held = this.claim.held;
    this.togetherButton = button(
      "Both together",
      () => {
        this.together = !this.together;
        setAttribute(this.togetherButton, "aria-pressed", String(this.together));
      },
      { "aria-pressed": "true" },
    );
    this.stop = button("Stop", () => this.all((i) => this.send(i, 0, null, false)), {
      name: "Stop both units (O)",
    });
    this.powers = choices(
      "Power of both",
      range.powers
        .filter((p) => p > 0)
        .map((p) => ({ value: p, label: `${p} %`, name: `Both units ${p} %` })),
      (p) => this.all((i) => this.send(i, p / 100, null, false)),
    );
    this.units = info.azimuths.map((unit, i) => ({
      ring: new Ring(`Direction of the ${unit.name} unit's thrust`, "thrust", (rad) => {
        this.each(i, (unit) => {
          this.units[unit]?.ring.follow(rad);
          this.send(unit, null, rad, true);
        });
      }),
      power: new Slider({
        label: `Power of the ${unit.name} unit`,
        least: range.least,
        most: range.most,
        step: 5,
        say: (p) => `${p} %`,
        order: (p) => this.each(i, (unit) => this.send(unit, p / 100, null, true)),
        marks: range.powers.map((p) => ({ at: p, text: String(p) })),
      }),
      figure: h("span", { class: "ordered" }),
    }));
    const ship = hello.vessels[page.live.ship()];
    // Her own pilot can take her to the ship's side and push there; an order to a unit disengages it.
    if (ship && ship !== info) this.work = new VesselTug(page, info, index, hello);
    this.root = h(
      "div",
      { class: "group tugmaster", role: "group", "aria-label": `Helm of ${info.title}` },
      this.claim.root,
      ...this.units.map(({ ring, power, figure }, i) =>
        h(
          "section",
          { class: "card unit", "aria-label": `${info.azimuths[i]?.name ?? ""} unit` },
          h(
            "div",
            { class: "card-head" },
            h(
              "h3",
              {},
              `${info.azimuths[i]?.name ?? ""} unit`.replace(/^./, (c) => c.toUpperCase()),
            ),
            figure,
          ),
          ring.root,
          power.root,
        ),
      ),
      h(
        "div",
        { class: "stack" },
        this.work?.root,
        h(
          "section",
          { class: "card both", "aria-label": "Both units" },
          h("h3", {}, "Units"),
          this.togetherButton,
          this.powers.root,
          this.stop,
          h(
            "p",
            { class: "note" },
            "Rings: the tug, her bow up; the bar is where the thrust goes, the marks are the order.",
          ),
        ),
      ),
    );
    const turn = (by: number) => () => this.units[0]?.ring.nudge(by);
    // A held key repeats faster than ticks arrive: it continues from its last order.
    let asked = { powers: [] as number[], until_ms: 0 };
    const power = (by: number) => () => {
      const from =
        performance.now() < asked.until_ms
          ? asked.powers
          : (this.now?.azimuths.map((unit) => unit.power_order) ?? []);
      asked = {
        powers: from.map((share) =>
          Math.min(range.most / 100, Math.max(range.least / 100, share + by)),
        ),
        until_ms: performance.now() + 500,
      };
      asked.powers.forEach((share, i) => this.send(i, share, null, true));
    };
    this.keys = [
      { key: "ArrowLeft", text: "Thrust 5° to port", repeats: true, run: turn(-1) },
      { key: "ArrowRight", text: "Thrust 5° to starboard", repeats: true, run: turn(1) },
      { key: "ArrowUp", text: "Power up 5 %", repeats: true, run: power(0.05) },
      { key: "ArrowDown", text: "Power down 5 %", repeats: true, run: power(-0.05) },
      {
        key: "o",
        text: "Stop both units",
        run: () => this.all((i) => this.send(i, 0, null, false)),
      },
    ];
  }

  private all(run: (unit: number) => void): void {
    this.info.azimuths.forEach((_, i) => run(i));
  }

  private each(from: number, run: (unit: number) => void): void {
    if (this.together) this.all(run);
    else run(from);
  }

  private send(
    unit: number,
    power: number | null,
    direction_rad: number | null,
    dragged: boolean,
  ): void {
    const name = this.info.azimuths[unit]?.name;
    if (name === undefined) return;
    const action = {
      do: "azimuth",
      vessel: this.info.name,
      name,
      power,
      direction_rad,
    } as const;
    if (dragged)
      this.page.drag(`azimuth ${unit} ${power === null ? "direction" : "power"}`, action);
    else void this.page.order(action);
  }

  tick(frame: Frame): void {
    const now = frame.vessels[this.index];
    if (!now) return;
    const before = this.now;
    this.now = now;
    this.work?.tick(frame);
    now.azimuths.forEach((state, i) => {
      const unit = this.units[i];
      const info = this.info.azimuths[i];
      if (!unit || !info) return;
      if (before?.azimuths[i]?.direction_order_rad !== state.direction_order_rad)
        unit.ring.follow(state.direction_order_rad);
      unit.power.show(state.power_order * 100, state.power * 100);
      setText(
        unit.figure,
        `${fixed((state.power * info.bollard_n) / TONNE_N, 0)} t · ${percent(state.power)} at ${sided(state.direction_rad)}`,
      );
    });
    const first = now.azimuths[0]?.power_order ?? 0;
    this.powers.show(
      now.azimuths.every((a) => Math.abs(a.power_order - first) < 0.005)
        ? Math.round(first * 100)
        : null,
    );
  }

  claims(): void {
    const mine = this.claim.show();
    setClass(this.root, "locked", !mine);
    this.work?.claims();
    for (const unit of this.units) {
      unit.ring.enable(mine);
      unit.power.enable(mine);
    }
    for (const each of [this.togetherButton, this.stop, ...this.powers.buttons])
      each.disabled = !mine;
  }

  draw(): void {
    this.units.forEach(({ ring }, i) => {
      const state = this.now?.azimuths[i];
      ring.draw(state?.direction_rad ?? 0, state?.power ?? 0, state?.power_order ?? 0);
    });
  }
}

/** The helm of the tug that a role names; `null` where the scenario has none of that name. */
export function tugHelm(page: Page, hello: Hello, name: string): Group | null {
  const tug = hello.tugs.findIndex((t) => t.name === name);
  const info = hello.tugs[tug];
  if (info) return new VectorHelm(page, info, tug, hello);
  const vessel = hello.vessels.findIndex((v) => v.name === name);
  const own = hello.vessels[vessel];
  return own ? new AzimuthHelm(page, own, vessel, hello) : null;
}
