/** The pilot's orders to tugs: those that are forces, and those that are vessels and go there by themselves. */
import { length, minus, turned } from "../geometry";
import type { Page } from "../page";
import type { Action, Frame, Hello, Pair, TugInfo, VesselInfo } from "../protocol";
import { button, choices, h, setAttribute, setClass, setText } from "../ui/dom";
import { spoken, tonnes } from "../units";
import type { Group, KeyAction } from "./group";
import { type Lead, type Station, stations, tugDirection } from "./orders";

const POWERS = [25, 50, 75, 100];
/** What was just ordered here stands until frames can have it: so many ticks, and so long. */
const ANSWERED = { ticks: 2, ms: 500 };
/** A tug that stands by lies parallel to the ship, so far off her side [m]. */
const STAND_OFF_M = 25;

interface Card {
  name: string;
  root: HTMLElement;
  push(): void;
  away(): void;
  stop(): void;
  power(percent: number): void;
  tick(frame: Frame): void;
  claims(): void;
}

/** What a tug is told; `off`: to leave the side and stand by, for one that has no line to pull on. */
type Told = "push" | "stop" | "pull" | "off";

/** Which way a tug leads: square to the side, or towards the ship's bow or stern; a press turns it. */
class LeadButton {
  value: Lead = 0;
  readonly root: HTMLButtonElement;

  constructor(
    private readonly tug: string,
    changed: () => void,
  ) {
    this.root = button("⊥", () => {
      this.value = this.value === 0 ? 1 : this.value === 1 ? -1 : 0;
      this.show();
      changed();
    });
    this.show();
  }

  private show(): void {
    setText(this.root, { [-1]: "aft", 0: "⊥", 1: "fwd" }[this.value]);
    const leads = `${this.tug} leads ${{ [-1]: "aft", 0: "square to the side", 1: "forward" }[this.value]}; change`;
    setAttribute(this.root, "aria-label", leads);
    setAttribute(this.root, "title", leads);
  }
}

abstract class Base implements Card {
  abstract readonly name: string;
  readonly root: HTMLElement;
  protected readonly head = h("div", { class: "card-head" });
  protected readonly state = h("span", { class: "state" });
  protected percent = 25;
  private readonly powers;
  protected readonly orders;

  constructor(
    protected readonly page: Page,
    title: string,
    third: "pull" | "off",
  ) {
    this.powers = choices(
      `Power of ${title}`,
      POWERS.map((p) => ({ value: p, label: String(p), name: `${title} ${p} %` })),
      (p) => this.power(p),
    );
    this.powers.show(this.percent);
    this.orders = choices<Told>(
      `Order to ${title}`,
      [
        { value: "push", label: "Push", name: `${title} push` },
        { value: "stop", label: "Stop", name: `${title} stop` },
        third === "pull"
          ? { value: "pull", label: "Pull", name: `${title} pull` }
          : { value: "off", label: "Off", name: `${title} stand off` },
      ],
      (order) => (order === "push" ? this.push() : order === "stop" ? this.stop() : this.away()),
    );
    this.root = h(
      "section",
      { class: "card tug", "aria-label": `Tug ${title}` },
      this.head,
      h(
        "div",
        { class: "row" },
        this.orders.root,
        this.powers.root,
        h("span", { class: "ordered" }, "%"),
      ),
    );
    this.head.append(h("div", { class: "who" }, h("h3", {}, spoken(title)), this.state));
  }

  abstract push(): void;
  /** Pulls, or stands off. */
  abstract away(): void;
  abstract stop(): void;
  /** Orders again what is ordered, with another power. */
  protected abstract again(): void;
  abstract tick(frame: Frame): void;
  protected abstract commanded(): boolean;
  protected abstract heldBy(): string | null;

  protected showPower(percent: number): void {
    this.percent = percent;
    this.powers.show(percent);
  }

  power(percent: number): void {
    this.showPower(percent);
    this.again();
  }

