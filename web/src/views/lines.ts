/** The lines: tension against working and breaking load, and the winches. */
import { loadColour, palette } from "../palette";
import { length, minus, onEarth } from "../geometry";
import { firstOffered, fromFairlead } from "../lead";
import type { Order } from "../orders";
import type { Page } from "../page";
import type {
  BodyNow,
  BollardInfo,
  Frame,
  Hello,
  LineInfo,
  LineNow,
  TensionInfo,
} from "../protocol";
import { choices, h, setAttribute, setClass, setStyle, setText, sureButton } from "../ui/dom";
import { fixed, percent, spoken, tonnes } from "../units";
import type { View } from "./view";

const STATES: Record<LineNow["state"], string> = {
  ashore: "not yet fast",
  fast: "fast",
  parted: "PARTED",
  aboard: "on board",
  sent: "on its way",
};

/** Distances to bollards are shown anew after this time, and not while the list is open [s]. */
const ANEW_AFTER_S = 2;

/** States of a line in the overview, in a word; a line that is fast has its tension there. */
const SHORT: Record<Exclude<LineNow["state"], "fast">, string> = {
  ashore: "ashore",
  aboard: "aboard",
  sent: "sent",
  parted: "PARTED",
};
/** From this share of the working load on a tension is amber in the overview. */
const NEAR_WORKING = 0.8;
/** Fewer lines than this stand on the panel without scrolling. */
const LEAST_FOR_OVERVIEW = 4;

type Winch = LineNow["winch"];

function winchOrder(order: Winch, line: string, rate_mps: number): Order {
  return order === "hold" ? { do: order, line } : { do: order, line, rate_mps };
}

/** The tensions that the goal of the exercise asks for, on the bar of a line. */
function goalBand({ least_n, most_n }: TensionInfo, breaking_n: number): HTMLElement {
  const at = (newtons: number) => Math.min(100, (newtons / breaking_n) * 100);
  const [from, to] = [at(least_n), at(most_n ?? breaking_n)];
  const upTo = most_n === null ? " and more" : ` to ${tonnes(most_n)}`;
  return h("div", {
    class: "goal",
    title: `goal: ${tonnes(least_n)}${upTo}`,
    style: `left:${from}%;width:${to - from}%`,
  });
}

class Row {
  private readonly fill = h("div", { class: "fill" });
  private readonly bar: HTMLElement;
  private readonly figures = h("span", { class: "figures" });
  private readonly state = h("span", { class: "state" });
  private readonly winch;
  private readonly letGo: HTMLButtonElement;
  private readonly bollards = h("select", {});
  private readonly send: HTMLButtonElement;
  private readonly sending: HTMLElement;
  private readonly work: HTMLElement;
  private shown_s = -Infinity;
  /** A bollard was chosen by hand; until then it is where a line of this name leads. */
  private chosen = false;
  private offered: string | null = null;
  /** Distance to each bollard as it is listed [m]. */
  private far = new Map<string, number>();
  private readonly tooFar = h("p", { class: "note", role: "status" });
  readonly root: HTMLElement;

  constructor(
    private readonly info: LineInfo,
    page: Page,
    private readonly hello: Hello,
    /** What the goal of the exercise asks of this line. */
    goal: TensionInfo | null,
  ) {
    const worked = (info.working_n / info.breaking_n) * 100;
    this.bar = h(
      "div",
      {
        class: "bar",
        role: "meter",
        "aria-label": `Tension of ${info.name}`,
        "aria-valuemin": 0,
        "aria-valuemax": 1,
      },
      this.fill,
      h("div", { class: "full", title: "working load", style: `left:${worked}%` }),
      goal && goalBand(goal, info.breaking_n),
    );
    this.winch = choices<Winch>(
      `Winch of ${info.name}`,
      [
        { value: "heave", label: "Heave", name: `Heave ${info.name}` },
        { value: "hold", label: "Hold", name: `Hold ${info.name}` },
        { value: "pay_out", label: "Pay out", name: `Pay out ${info.name}` },
      ],
      (order) => void page.order(winchOrder(order, info.name, info.winch_mps ?? 0)),
    );
    this.letGo = sureButton(
      "Let go",
      "Sure?",
      () => void page.order({ do: "let_go", line: info.name }),
      { name: `Let go ${info.name}` },
    );
    setAttribute(this.bollards, "aria-label", `Bollard for ${spoken(info.name)}`);
    this.bollards.addEventListener("change", () => {
      this.chosen = true;
      this.explain();
    });
    this.send = h(
      "button",
      { type: "button", "aria-label": `Send ${spoken(info.name)} ashore` },
      "Send",
    );
    this.send.addEventListener(
      "click",
      () => void page.order({ do: "send", line: info.name, bollard: this.bollards.value }),
    );
    this.work = h(
      "div",
      { class: "winch" },
      info.winch_mps !== null && this.winch.root,
      this.letGo,
    );
    this.sending = h("div", { class: "sending" }, this.bollards, this.send);
    this.root = h(
      "li",
      {},
      h("div", { class: "row-head" }, h("b", {}, spoken(info.name)), this.state, this.figures),
      this.bar,
      this.sending,
      this.tooFar,
      this.work,
    );
  }

