/** The tab of the trial manoeuvre: its orders, how far it looks ahead, what comes of it, and the button that gives the orders. */
import type { Page } from "../page";
import type { Frame, Hello, TrialOrder } from "../protocol";
import { button, choices, h, setClass, setText } from "../ui/dom";
import { fixed, heading, knots, shackles, spoken } from "../units";
import type { View } from "./view";

/** Minutes that can be chosen. */
const HORIZONS_MIN = [1, 2, 5, 10, 15];
/** Time between two trials of the same orders: the run goes on [ms]. */
const AGAIN_MS = 2000;
/** Time between two trials while a control is dragged [ms]. */
const LEAST_MS = 200;

const degrees = (rad: number): number => Math.round(Math.abs((rad * 180) / Math.PI));
const side = (rad: number): string =>
  Math.abs(rad) < 1e-3 ? "amidships" : `${rad < 0 ? "port" : "starboard"} ${degrees(rad)}°`;

/** An order in words. The server has the words of reports; these are for the page's own list. */
export function words(order: TrialOrder, hello: Hello): string {
  switch (order.do) {
    case "tug": {
      const power = order.order === "push" || order.order === "pull";
      const share = power ? ` ${fixed((order.power ?? 0) * 100, 0)} %` : "";
      const place = order.place === "nearest" ? "" : `, ${order.place}`;
      return `${spoken(order.tug)}: ${order.order.replace("_", " ")}${share}${place}`;
    }
    case "rudder":
      return `${spoken(order.vessel)}: rudder ${side(order.angle_rad)}`;
    case "engine": {
      const told = hello.telegraph.find(({ share }) => Math.abs(share - order.share) < 1e-6);
      return `${spoken(order.vessel)}: engine ${told?.word ?? `${fixed(order.share * 100, 0)} %`}`;
    }
    case "thruster": {
      const way = order.power < 0 ? "port" : "starboard";
      const power = `${fixed(Math.abs(order.power) * 100, 0)} % to ${way}`;
      return `${spoken(order.vessel)}: ${order.name} thruster ${order.power === 0 ? "stop" : power}`;
    }
    case "azimuth":
      return `${spoken(order.vessel)}: ${spoken(order.name)} ${order.power === null ? "" : `${fixed(order.power * 100, 0)} %`} ${order.direction_rad === null ? "" : heading(order.direction_rad, 0)}`;
    case "course":
      return `${spoken(order.vessel)}: course ${heading(order.heading_rad, 0)}`;
    case "speed":
      return `${spoken(order.vessel)}: speed ${knots(order.speed_mps, 1)}`;
    case "push":
    case "pull":
      return `${spoken(order.tug)}: ${order.do} ${fixed(order.force_n / 9806.65, 0)} t`;
    case "stand_by":
      return `${spoken(order.tug)}: stand by`;
    case "send":
      return `line ${spoken(order.line)}: to ${spoken(order.bollard)}`;
    case "heave":
    case "pay_out":
    case "hold":
    case "let_go":
      return `line ${spoken(order.line)}: ${order.do.replace("_", " ")}`;
    case "let_go_anchor":
      return `anchor ${spoken(order.anchor)}: let go, ${shackles(order.chain_m)}`;
    case "veer":
    case "heave_in":
      return `anchor ${spoken(order.anchor)}: ${order.do.replace("_", " ")} to ${shackles(order.chain_m)}`;
    case "hold_chain":
    case "slip":
      return `anchor ${spoken(order.anchor)}: ${order.do.replace("_", " ")}`;
    default:
      return `${spoken(order.vessel)}: ${order.do.replace("_", " ")}`;
  }
}

export class TrialView implements View {
  private readonly list = h("ul", { class: "rows tried", "aria-label": "Orders of the trial" });
  private readonly empty = h(
    "p",
    { class: "note" },
    "Start a trial. Then use rudder, engine, thrusters, tugs and lines as always: nothing is given, the plan shows where it would take the ship.",
  );
  private readonly outcome = h("p", { class: "outcome", role: "status" });
  private readonly onButton: HTMLButtonElement;
  private readonly giveButton: HTMLButtonElement;
  private readonly clearButton: HTMLButtonElement;
  private readonly horizon;
  private hello: Hello;
  private shown = "";
  private asked_ms = 0;
  private stale = false;
  private pending = 0;
  readonly root: HTMLElement;

