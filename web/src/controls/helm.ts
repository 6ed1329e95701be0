/** Rudder, engine and thrusters of one ship, and the pilots that keep her course and speed. */
import { type Card, type Order, buttonsOn, limits } from "../orders";
import type { Page } from "../page";
import type { Frame, Hello, VesselInfo, VesselNow } from "../protocol";
import { Bar } from "../ui/bar";
import { button, h, setAttribute, setText } from "../ui/dom";
import { Slider } from "../ui/slider";
import { KNOT_MPS, fixed, heading, percent, sided, toDegrees, toKnots, toRadians } from "../units";
import { ClaimBar, type Group, type KeyAction } from "./group";

const RUDDER_STEPS_DEG = [5, 10, 20, 35];
/** A key pressed within this time after another continues from its value. */
const KEY_HELD_MS = 500;
/** A word of the telegraph on its button, which stands in the row `Ahead` or `Astern`. */
export const telegraphLabel = (word: string): string =>
  word
    .replace(/ (ahead|astern)$/, "")
    .replace("navigation", "nav.")
    .replace(/^./, (c) => c.toUpperCase());

export class Helm implements Group {
  readonly name = "Helm";
  readonly root: HTMLElement;
  readonly keys: KeyAction[];
  private readonly claim: ClaimBar;
  readonly held: HTMLElement;
  private readonly parts: { enable(on: boolean): void; show(now: VesselNow): void }[] = [];
  private now: VesselNow | null = null;
  private heading_rad = 0;

  constructor(
    private readonly page: Page,
    private readonly info: VesselInfo,
    private readonly index: number,
    private readonly hello: Hello,
  ) {
    this.claim = new ClaimBar(page, { vessel: info.name }, "the helm");
    this.held = this.claim.held;
    const cards: HTMLElement[] = [];
    if (info.rudder_stop_rad !== null) cards.push(this.rudder(info.rudder_stop_rad));
    if (info.full_rps !== null) cards.push(this.engine(info.full_rps));
    if (info.thrusters.length > 0) cards.push(this.thrusters());
    this.root = h(
      "div",
      { class: "group helm", "aria-label": `Helm of ${info.title}`, role: "group" },
      this.claim.root,
      ...cards,
    );
    this.keys = this.keyboard();
  }

  private order(order: Order): void {
    void this.page.order(order);
  }

  private setRudder(rad: number): void {
    const stop = this.info.rudder_stop_rad ?? 0;
    this.order({
      do: "rudder",
      vessel: this.info.name,
      angle_rad: Math.min(stop, Math.max(-stop, rad)),
    });
  }

  private setEngine(share: number): void {
    this.order({ do: "engine", vessel: this.info.name, share });
  }

  /** The buttons of a card that are registered in `orders.ts`, for the orders that this vessel can carry out. */
  private registered(card: Card): HTMLElement | null {
    const vessel = this.info.name;
    const own = buttonsOn(card).filter(({ order }) => this.info.orders.includes(order));
    const buttons = own.map(({ order, text }) =>
      button(text, () => this.order({ do: order, vessel })),
    );
    this.parts.push({
      enable: (on) => {
        for (const each of buttons) each.disabled = !on;
      },
      show: () => {},
    });
    return buttons.length > 0 ? h("div", { class: "row" }, ...buttons) : null;
  }