  /** Lists the bollards by their distance from the fairlead, the nearest first. */
  private list(bodies: (BodyNow | null | undefined)[], t_s: number): void {
    const fresh = Math.abs(t_s - this.shown_s) < ANEW_AFTER_S;
    if (fresh || document.activeElement === this.bollards) return;
    this.shown_s = t_s;
    const ship = bodies[this.info.ship];
    if (!ship) return;
    const from = onEarth(ship, this.info.fairlead_m);
    const far = ({ body, at_m }: BollardInfo): number => {
      const on = bodies[body];
      return on ? length(minus(onEarth(on, at_m), from)) : Infinity;
    };
    const others = this.hello.bollards.filter(({ body }) => body !== this.info.ship);
    const near = others
      .map((bollard) => ({ bollard, m: far(bollard) }))
      .toSorted((a, b) => a.m - b.m);
    const chosen = this.bollards.value;
    this.far = new Map(near.map(({ bollard, m }) => [bollard.name, m]));
    this.bollards.replaceChildren(
      ...near.map(({ bollard, m }) =>
        h(
          "option",
          { value: bollard.name },
          `${spoken(bollard.name)} · ${m.toFixed(0)} m${this.reaches(m) ? "" : " · too far"}`,
        ),
      ),
    );
    if (this.chosen && near.some(({ bollard }) => bollard.name === chosen))
      this.bollards.value = chosen;
    else this.offer(ship, near, bodies);
    this.explain();
  }

  private offer(
    ship: BodyNow,
    near: { bollard: BollardInfo; m: number }[],
    bodies: (BodyNow | null | undefined)[],
  ): void {
    const places = near.flatMap(({ bollard: { name, body, at_m }, m }) => {
      const on = bodies[body];
      if (!on) return [];
      return [
        { name, from_fairlead: fromFairlead(ship, this.info.fairlead_m, onEarth(on, at_m)), m },
      ];
    });
    const offered = firstOffered(
      this.info.name,
      this.info.fairlead_m,
      places,
      (m) => this.reaches(m),
      this.offered,
    );
    if (!offered) return;
    this.bollards.value = this.offered = offered.name;
  }

  /**
   * Whether a bollard at a distance on the chart is within reach. The server measures along the slope, which is a little longer, and
   * decides.
   */
  private reaches(m: number): boolean {
    return m <= this.info.reach_m;
  }

  /** Says why the chosen bollard is too far. */
  private explain(): void {
    const m = this.far.get(this.bollards.value);
    const { reach_m, reach_by } = this.info;
    setText(
      this.tooFar,
      m === undefined || this.reaches(m)
        ? ""
        : `${spoken(this.bollards.value)} is ${m.toFixed(0)} m away; ${reach_by} reaches ${reach_m.toFixed(0)} m${
            reach_by === "the rope" ? "" : ", and there is no boat"
          }.`,
    );
  }

  show(now: LineNow, mayWinch: boolean, bodies: (BodyNow | null | undefined)[], t_s: number): void {
    const canSend = now.state === "aboard" && this.hello.bollards.length > 0;
    this.sending.hidden = !canSend;
    this.work.hidden = canSend;
    this.tooFar.hidden = !canSend;
    if (canSend) this.list(bodies, t_s);
    this.send.disabled = !mayWinch || this.bollards.value === "";
    const colours = palette();
    const share = now.tension_n / this.info.breaking_n;
    const worked = now.tension_n / this.info.working_n;
    setStyle(this.fill, "width", `${Math.min(100, share * 100).toFixed(1)}%`);
    setStyle(this.fill, "background", loadColour(worked, colours));
    setAttribute(this.bar, "aria-valuenow", share.toFixed(2));
    setText(
      this.figures,
      now.state === "fast"
        ? `${tonnes(now.tension_n)} · ${percent(share)} of ${fixed(this.info.breaking_n / 9806.65, 0)} t`
        : "",
    );
    setText(this.state, now.over_working ? "OVER WORKING LOAD" : this.stateOf(now));
    setClass(this.root, "alarm", now.state === "parted");
    setClass(this.root, "caution", now.over_working);
    setClass(this.root, "idle", now.state !== "fast");
    this.winch.show(now.state === "fast" ? now.winch : null);
    for (const each of this.winch.buttons) each.disabled = !mayWinch || now.state !== "fast";
    this.letGo.disabled = !mayWinch || !(now.state === "fast" || now.state === "sent");
  }