  protected send(action: Action): void {
    void this.page.order(action).then((done) => done && this.page.did("tug"));
  }

  claims(): void {
    const may = this.commanded();
    setClass(this.root, "locked", !may);
    for (const each of this.root.querySelectorAll<HTMLButtonElement | HTMLSelectElement>(
      "button, select",
    ))
      each.disabled = !may;
    const holder = may ? null : this.heldBy();
    for (const each of this.head.querySelectorAll("button, select")) setClass(each, "hidden", !may);
    this.root.title = holder ? `${holder} has her` : "";
  }
}

/** A tug that is a force at the ship's side. */
class VectorTug extends Base {
  readonly name: string;
  private ordered: "push" | "pull" | "stand_by" = "stand_by";
  private readonly lead: LeadButton;
  private shownOrder = "";

  constructor(
    page: Page,
    private readonly info: TugInfo,
    private readonly index: number,
    private readonly beam_m: number,
  ) {
    super(page, info.name, "pull");
    this.name = info.name;
    this.lead = new LeadButton(info.name, () => this.again());
    this.head.append(this.lead.root);
  }

  private go(order: "push" | "pull"): void {
    this.ordered = order;
    const force_n = (this.info.bollard_pull_n * this.percent) / 100;
    const at = order === "push" ? this.info.push_at_m : this.info.pull_at_m;
    this.send({
      do: "tug",
      tug: this.info.name,
      order,
      force_n,
      direction_rad: tugDirection(at, order, this.lead.value, this.beam_m),
    });
  }

  push(): void {
    this.go("push");
  }

  away(): void {
    this.go("pull");
  }

  stop(): void {
    this.ordered = "stand_by";
    this.send({ do: "tug", tug: this.info.name, order: "stand_by" });
  }

  protected again(): void {
    if (this.ordered !== "stand_by") this.go(this.ordered);
  }

  protected commanded(): boolean {
    return this.page.live.mine({ tug: this.info.name });
  }

  protected heldBy(): string | null {
    return this.page.live.holder({ tug: this.info.name })?.holder ?? null;
  }

  tick(frame: Frame): void {
    const now = frame.tugs[this.index];
    if (!now) return;
    this.ordered = now.order;
    // Orders may come from elsewhere: the tugmaster, another page, a rewind.
    const order = `${now.order} ${now.order_n}`;
    if (order !== this.shownOrder) {
      this.shownOrder = order;
      if (now.order !== "stand_by")
        this.showPower(Math.round((now.order_n / this.info.bollard_pull_n) * 100));
    }
    this.orders.show(now.order === "stand_by" ? "stop" : now.order);
    const holder = this.commanded() ? null : this.heldBy();
    const work =
      now.order === "stand_by"
        ? now.force_n > 1e3
          ? `easing, ${tonnes(now.force_n)}`
          : "stands by"
        : `${now.order}es ${tonnes(now.force_n)} of ${tonnes(now.order_n)}`.replace(
            "pulles",
            "pulls",
          );
    setText(
      this.state,
      `${work}${now.limited ? " (all she has)" : ""}${holder ? `, by ${holder}` : ""}`,
    );
  }
}

/** The line between a tug and the ship, and where it is on the ship. */
interface Towline {
  index: number;
  name: string;
  at_m: Pair;
}

function towline(hello: Hello, tug: VesselInfo, ship: VesselInfo): Towline | null {
  for (const [index, { name, ship: own, fairlead_m, end }] of hello.lines.entries()) {
    if (!("body" in end)) continue;
    if (own === tug.body && end.body === ship.body) return { index, name, at_m: end.at_m };
    if (own === ship.body && end.body === tug.body) return { index, name, at_m: fairlead_m };
  }
  return null;
}

/**
 * A tug that is a vessel: told where to push, or to stand by off that side, or to pull where she has a line to the ship;
 * her own pilot takes her there.
 */