  private rudder(stop_rad: number): HTMLElement {
    const vessel = this.info.name;
    const stop = Math.round(toDegrees(stop_rad));
    const steps = RUDDER_STEPS_DEG.filter((d) => d < stop).concat(stop);
    const figure = h("output", { class: "big", "aria-label": "Rudder now" });
    const ordered = h("span", { class: "ordered" });
    const slider = new Slider({
      label: "Rudder order",
      least: -stop,
      most: stop,
      step: 1,
      say: (d) => sided(toRadians(d)),
      order: (d) => {
        this.page.drag("rudder", { do: "rudder", vessel, angle_rad: toRadians(d) });
      },
      marks: [-30, -20, -10, 0, 10, 20, 30]
        .filter((d) => Math.abs(d) < stop)
        .map((d) => ({
          at: d,
          text: String(Math.abs(d)),
          ...(d !== 0 && { side: d < 0 ? ("port" as const) : ("starboard" as const) }),
        })),
    });
    const push = (d: number) =>
      button(String(Math.abs(d)), () => this.setRudder(toRadians(d)), {
        name: `Rudder ${d < 0 ? "port" : "starboard"} ${Math.abs(d)}`,
        class: d < 0 ? "port" : "starboard",
      });
    const [port, starboard] = [steps.toReversed().map((d) => push(-d)), steps.map(push)];
    const mid = button("Mid", () => this.setRudder(0), {
      name: "Mid: rudder amidships (M)",
      class: "midships",
    });
    const buttons = [...port, mid, ...starboard];
    const keeper = this.courseKeeper();
    const root = h(
      "section",
      { class: "card rudder", "aria-label": "Rudder" },
      h("div", { class: "card-head" }, h("h3", {}, "Rudder"), figure, ordered),
      slider.root,
      h(
        "div",
        { class: "row rudder-buttons" },
        h("div", { class: "side" }, ...port),
        mid,
        h("div", { class: "side" }, ...starboard),
      ),
      keeper.root,
      this.registered("rudder"),
    );
    this.parts.push({
      enable: (on) => {
        slider.enable(on);
        for (const each of buttons) each.disabled = !on;
        keeper.enable(on);
      },
      show: (now) => {
        slider.show(toDegrees(now.rudder.order_rad), toDegrees(now.rudder.now_rad));
        setText(figure, sided(now.rudder.now_rad));
        setText(ordered, `order ${sided(now.rudder.order_rad)}`);
        keeper.show(now);
      },
    });
    return root;
  }

  private courseKeeper() {
    const vessel = this.info.name;
    let wanted: number | null = null;
    const change = (by: number) => () => {
      const from = wanted ?? this.heading_rad;
      const next = toRadians(Math.round(toDegrees(from)) + by);
      if (this.now?.course_rad !== null) this.order({ do: "course", vessel, heading_rad: next });
      wanted = next;
      setText(figure, heading(next, 0));
    };
    const figure = h("output", { class: "wanted", "aria-label": "Course to keep" }, "–");
    const engage = button(
      "Keep course",
      () => {
        if (this.now?.course_rad === null)
          this.order({ do: "course", vessel, heading_rad: wanted ?? this.heading_rad });
        else this.toHands("course");
      },
      { "aria-pressed": "false" },
    );
    const buttons = [
      button("−5", change(-5), { name: "Course 5 to port" }),
      button("−1", change(-1), { name: "Course 1 to port" }),
      button("+1", change(1), { name: "Course 1 to starboard" }),
      button("+5", change(5), { name: "Course 5 to starboard" }),
    ];
    const [a, b, c, d] = buttons;
    return {
      root: h("div", { class: "row keeper" }, engage, a, b, figure, c, d),
      enable: (on: boolean) => {
        for (const each of [engage, ...buttons]) each.disabled = !on;
      },
      show: (now: VesselNow) => {
        setAttribute(engage, "aria-pressed", String(now.course_rad !== null));
        if (now.course_rad !== null) wanted = now.course_rad;
        setText(figure, heading(wanted ?? this.heading_rad, 0));
      },
    };
  }

  /** Disengages one of the two pilots. Hand steering disengages both, so the other is ordered again. */
  private toHands(off: "course" | "speed"): void {
    const vessel = this.info.name;
    const [course, speed] = [this.now?.course_rad ?? null, this.now?.speed_order_mps ?? null];
    this.order({ do: "hands", vessel });
    if (off === "course" && speed !== null) this.order({ do: "speed", vessel, speed_mps: speed });
    if (off === "speed" && course !== null)
      this.order({ do: "course", vessel, heading_rad: course });
  }

