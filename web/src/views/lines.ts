/** The lines: tension against working and breaking load, and the winches. */
import { loadColour, palette } from "../palette";
import type { Order } from "../orders";
import type { Page } from "../page";
import type { Frame, Hello, LineInfo, LineNow } from "../protocol";
import { choices, h, setAttribute, setClass, setStyle, setText, sureButton } from "../ui/dom";
import { fixed, percent, spoken, tonnes } from "../units";
import type { View } from "./view";

const STATES: Record<LineNow["state"], string> = {
  ashore: "not yet fast",
  fast: "fast",
  parted: "PARTED",
  gone: "let go",
};

type Winch = LineNow["winch"];

function winchOrder(order: Winch, line: string, rate_mps: number): Order {
  return order === "hold" ? { do: order, line } : { do: order, line, rate_mps };
}

class Row {
  private readonly fill = h("div", { class: "fill" });
  private readonly bar: HTMLElement;
  private readonly figures = h("span", { class: "figures" });
  private readonly state = h("span", { class: "state" });
  private readonly winch;
  private readonly letGo: HTMLButtonElement;
  readonly root: HTMLElement;

  constructor(
    private readonly info: LineInfo,
    page: Page,
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
    this.root = h(
      "li",
      {},
      h("div", { class: "row-head" }, h("b", {}, spoken(info.name)), this.state, this.figures),
      this.bar,
      h("div", { class: "winch" }, info.winch_mps !== null && this.winch.root, this.letGo),
    );
  }

  show(now: LineNow, mayWinch: boolean): void {
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
    setText(this.state, now.over_working ? "OVER WORKING LOAD" : STATES[now.state]);
    setClass(this.root, "alarm", now.state === "parted");
    setClass(this.root, "caution", now.over_working);
    setClass(this.root, "idle", now.state !== "fast");
    this.winch.show(now.state === "fast" ? now.winch : null);
    for (const each of [...this.winch.buttons, this.letGo])
      each.disabled = !mayWinch || now.state !== "fast";
  }
}

/** Pilot and instructor may use every line, a tugmaster those of the own tug. */
function mayWork(info: LineInfo, { role, vessels }: Hello): boolean {
  if (role.name !== "tugmaster") return role.name !== "observer";
  const body = vessels.find((v) => v.name === role.tug)?.body;
  return (
    body !== undefined && (info.ship === body || ("body" in info.end && info.end.body === body))
  );
}

export class Lines implements View {
  private readonly rows: Row[];
  private readonly why = h("p", { class: "note" });
  readonly root: HTMLElement;

  constructor(page: Page, hello: Hello) {
    this.rows = hello.lines.map((info) => new Row(info, page));
    this.root = h(
      "div",
      { class: "lines" },
      hello.lines.length === 0
        ? h("p", { class: "nothing" }, "No lines in this scenario.")
        : h("ul", { class: "rows" }, ...this.rows.map((row) => row.root)),
      this.why,
    );
  }

  tick(frame: Frame, hello: Hello): void {
    const may = hello.lines.map((info) => mayWork(info, hello));
    frame.lines.forEach((now, i) => this.rows[i]?.show(now, may[i] ?? false));
    setText(
      this.why,
      may.length > 0 && !may.some(Boolean)
        ? hello.role.name === "tugmaster"
          ? "A tugmaster works the lines of her own tug."
          : "An observer works no line."
        : "The stroke is the working load; the bar's end is the breaking load.",
    );
  }
}
