/** The anchors: what the forecastle reports, and the windlass. */
import type { Page } from "../page";
import type { AnchorInfo, AnchorNow, Frame, Hello } from "../protocol";
import { button, h, setAttribute, setClass, setStyle, setText, sureButton } from "../ui/dom";
import { SHACKLE_M, fixed, percent, shackles, spoken, tonnes } from "../units";
import type { View } from "./view";

const WINDLASS: Record<AnchorNow["windlass"], string> = {
  hold: "on the brake",
  let_go: "running out",
  veer: "veering",
  heave: "heaving",
};

/** Chain that can be asked for, in half shackles up to the whole chain [m]. */
function lengths(chain_m: number): number[] {
  const halves = Math.floor(chain_m / SHACKLE_M + 1e-9) * 2;
  return Array.from({ length: halves + 1 }, (_, i) => (i * SHACKLE_M) / 2);
}

class Row {
  private readonly fill = h("div", { class: "fill" });
  private readonly bar: HTMLElement;
  private readonly report = h("p", { class: "report", "aria-live": "polite" });
  private readonly figures = h("span", { class: "figures" });
  private readonly windlass = h("span", { class: "state" });
  private readonly chain = h("select", {});
  private readonly letGo: HTMLButtonElement;
  private readonly veer: HTMLButtonElement;
  private readonly heave: HTMLButtonElement;
  private readonly hold: HTMLButtonElement;
  private readonly slip: HTMLButtonElement;
  readonly root: HTMLElement;

  constructor(
    private readonly info: AnchorInfo,
    page: Page,
  ) {
    const name = `anchor ${spoken(info.name)}`;
    const anchor = info.name;
    this.bar = h(
      "div",
      {
        class: "bar",
        role: "meter",
        "aria-label": `Tension of the chain of ${name}`,
        "aria-valuemin": 0,
        "aria-valuemax": 1,
      },
      this.fill,
      h("div", {
        class: "full",
        title: "the brake renders",
        style: `left:${((info.brake_n / info.breaking_n) * 100).toFixed(1)}%`,
      }),
    );
    setAttribute(this.chain, "aria-label", `Chain of ${name}`);
    this.chain.append(
      ...lengths(info.chain_m).map((m) =>
        h("option", { value: m, selected: m === 3 * SHACKLE_M }, m === 0 ? "home" : shackles(m)),
      ),
    );
    const wanted = (): number => Number(this.chain.value);
    this.letGo = sureButton(
      "Let go",
      "Sure?",
      () => void page.order({ do: "let_go_anchor", anchor, chain_m: wanted() }),
      { name: `Let go ${name}` },
    );
    this.veer = button("Veer", () => void page.order({ do: "veer", anchor, chain_m: wanted() }), {
      name: `Veer ${name}`,
    });
    this.heave = button(
      "Heave in",
      () => void page.order({ do: "heave_in", anchor, chain_m: wanted() }),
      { name: `Heave in ${name}` },
    );
    this.hold = button("Hold", () => void page.order({ do: "hold_chain", anchor }), {
      name: `Hold ${name}`,
    });
    this.slip = sureButton("Slip", "Lose it?", () => void page.order({ do: "slip", anchor }), {
      name: `Slip ${name}`,
    });
    this.root = h(
      "li",
      {},
      h("div", { class: "row-head" }, h("b", {}, spoken(info.name)), this.windlass, this.figures),
      this.report,
      this.bar,
      h("div", { class: "sending" }, this.chain, this.letGo, this.slip),
      h("div", { class: "winch" }, this.veer, this.hold, this.heave),
    );
  }

  show(now: AnchorNow, mayWork: boolean): void {
    const share = now.tension_n / this.info.breaking_n;
    setStyle(this.fill, "width", `${Math.min(100, share * 100).toFixed(1)}%`);
    setAttribute(this.bar, "aria-valuenow", share.toFixed(2));
    setText(this.report, now.report);
    const out = now.state === "hanging" || now.state === "on_bottom";
    setText(
      this.figures,
      out
        ? `${tonnes(now.tension_n)} · ${percent(share)} of ${fixed(this.info.breaking_n / 9806.65, 0)} t${
            now.state === "on_bottom" ? ` · holds ${tonnes(now.holding_n)}` : ""
          }`
        : "",
    );
    setText(this.windlass, this.words(now));
    setClass(this.root, "alarm", now.dragging || now.state === "lost");
    setClass(this.root, "idle", !out);
    const there = mayWork && now.state !== "lost";
    // The server answers what cannot be done at the moment with the reason.
    this.letGo.disabled = !there || now.state === "on_bottom";
    this.veer.disabled = !there;
    for (const each of [this.heave, this.hold, this.slip]) each.disabled = !there || !out;
    setAttribute(this.hold, "aria-pressed", String(out && now.windlass === "hold"));
  }

  private words(now: AnchorNow): string {
    if (now.state === "lost") return "LOST";
    if (now.dragging) return `DRAGGING, ${fixed(now.dragged_m, 0)} m`;
    if (now.faults.includes("windlass_failed")) return "windlass has no power";
    if (now.state === "housed") return "";
    if (now.stalled) return "windlass stalls";
    const to = now.to_m === null ? "" : ` to ${now.to_m === 0 ? "home" : shackles(now.to_m)}`;
    return `${WINDLASS[now.windlass]}${to}`;
  }
}

/** Pilot and instructor may work every anchor of the own ship, others those of their own vessel. */
function mayWork(info: AnchorInfo, { role, vessels }: Hello): boolean {
  const own =
    role.name === "tugmaster" ? role.tug : role.name === "pilot" ? (role.vessel ?? null) : null;
  if (own === null) return role.name !== "observer";
  return vessels.find(({ name }) => name === own)?.body === info.ship;
}

export class Anchors implements View {
  private readonly rows: Row[];
  private readonly may: boolean[];
  readonly root: HTMLElement;

  constructor(page: Page, hello: Hello) {
    this.may = hello.anchors.map((info) => mayWork(info, hello));
    this.rows = hello.anchors.map((info) => new Row(info, page));
    this.root = h(
      "div",
      { class: "lines anchors" },
      h("ul", { class: "rows" }, ...this.rows.map((row) => row.root)),
      h(
        "p",
        { class: "note" },
        this.may.some(Boolean)
          ? "Choose the chain that shall be out, then let go, veer or heave in. The stroke is where the brake renders; the bar's end is the breaking load."
          : "You work no anchor of this scenario.",
      ),
    );
  }

  tick(frame: Frame): void {
    frame.anchors.forEach((now, i) => this.rows[i]?.show(now, this.may[i] ?? false));
  }
}
