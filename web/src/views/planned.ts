/** When the instructor's changes happen: at once or later, at once or over a time; and the list of what is planned. */
import { visibilityWords } from "../controls/visibility";
import type { Page } from "../page";
import type { Frame, RecordedAction, PlannedNow } from "../protocol";
import { button, h, setText } from "../ui/dom";
import { clock, fixed, heading, spoken, toKnots } from "../units";

/** Minutes that can be chosen. */
const AFTER_MIN = [0, 1, 2, 5, 10, 15, 30, 60];
const OVER_MIN = [0, 1, 2, 5, 10, 20, 30, 60];
/** The time line shows at least this much ahead [s]. */
const SHOWN_S = 600;

const STATES: Record<PlannedNow["state"], string> = {
  waits: "planned",
  fired: "has happened",
  cancelled: "cancelled",
  refused: "could not happen",
};

/** A planned event in words. */
export function eventWords(event: RecordedAction): string {
  switch (event.do) {
    case "wind":
    case "current": {
      const [way, rad] = event.do === "wind" ? ["from", event.from_rad] : ["to", event.to_rad];
      const over = event.over_s ? ` over ${fixed(event.over_s / 60, 0)} min` : "";
      return `${event.do} ${fixed(toKnots(event.speed_mps), 1)} kn ${way} ${heading(rad, 0)}${over}`;
    }
    case "visibility": {
      const over = event.over_s ? ` over ${fixed(event.over_s / 60, 0)} min` : "";
      return `visibility ${visibilityWords(event.distance_m)}${over}`;
    }
    case "fault":
      return `${spoken(event.vessel)}: ${event.fault.replaceAll("_", " ")}${event.on ? "" : " ends"}`;
    case "thruster_out":
      return `${spoken(event.vessel)}: thruster ${spoken(event.thruster)} ${event.on ? "trips" : "comes back"}`;
    case "part_line":
      return `line ${spoken(event.line)} parts`;
    case "anchor_fault":
      return `anchor ${spoken(event.anchor)}: ${event.fault.replaceAll("_", " ")}${event.on ? "" : " ends"}`;
    case "tug_out":
      return `${spoken(event.tug)} ${event.on ? "drops out" : "comes back"}`;
    default:
      return event.do;
  }
}

const minutes = (list: number[], zero: string): HTMLOptionElement[] =>
  list.map((min) => h("option", { value: min }, min === 0 ? zero : `${min} min`));

export class Planned {
  private readonly after = h("select", { id: "when-after" }, ...minutes(AFTER_MIN, "now"));
  private readonly over = h("select", { id: "when-over" }, ...minutes(OVER_MIN, "at once"));
  private readonly list = h("ul", { class: "rows planned", "aria-label": "Planned events" });
  private readonly line = h("div", { class: "plan-line", "aria-hidden": "true" });
  private events: PlannedNow[] = [];
  private t_s = 0;
  private shown_s = -1;
  /** Above the controls of weather and faults. */
  readonly when: HTMLElement;
  readonly root: HTMLElement;

  constructor(private readonly page: Page) {
    this.when = h(
      "div",
      { class: "row when" },
      h("label", { for: "when-after" }, "Changes happen in"),
      this.after,
      h("label", { for: "when-over" }, "weather changes over"),
      this.over,
    );
    this.root = h("div", { class: "plan-of-events" }, h("h3", {}, "Planned"), this.line, this.list);
    this.show();
  }

  /** Time over which wind and current change [s]. */
  over_s(): number {
    return Number(this.over.value) * 60;
  }

  /** How much later changes happen [s]; 0: now. */
  after_s(): number {
    return Number(this.after.value) * 60;
  }

  /** Gives a command now, or plans it. */
  async happen(event: RecordedAction): Promise<boolean> {
    const after_s = this.after_s();
    if (after_s === 0) return this.page.order(event);
    const at_s = (this.page.live.frame?.t_s ?? 0) + after_s;
    const done = await this.page.order({ do: "plan", at_s, event });
    if (done) this.page.say(`Planned for ${clock(at_s)}: ${eventWords(event)}.`);
    return done;
  }

  heard(events: PlannedNow[]): void {
    this.events = events;
    this.show();
  }

  tick(frame: Frame): void {
    this.t_s = frame.t_s;
    // The marks move by less than a pixel a second.
    if (Math.abs(frame.t_s - this.shown_s) > 1) this.showLine();
  }

  private show(): void {
    this.list.replaceChildren(
      ...this.events.map((planned) => {
        const text = eventWords(planned.event);
        const state = planned.reason ?? STATES[planned.state];
        return h(
          "li",
          { class: planned.state === "waits" ? "" : "idle" },
          h("b", {}, clock(planned.at_s)),
          h("span", { class: "what" }, text),
          h("span", { class: "state" }, state),
          planned.state === "waits" &&
            button("Cancel", () => void this.page.order({ do: "cancel_planned", id: planned.id }), {
              name: `Cancel: ${text} at ${clock(planned.at_s)}`,
            }),
        );
      }),
    );
    if (this.events.length === 0)
      this.list.replaceChildren(
        h(
          "li",
          { class: "idle" },
          "Nothing. Choose a time above, then set the weather or a fault.",
        ),
      );
    this.showLine();
  }

  private showLine(): void {
    this.shown_s = this.t_s;
    const waiting = this.events.filter(({ state }) => state === "waits");
    const end_s = Math.max(SHOWN_S, ...waiting.map(({ at_s }) => at_s - this.t_s));
    this.line.hidden = waiting.length === 0;
    const label = h("span", { class: "end" });
    setText(label, `${Math.ceil(end_s / 60)} min`);
    this.line.replaceChildren(
      ...waiting.map(({ at_s, event }) =>
        h("i", {
          title: `${clock(at_s)} ${eventWords(event)}`,
          style: `left:${(Math.max(0, at_s - this.t_s) / end_s) * 100}%`,
        }),
      ),
      label,
    );
  }
}