  constructor(
    private readonly page: Page,
    hello: Hello,
    /** The page marks its controls while a trial is on. */
    private readonly marked: (on: boolean) => void,
  ) {
    this.hello = hello;
    const [least_s, most_s] = hello.limits.trial_s;
    this.horizon = choices(
      "How far ahead",
      HORIZONS_MIN.filter((min) => min * 60 >= least_s && min * 60 <= most_s).map((min) => ({
        value: min * 60,
        label: `${min} min`,
        name: `Look ${min} minutes ahead`,
      })),
      (seconds) => {
        this.page.trial.horizon_s = seconds;
        this.changed();
      },
    );
    this.onButton = button("Start a trial", () => this.toggle(), {
      class: "take",
      name: "Start or end a trial (Z)",
    });
    this.giveButton = button("Give these orders", () => void this.give(), { class: "give" });
    this.clearButton = button("Clear", () => {
      this.page.trial.clear();
      this.changed();
    });
    this.root = h(
      "div",
      { class: "trial" },
      h("div", { class: "row" }, this.onButton, this.giveButton, this.clearButton),
      this.horizon.root,
      this.empty,
      this.list,
      this.outcome,
    );
    this.show();
  }

  toggle(): void {
    const { trial } = this.page;
    if (trial.on) trial.end();
    else trial.on = true;
    this.page.did("trial");
    this.changed();
  }

  /** The orders or the horizon have changed. */
  changed(): void {
    this.stale = true;
    this.show();
    this.ask();
  }

  private async give(): Promise<void> {
    const { trial } = this.page;
    const orders = [...trial.orders];
    if (!(await this.page.order({ do: "give", orders }))) return;
    this.page.say(orders.length === 1 ? "Given." : `${orders.length} orders given.`);
    trial.end();
    this.changed();
  }

  /** Asks the server if the answer is old. */
  private ask(): void {
    const { trial, live } = this.page;
    const now = performance.now();
    if (!trial.on || trial.orders.length === 0 || this.pending > 0) return;
    const since = now - this.asked_ms;
    const moves = live.frame !== null && !live.frame.run.paused;
    if (since < LEAST_MS || !(this.stale || (moves && since > AGAIN_MS))) return;
    this.asked_ms = now;
    this.stale = false;
    this.pending += 1;
    void this.page
      .trialOf({ do: "trial", orders: trial.orders, horizon_s: trial.horizon_s })
      .then((reason) => {
        this.pending -= 1;
        trial.refused = reason;
        if (reason !== null) trial.answer = null;
        this.show();
      });
  }

  private show(): void {
    const { trial } = this.page;
    this.marked(trial.on);
    setText(this.onButton, trial.on ? "End the trial" : "Start a trial");
    setClass(this.onButton, "chosen", trial.on);
    this.giveButton.disabled = trial.orders.length === 0 || trial.refused !== null;
    this.clearButton.disabled = trial.orders.length === 0;
    this.horizon.show(trial.horizon_s);
    this.empty.hidden = trial.orders.length > 0;
    setText(
      this.empty,
      trial.on
        ? "Now use rudder, engine, thrusters, tugs and lines as always: nothing is given."
        : "Start a trial. Then use rudder, engine, thrusters, tugs and lines as always: nothing is given, the plan shows where it would take the ship.",
    );
    const texts = trial.orders.map((order) => words(order, this.hello));
    const key = texts.join("\n");
    if (key !== this.shown) {
      this.shown = key;
      this.list.replaceChildren(
        ...trial.orders.map((order, i) =>
          h(
            "li",
            {},
            h("b", {}, texts[i] ?? ""),
            button(
              "×",
              () => {
                trial.drop(order);
                this.changed();
              },
              { name: `Take out: ${texts[i]}` },
            ),
          ),
        ),
      );
    }
    const { text, alarm } = this.result();
    setText(this.outcome, text);
    setClass(this.outcome, "alarm", alarm);
  }

  private result(): { text: string; alarm: boolean } {
    const { trial } = this.page;
    if (trial.refused !== null) return { text: `Refused: ${trial.refused}`, alarm: true };
    const { answer } = trial;
    const path = answer?.paths[0]?.path;
    const last = path?.at(-1);
    if (!answer || !path || !last || path.length < 2) return { text: "", alarm: false };
    const before = path.at(-2) ?? last;
    const speed = Math.hypot(last[1] - before[1], last[2] - before[2]) / (last[0] - before[0]);
    const ahead_s = last[0] - (path[0]?.[0] ?? 0);
    const then = `In ${fixed(ahead_s / 60, 1)} min: heading ${heading(last[3], 0)}, ${knots(speed, 1)}.`;
    const cut = answer.complete ? "" : " …";
    const found = answer.findings
      .map((finding) => ` ${finding.charAt(0).toUpperCase()}${finding.slice(1)}.`)
      .join("");
    return { text: `${then}${cut}${found}`, alarm: found !== "" };
  }

  tick(_frame: Frame, hello: Hello): void {
    this.hello = hello;
    this.ask();
    this.show();
  }
}