export class VesselTug extends Base {
  readonly name: string;
  private readonly place: HTMLSelectElement;
  private ordered: Told | null = null;
  private chosen = false;
  private readonly stations;
  private sent = { tick: Infinity, at_ms: 0 };
  private readonly bollard_n: number;
  private readonly line: Towline | null;
  private readonly lead: LeadButton | null;

  constructor(
    page: Page,
    private readonly info: VesselInfo,
    private readonly index: number,
    private readonly ship: VesselInfo,
    hello: Hello,
  ) {
    const line = towline(hello, info, ship);
    super(page, info.name, line ? "pull" : "off");
    this.line = line;
    this.lead = line && new LeadButton(info.name, () => this.again());
    this.name = info.name;
    this.bollard_n = info.azimuths.reduce((sum, unit) => sum + unit.bollard_n, 0);
    this.stations = stations(hello.bodies[ship.body]?.outline ?? [], ship.length_m);
    this.place = h(
      "select",
      { "aria-label": `Where ${info.name} works` },
      ...this.stations.map((s, i) => h("option", { value: i }, s.name)),
    );
    this.place.addEventListener("change", () => {
      this.chosen = true;
      this.again();
    });
    if (this.lead) this.head.append(this.lead.root);
    this.head.append(this.place);
  }

  /** Until somebody chooses, she works at the place that she is nearest to. */
  private chooseNearest(frame: Frame): void {
    const [tug, ship] = [frame.bodies[this.info.body], frame.bodies[this.ship.body]];
    if (this.chosen || !tug || !ship) return;
    this.chosen = true;
    const here = turned(-ship[2], [tug[0] - ship[0], tug[1] - ship[1]]);
    const far = (station: Station) => length(minus(station.at_m, here));
    const nearest = this.stations.toSorted((a, b) => far(a) - far(b))[0];
    if (nearest) this.place.value = String(this.stations.indexOf(nearest));
  }

  private station() {
    return this.stations[Number(this.place.value)] ?? null;
  }

  push(): void {
    this.press("push", (this.bollard_n * this.percent) / 100);
  }

  /** Stays at the side without weight: who stops pushing does not leave. */
  stop(): void {
    this.press("stop", 0);
  }

  /** A second press, on the power, finds what the first one ordered, though no frame has it yet. */
  private say(ordered: Told): void {
    this.ordered = ordered;
    this.sent = { tick: this.page.live.frame?.tick ?? 0, at_ms: performance.now() };
  }

  private isAnswered(tick: number): boolean {
    const since = tick - this.sent.tick;
    return (
      since < 0 || (since > ANSWERED.ticks && performance.now() - this.sent.at_ms > ANSWERED.ms)
    );
  }

  private press(ordered: Told, force_n: number): void {
    const station = this.station();
    if (!station) return;
    this.say(ordered);
    this.send({
      do: "push_ship",
      vessel: this.info.name,
      ship: this.ship.name,
      at_m: station.at_m,
      force_n,
    });
  }

  away(): void {
    if (this.line && this.lead) {
      this.say("pull");
      const force_n = (this.bollard_n * this.percent) / 100;
      const direction_rad = tugDirection(this.line.at_m, "pull", this.lead.value, this.ship.beam_m);
      this.send({
        do: "pull_ship",
        vessel: this.info.name,
        line: this.line.name,
        direction_rad,
        force_n,
      });
      return;
    }
    const station = this.station();
    if (!station) return;
    this.say("off");
    const off = STAND_OFF_M + this.info.beam_m / 2;
    this.send({
      do: "follow_ship",
      vessel: this.info.name,
      ship: this.ship.name,
      at_m: [station.at_m[0], station.at_m[1] + station.side * off],
      heading_rad: 0,
    });
  }

  protected again(): void {
    if (this.ordered === "push") this.push();
    else if (this.ordered === "stop") this.stop();
    // On a line nobody told her to keep off from here: more power is none of that.
    else if (this.ordered === "pull" || (this.ordered === "off" && !this.line)) this.away();
  }

