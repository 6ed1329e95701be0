/** The pilot's orders to tugs, in words: the server finds force, direction and place. */
import type { Page } from "../page";
import type {
  AssistNow,
  Control,
  Frame,
  Hello,
  Lead,
  Pair,
  Place,
  TugInfo,
  TugNow,
  TugWord,
  VesselInfo,
} from "../protocol";
import { button, choices, h, setAttribute, setClass, setText } from "../ui/dom";
import { fixed, spoken, tonnes } from "../units";
import type { Group, KeyAction } from "./group";

/** The powers that have a button, in percent: those within the server's limits of a share. */
const powersWithin = ([least, most]: Pair) =>
  [25, 50, 75, 100].filter((p) => p >= least * 100 && p <= most * 100);
/** An order from this page is displayed until frames can have it: for this number of ticks, and at least this long. */
const ANSWERED = { ticks: 2, ms: 500 };
/** A force below this is shown as none [N]. */
const NO_FORCE_N = 1e3;

const LEADS: Record<Lead, { label: string; text: string; next: Lead }> = {
  square: { label: "square", text: "square to the side", next: "forward" },
  forward: { label: "fwd", text: "forward", next: "aft" },
  aft: { label: "aft", text: "aft", next: "square" },
};

/** The direction in which a tug leads; a press changes it. */
class LeadButton {
  value: Lead = "square";
  readonly root: HTMLButtonElement;

  constructor(
    private readonly tug: string,
    changed: () => void,
  ) {
    this.root = button("square", () => {
      this.value = LEADS[this.value].next;
      this.show();
      changed();
    });
    this.show();
  }

  private show(): void {
    const { label, text } = LEADS[this.value];
    setText(this.root, label);
    setAttribute(this.root, "aria-label", `${this.tug} leads ${text}; change`);
    setAttribute(this.root, "title", `${this.tug} leads ${text}; change`);
  }
}

/** The state of a tug on its card. */
interface CardNow {
  /** `null`: hand steering. */
  order: TugWord | null;
  power: number;
  place: Place | null;
  text: string;
}

/** One tug: order, power, direction and position. */
export abstract class TugCard {
  readonly root: HTMLElement;
  private readonly head = h("div", { class: "card-head" });
  private readonly state = h("span", { class: "state" });
  private readonly powers;
  private readonly orders;
  private readonly lead: LeadButton;
  private readonly places: HTMLSelectElement | null;
  private percent = 25;
  private ordered: TugWord | null = null;
  private shownPower = NaN;
  /** A position was chosen here that no order has had yet. */
  private chosen = false;
  private sent = { tick: Infinity, at_ms: 0 };
  /** The word of the third button: a tug without a line stands off instead of pulling. */
  private readonly third: TugWord;

  constructor(
    private readonly page: Page,
    readonly name: string,
    private readonly control: Control,
    canPull: boolean,
    powers: number[],
    places: Place[],
  ) {
    this.third = canPull ? "pull" : "stand_off";
    this.powers = choices(
      `Power of ${name}`,
      powers.map((p) => ({ value: p, label: String(p), name: `${name} ${p} %` })),
      (p) => this.power(p),
    );
    this.powers.show(this.percent);
    this.orders = choices<TugWord>(
      `Order to ${name}`,
      [
        { value: "push", label: "Push", name: `${name} push` },
        { value: "stop", label: "Stop", name: `${name} stop` },
        canPull
          ? { value: "pull", label: "Pull", name: `${name} pull` }
          : { value: "stand_off", label: "Off", name: `${name} stand off` },
      ],
      (order) => this.say(order),
    );
    this.lead = new LeadButton(name, () => this.again());
    this.places =
      places.length === 0
        ? null
        : h(
            "select",
            { "aria-label": `Where ${name} works` },
            ...places.map((place) =>
              h("option", { value: place }, place === "nearest" ? "nearest place" : place),
            ),
          );
    this.places?.addEventListener("change", () => {
      this.chosen = true;
      this.again();
    });
    this.head.append(h("div", { class: "who" }, h("h3", {}, spoken(name)), this.state));
    if (canPull) this.head.append(this.lead.root);
    if (this.places) this.head.append(this.places);
    this.root = h(
      "section",
      { class: "card tug", "aria-label": `Tug ${name}` },
      this.head,
      h(
        "div",
        { class: "row" },
        this.orders.root,
        this.powers.root,
        h("span", { class: "ordered" }, "%"),
      ),
    );
  }

  protected abstract now(frame: Frame): CardNow | null;

  /** Gives an order. A second press continues from the first one before any frame has it. */
  private say(order: TugWord): void {
    this.ordered = order;
    this.chosen = false;
    this.sent = { tick: this.page.live.frame?.tick ?? 0, at_ms: performance.now() };
    void this.page.order({
      do: "tug",
      tug: this.name,
      order,
      power: this.percent / 100,
      lead: this.lead.value,
      place: (this.places?.value ?? "nearest") as Place,
    });
  }

  push(): void {
    this.say("push");
  }

  /** Pulls, or stands off. */
  away(): void {
    this.say(this.third);
  }

  stop(): void {
    this.say("stop");
  }

  power(percent: number): void {
    this.showPower(percent);
    this.again();
  }

  /** Gives the present order again, with another power, lead or place; only one that this card has a button for. */
  private again(): void {
    const order = this.ordered;
    if (order === "push" || order === "stop" || order === this.third) this.say(order);
  }

  private showPower(percent: number): void {
    this.percent = percent;
    this.powers.show(percent);
  }

  private isAnswered(tick: number): boolean {
    const since = tick - this.sent.tick;
    return (
      since < 0 || (since > ANSWERED.ticks && performance.now() - this.sent.at_ms > ANSWERED.ms)
    );
  }