  private engine(full_rps: number): HTMLElement {
    const vessel = this.info.name;
    const figure = h("output", { class: "big", "aria-label": "Shaft now" });
    const ordered = h("span", { class: "ordered" });
    const all = this.hello.telegraph.map(({ word, share }) => {
      const name = word.replace(/^./, (c) => c.toUpperCase());
      const label = telegraphLabel(word);
      return {
        share,
        root: button(label, () => this.setEngine(share), {
          // The name has the label's words, for those who say what they see.
          name:
            share === 0 ? "Stop engine (S)" : name.startsWith(label) ? name : `${label}, ${name}`,
          title: share === 0 ? name : `${name}: ${percent(Math.abs(share))} of full revolutions`,
          class: share === 0 ? "stop" : share < 0 ? "port" : "starboard",
          "aria-pressed": "false",
        }),
      };
    });
    const stop = all.filter((d) => d.share === 0);
    const ahead = all.filter((d) => d.share > 0);
    const astern = all.filter((d) => d.share < 0).toReversed();
    const gauge = new Bar(-100, 100, true, 8);
    const keeper = this.speedKeeper(vessel);
    const root = h(
      "section",
      { class: "card engine", "aria-label": "Engine" },
      h("div", { class: "card-head" }, h("h3", {}, "Engine"), figure, ordered),
      gauge.root,
      h(
        "div",
        { class: "telegraph" },
        ...stop.map((d) => d.root),
        h("span", { class: "starboard" }, "Ahead"),
        ...ahead.map((d) => d.root),
        h("span", { class: "port" }, "Astern"),
        ...astern.map((d) => d.root),
      ),
      keeper.root,
      this.registered("engine"),
    );
    this.parts.push({
      enable: (on) => {
        for (const each of all) each.root.disabled = !on;
        gauge.enable(on);
        keeper.enable(on);
      },
      show: (now) => {
        const { order, now: actual } = now.shaft;
        setText(figure, `${fixed(actual * full_rps * 60, 0)} rpm`);
        setText(ordered, `order ${percent(order)}`);
        gauge.show(actual * 100, order * 100);
        for (const each of all)
          setAttribute(each.root, "aria-pressed", String(Math.abs(each.share - order) < 0.01));
        keeper.show(now);
      },
    });
    return root;
  }

  private speedKeeper(vessel: string) {
    const figure = h("output", { class: "wanted", "aria-label": "Speed to keep" }, "–");
    let wanted_kn: number | null = null;
    // The order is about the speed through the water, not over ground: in a stream she must not begin to slow down.
    const ahead_kn = () => Math.round(toKnots(this.now?.water_mps[0] ?? 0) * 2) / 2;
    const change = (by: number) => () => {
      wanted_kn = (wanted_kn ?? ahead_kn()) + by;
      if (this.now?.speed_order_mps !== null)
        this.order({ do: "speed", vessel, speed_mps: wanted_kn * KNOT_MPS });
      setText(figure, `${fixed(wanted_kn, 1)} kn`);
    };
    const engage = button(
      "Keep speed",
      () => {
        if (this.now?.speed_order_mps === null)
          this.order({ do: "speed", vessel, speed_mps: (wanted_kn ?? ahead_kn()) * KNOT_MPS });
        else this.toHands("speed");
      },
      { "aria-pressed": "false" },
    );
    const [less, more] = [
      button("−½", change(-0.5), { name: "Slower by half a knot, −½" }),
      button("+½", change(0.5), { name: "Faster by half a knot, +½" }),
    ];
    return {
      root: h("div", { class: "row keeper" }, engage, less, figure, more),
      enable: (on: boolean) => {
        for (const each of [engage, less, more]) each.disabled = !on;
      },
      show: (now: VesselNow) => {
        setAttribute(engage, "aria-pressed", String(now.speed_order_mps !== null));
        if (now.speed_order_mps !== null) wanted_kn = toKnots(now.speed_order_mps);
        setText(figure, `${fixed(wanted_kn ?? ahead_kn(), 1)} kn`);
      },
    };
  }