  protected commanded(): boolean {
    return this.page.live.mine({ vessel: this.info.name });
  }

  protected heldBy(): string | null {
    return this.page.live.holder({ vessel: this.info.name })?.holder ?? null;
  }

  tick(frame: Frame): void {
    const now = frame.vessels[this.index];
    if (!now) return;
    this.chooseNearest(frame);
    // What she was told may come from elsewhere: her master, another page, the scenario, a rewind.
    const { assist } = now;
    if (this.isAnswered(frame.tick))
      this.ordered =
        assist === null
          ? null
          : assist.job === "follow"
            ? "off"
            : assist.job === "push" && assist.force_n === 0
              ? "stop"
              : assist.job;
    this.orders.show(this.ordered);
    if (assist && assist.force_n > 0 && this.isAnswered(frame.tick))
      this.showPower(Math.round((assist.force_n / this.bollard_n) * 100));
    const holder = this.commanded() ? null : this.heldBy();
    setText(this.state, `${this.work(frame)}${holder ? `, by ${holder}` : ""}`);
  }

  /** What becomes of it at the ship: not her thrust, which may only move herself. */
  private work(frame: Frame): string {
    const [own, ship] = [this.info.body, this.ship.body];
    const between = frame.contacts.filter(
      ({ bodies: [a, b] }) => (a === own && b === ship) || (a === ship && b === own),
    );
    const pushes = between.reduce((sum, { force_n }) => sum + length(force_n), 0);
    const line = frame.lines[this.line?.index ?? -1];
    if (this.ordered === null) return "by hand";
    if (this.ordered === "off") return "keeps off";
    if (this.ordered === "pull")
      return line && line.tension_n > 1e3 ? `pulls ${tonnes(line.tension_n)}` : "takes up slack";
    if (between.length === 0) return "comes alongside";
    return this.ordered === "stop" ? "alongside" : `pushes ${tonnes(pushes)}`;
  }
}

export class Tugs implements Group {
  readonly name = "Tugs";
  readonly root: HTMLElement;
  readonly keys: KeyAction[];
  private readonly cards: Card[];
  private selected = 0;

  constructor(page: Page, hello: Hello) {
    const ship = page.live.ship();
    const own = hello.vessels[ship];
    this.cards = [
      ...hello.tugs.map(
        (info, i) => new VectorTug(page, info, i, hello.vessels[info.vessel]?.beam_m ?? 0),
      ),
      ...hello.vessels.flatMap((info, i) =>
        info.is_tug && own && info.azimuths.length > 0
          ? [new VesselTug(page, info, i, own, hello)]
          : [],
      ),
    ];
    this.root = h(
      "div",
      { class: "group tugs", role: "group", "aria-label": "Orders to tugs" },
      ...this.cards.map((card) => card.root),
    );
    this.keys =
      this.cards.length === 0
        ? []
        : [
            {
              key: "t",
              text: "Next tug",
              run: () => this.select((this.selected + 1) % this.cards.length),
            },
            { key: "p", text: "The tug pushes", run: () => this.cards[this.selected]?.push() },
            {
              key: "l",
              text: "The tug pulls, or stands off",
              run: () => this.cards[this.selected]?.away(),
            },
            { key: "o", text: "The tug stops", run: () => this.cards[this.selected]?.stop() },
            ...POWERS.map((p, i) => ({
              key: String(i + 1),
              text: `The tug's power ${p} %`,
              run: () => this.cards[this.selected]?.power(p),
            })),
          ];
    this.select(0);
  }

  get count(): number {
    return this.cards.length;
  }

  private select(index: number): void {
    this.selected = index;
    this.cards.forEach((card, i) =>
      setClass(card.root, "selected", i === index && this.cards.length > 1),
    );
  }

  tick(frame: Frame): void {
    for (const card of this.cards) card.tick(frame);
  }

  claims(): void {
    for (const card of this.cards) card.claims();
  }
}