  tick(frame: Frame): void {
    const now = this.now(frame);
    if (!now) return;
    // Orders may come from elsewhere: the tugmaster, another page, the scenario, a rewind.
    if (this.sent.tick === Infinity || this.isAnswered(frame.tick)) {
      this.ordered = now.order;
      if (now.power > 0 && now.power !== this.shownPower)
        this.showPower(Math.round(now.power * 100));
      this.shownPower = now.power;
      if (this.places && now.place && !this.chosen) this.places.value = now.place;
    }
    this.orders.show(this.ordered);
    const holder = this.commanded() ? null : this.heldBy();
    setText(this.state, `${now.text}${holder ? `; ${spoken(holder)}` : ""}`);
  }

  private commanded(): boolean {
    return this.page.live.mine(this.control);
  }

  private heldBy(): string | null {
    return this.page.live.holder(this.control)?.holder ?? null;
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
    this.root.title = holder ? `${spoken(holder)} has her` : "";
  }
}

/** A tug that is a force at the ship's side. */
class VectorTug extends TugCard {
  constructor(
    page: Page,
    info: TugInfo,
    private readonly index: number,
    hello: Hello,
  ) {
    super(page, info.name, { tug: info.name }, true, powersWithin(hello.limits.tug_power), []);
  }

  protected now(frame: Frame): CardNow | null {
    const now = frame.tugs[this.index];
    return now ? { order: now.order, power: now.power, place: null, text: vectorText(now) } : null;
  }
}

function vectorText(now: TugNow): string {
  const limited = now.limited ? " (all she has)" : "";
  if (now.order === "push")
    return `pushes ${tonnes(now.force_n)} of ${tonnes(now.order_n)}${limited}`;
  if (now.order === "pull")
    return `pulls ${tonnes(now.force_n)} of ${tonnes(now.order_n)}${limited}`;
  return now.force_n > NO_FORCE_N ? `easing, ${tonnes(now.force_n)}` : "stands by";
}

/** The forces of contact between a body and those that can move [N]. */
export function touching_n({ contacts }: Frame, body: number, movable: boolean[]): number {
  return contacts.reduce((sum, { bodies: [one, other], force_n }) => {
    const isOther = (one === body && movable[other]) || (other === body && movable[one]);
    return isOther ? sum + Math.hypot(...force_n) : sum;
  }, 0);
}

/** A tug that is a vessel: her own pilot takes her to the ship's side. */
export class VesselTug extends TugCard {
  private readonly body: number;
  private readonly movable: boolean[];
  private told = "";
  private isThere = false;

  constructor(
    page: Page,
    info: VesselInfo,
    private readonly index: number,
    hello: Hello,
  ) {
    const places = hello.vessels[info.serves ?? -1]?.places ?? [];
    const powers = powersWithin(hello.limits.tug_power);
    super(page, info.name, { vessel: info.name }, info.has_towline, powers, places);
    this.body = info.body;
    this.movable = hello.bodies.map(({ fixed }) => !fixed);
  }

  /** Notes whether the tug has come to the place where she stands off. */
  private arrive({ order, place, away_m }: AssistNow, touches: boolean): void {
    const told = `${order} ${place}`;
    if (told !== this.told || touches || (away_m ?? 0) > LEAVES_M) this.isThere = false;
    if (!touches && (away_m ?? 0) < ARRIVES_M) this.isThere = true;
    this.told = told;
  }

  protected now(frame: Frame): CardNow | null {
    const now = frame.vessels[this.index];
    if (!now) return null;
    const { assist } = now;
    if (!assist) {
      const pushes_n = touching_n(frame, this.body, this.movable);
      const text = pushes_n < NO_FORCE_N ? "by hand" : `by hand, pushes ${tonnes(pushes_n)}`;
      return { order: null, power: 0, place: null, text };
    }
    const { order, power, place } = assist;
    this.arrive(assist, touching_n(frame, this.body, this.movable) > NO_FORCE_N);
    return { order, power, place, text: assistText(assist, this.isThere) };
  }
}

/** A tug that is told to stand off has come to her place within this distance [m]. */
const ARRIVES_M = 10;
/** She stays at her place within this distance: beside a ship that turns she is no farther off [m]. */
const LEAVES_M = 35;

function assistText({ state, force_n, away_m, slack_m }: AssistNow, isThere: boolean): string {
  // Short, because the card is narrow.
  const toGo = away_m === null ? null : `${fixed(away_m, 0)} m to go`;
  switch (state) {
    case "stands_off":
      return isThere ? "standing off" : (toGo ?? "");
    case "comes_alongside":
      return toGo ?? "comes alongside";
    case "alongside":
      return "alongside";
    case "pushes":
      return `pushes ${tonnes(force_n)}`;
    case "takes_up_slack":
      return slack_m === null || slack_m < 0.5 ? "takes up slack" : `slack ${fixed(slack_m, 0)} m`;
    case "pulls":
      return `pulls ${tonnes(force_n)}`;
    default:
      return state satisfies never;
  }
}

/** All tugs of the pilot. */
export class Tugs implements Group {
  readonly name = "Tugs";
  readonly root: HTMLElement;
  readonly keys: KeyAction[];
  private readonly cards: TugCard[];
  private selected = 0;

  constructor(page: Page, hello: Hello) {
    const ship = page.live.ship();
    this.cards = [
      ...hello.tugs.flatMap((info, i) =>
        info.vessel === ship || hello.role.name === "instructor"
          ? [new VectorTug(page, info, i, hello)]
          : [],
      ),
      ...hello.vessels.flatMap((info, i) =>
        info.is_tug && info.serves === ship && info.azimuths.length > 0
          ? [new VesselTug(page, info, i, hello)]
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
            ...powersWithin(hello.limits.tug_power).map((p, i) => ({
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