  private stateOf(now: LineNow): string {
    const bollard = now.bollard === null ? undefined : this.hello.bollards[now.bollard];
    if (!bollard) return STATES[now.state];
    const name = spoken(bollard.name);
    if (now.state === "fast") return `fast at ${name}`;
    if (now.state !== "sent") return STATES[now.state];
    return now.fast_in_s === null
      ? `waits for line handlers, to ${name}`
      : `to ${name}, fast in ${Math.ceil(now.fast_in_s)} s`;
  }
}

/** Pilot and instructor may use every line, the pilot of another ship and a tugmaster those of the own vessel. */
function mayWork(info: LineInfo, { role, vessels }: Hello): boolean {
  const own =
    role.name === "tugmaster" ? role.tug : role.name === "pilot" ? (role.vessel ?? null) : null;
  if (own === null) return role.name !== "observer";
  const body = vessels.find((v) => v.name === own)?.body;
  return (
    body !== undefined &&
    (info.ship === body || (info.end !== null && "body" in info.end && info.end.body === body))
  );
}

/** The tensions of all lines at a glance, where the rows of the lines are longer than the panel. */
class Overview {
  private readonly cells: HTMLElement[];
  readonly root: HTMLElement;

  /** `order`: indices of the lines, as their rows stand. */
  constructor(
    private readonly infos: LineInfo[],
    private readonly order: number[],
  ) {
    this.cells = order.map(() => h("b", {}));
    this.root = h(
      "ul",
      { class: "overview", "aria-label": "Tensions of all lines" },
      ...order.map((line, i) =>
        h("li", {}, h("span", {}, spoken(infos[line]?.name ?? "")), " ", this.cells[i] ?? ""),
      ),
    );
  }

  show(lines: LineNow[]): void {
    this.order.forEach((line, i) => {
      const [now, cell] = [lines[line], this.cells[i]];
      const item = cell?.parentElement;
      if (!now || !cell || !item) return;
      const working_n = this.infos[line]?.working_n ?? Infinity;
      setText(cell, now.state === "fast" ? tonnes(now.tension_n) : SHORT[now.state]);
      setClass(item, "alarm", now.state === "parted");
      setClass(item, "caution", now.over_working || now.tension_n > NEAR_WORKING * working_n);
    });
  }
}

export class Lines implements View {
  private readonly rows: Row[];
  private readonly overview: Overview;
  /** The goal of the exercise asks for tensions. */
  private readonly asked: boolean;
  private readonly why = h("p", { class: "note" });
  private readonly count = h("p", { class: "note count", "aria-live": "polite" });
  readonly root: HTMLElement;

  constructor(page: Page, hello: Hello) {
    const goal = hello.exercise?.tension ?? null;
    this.asked = goal !== null;
    this.rows = hello.lines.map(
      (info, i) => new Row(info, page, hello, goal?.lines.includes(i) ? goal : null),
    );
    // First what the page's people may work, as the towline on a tugmaster's page; else mooring lines before towlines.
    const last = (info: LineInfo) => (mayWork(info, hello) ? 0 : 2) + (info.is_towline ? 1 : 0);
    const order = hello.lines
      .map((info, i) => ({ i, at: last(info) }))
      .toSorted((a, b) => a.at - b.at)
      .map(({ i }) => i);
    const inOrder = order.flatMap((i) => this.rows[i] ?? []);
    this.overview = new Overview(hello.lines, order);
    setClass(this.overview.root, "hidden", order.length < LEAST_FOR_OVERVIEW);
    this.root = h(
      "div",
      { class: "lines" },
      this.overview.root,
      this.count,
      hello.lines.length === 0
        ? h("p", { class: "nothing" }, "No lines in this scenario.")
        : h("ul", { class: "rows" }, ...inOrder.map((row) => row.root)),
      this.why,
    );
  }

  tick(frame: Frame, hello: Hello): void {
    const may = hello.lines.map((info) => mayWork(info, hello));
    frame.lines.forEach((now, i) =>
      this.rows[i]?.show(now, may[i] ?? false, frame.bodies, frame.t_s),
    );
    this.overview.show(frame.lines);
    const own = frame.lines.filter((_, i) => hello.lines[i]?.is_towline === false);
    const fast = own.filter(({ state }) => state === "fast").length;
    setText(
      this.count,
      own.length === 0
        ? ""
        : fast === own.length
          ? `All fast: ${fast} lines.`
          : `${fast} of ${own.length} lines to the berth are fast.`,
    );
    setText(
      this.why,
      may.length > 0 && !may.some(Boolean)
        ? hello.role.name === "tugmaster"
          ? "A tugmaster works the lines of her own tug."
          : "An observer works no line."
        : `The stroke is the working load; the bar's end is the breaking load${this.asked ? "; the frame is what the goal asks for" : ""}.`,
    );
  }
}