  private thrusters(): HTMLElement {
    const vessel = this.info.name;
    const [least, most] = limits(this.hello, "thruster", "power");
    const rows = this.info.thrusters.map((thruster, i) => {
      const slider = new Slider({
        label: `${thruster.name} thruster order`,
        least: least * 100,
        most: most * 100,
        step: 5,
        say: (p) => `${p < 0 ? "port" : "starboard"} ${Math.abs(p)} %`,
        order: (p) =>
          this.page.drag(`thruster ${i}`, {
            do: "thruster",
            vessel,
            name: thruster.name,
            power: p / 100,
          }),
        marks: [],
      });
      const figure = h("span", { class: "ordered" });
      const stop = button(
        "Stop",
        () => this.order({ do: "thruster", vessel, name: thruster.name, power: 0 }),
        { name: `${thruster.name} thruster stop` },
      );
      this.parts.push({
        enable: (on) => {
          slider.enable(on);
          stop.disabled = !on;
        },
        show: (now) => {
          const state = now.thrusters[i];
          if (!state) return;
          slider.show(state.order * 100, state.now * 100);
          setText(
            figure,
            state.now === 0 && state.order === 0
              ? "stopped"
              : `${state.now < 0 ? "P" : "S"} ${percent(Math.abs(state.now))}`,
          );
        },
      });
      return h(
        "div",
        { class: "thruster" },
        h(
          "div",
          { class: "card-head" },
          h(
            "h3",
            {},
            `${thruster.name} thr.`.replace(/^./, (c) => c.toUpperCase()),
          ),
          figure,
        ),
        h("div", { class: "row" }, slider.root, stop),
      );
    });
    return h(
      "section",
      { class: "card thrusters", "aria-label": "Thrusters" },
      ...rows,
      this.registered("thrusters"),
    );
  }

  private keyboard(): KeyAction[] {
    // A held key repeats faster than ticks arrive: it continues from its last order.
    let asked = { degrees: 0, until_ms: 0 };
    const stepRudder = (degrees: number) => () => {
      const stop = Math.round(toDegrees(this.info.rudder_stop_rad ?? 0));
      const from =
        performance.now() < asked.until_ms
          ? asked.degrees
          : Math.round(toDegrees(this.now?.rudder.order_rad ?? 0) / degrees) * degrees;
      asked = {
        degrees: Math.min(stop, Math.max(-stop, from + degrees)),
        until_ms: performance.now() + KEY_HELD_MS,
      };
      this.page.drag("rudder", {
        do: "rudder",
        vessel: this.info.name,
        angle_rad: toRadians(asked.degrees),
      });
    };
    const detent = (by: 1 | -1) => () => {
      const order = this.now?.shaft.order ?? 0;
      const steps = this.hello.telegraph.map((d) => d.share);
      const next =
        by > 0 ? steps.find((d) => d > order + 0.01) : steps.findLast((d) => d < order - 0.01);
      if (next !== undefined) this.setEngine(next);
    };
    const keys: KeyAction[] = [];
    if (this.info.rudder_stop_rad !== null) {
      keys.push(
        { key: "ArrowLeft", text: "Rudder 5° to port", repeats: true, run: stepRudder(-5) },
        { key: "ArrowRight", text: "Rudder 5° to starboard", repeats: true, run: stepRudder(5) },
        { key: "m", text: "Midships", run: () => this.setRudder(0) },
      );
    }
    if (this.info.full_rps !== null) {
      keys.push(
        { key: "ArrowUp", text: "Engine one step ahead", run: detent(1) },
        { key: "ArrowDown", text: "Engine one step astern", run: detent(-1) },
        { key: "s", text: "Stop engine", run: () => this.setEngine(0) },
      );
    }
    const bow = this.info.thrusters[0];
    if (bow) {
      const [least, most] = limits(this.hello, "thruster", "power");
      const by = (share: number) => () => {
        const order = this.now?.thrusters[0]?.order ?? 0;
        this.order({
          do: "thruster",
          vessel: this.info.name,
          name: bow.name,
          power: Math.min(most, Math.max(least, order + share)),
        });
      };
      keys.push(
        { key: "[", text: `${bow.name} thruster to port`, run: by(-0.25) },
        { key: "]", text: `${bow.name} thruster to starboard`, run: by(0.25) },
      );
    }
    return keys;
  }

  tick(frame: Frame, hello: Hello): void {
    const now = frame.vessels[this.index];
    const body = frame.bodies[hello.vessels[this.index]?.body ?? -1];
    if (!now || !body) return;
    this.now = now;
    this.heading_rad = body[2];
    for (const part of this.parts) part.show(now);
  }

  claims(): void {
    const mine = this.claim.show();
    this.root.classList.toggle("locked", !mine);
    for (const part of this.parts) part.enable(mine);
  }
}
