/** The instructor places ship and tugs before the start: by dragging in the plan, or by numbers. */
import type { Page } from "../page";
import type { Placing } from "../placing";
import type { Frame, Hello } from "../protocol";
import { button, h, setClass, setText } from "../ui/dom";
import { KNOT_MPS, fixed, spoken, toDegrees, toKnots, toRadians } from "../units";
import type { View } from "./view";

/** A field with its unit. */
function field(name: string, unit: string, step: number) {
  const input = h("input", { type: "number", step, value: 0 });
  const root = h("label", { class: "field" }, h("span", {}, name), input, h("span", {}, unit));
  return { input, root };
}

class Row {
  private readonly north = field("North", "m", 1);
  private readonly east = field("East", "m", 1);
  private readonly heading = field("Heading", "°", 1);
  private readonly speed = field("Speed ahead", "kn", 0.1);
  private touched = false;
  private known_kn = 0;
  readonly root: HTMLElement;

  constructor(
    private readonly page: Page,
    private readonly placing: Placing,
    private readonly vessel: number,
    private readonly name: string,
    title: string,
  ) {
    const fields = [this.north, this.east, this.heading, this.speed];
    for (const { input } of fields) {
      input.addEventListener("input", () => (this.touched = true));
      input.addEventListener("focus", () => this.choose());
    }
    this.root = h(
      "form",
      {
        class: "place-row",
        "aria-label": `Place ${spoken(name)}`,
        onsubmit: (event: Event) => {
          event.preventDefault();
          void this.place();
        },
      },
      h("h3", {}, `${spoken(name)} · ${title}`),
      h("div", { class: "fields" }, ...fields.map(({ root }) => root)),
      h("button", { type: "submit", class: "take" }, "Place"),
    );
  }

  private choose(): void {
    this.placing.chosen = this.vessel;
  }

  private async place(): Promise<void> {
    this.choose();
    const value = ({ input }: { input: HTMLInputElement }) => Number(input.value);
    const kn = value(this.speed);
    const done = await this.page.order({
      do: "place",
      vessel: this.name,
      at_m: [value(this.north), value(this.east)],
      heading_rad: toRadians(value(this.heading)),
      // Not changed: she keeps her speed to the last digit.
      ...(kn !== this.known_kn && { ahead_mps: kn * KNOT_MPS }),
    });
    if (done) this.touched = false;
  }

  tick(frame: Frame, hello: Hello): void {
    setClass(this.root, "chosen", this.placing.chosen === this.vessel);
    const body = frame.bodies[hello.vessels[this.vessel]?.body ?? -1];
    if (!body) return;
    const ghost = this.placing.ghost?.vessel === this.vessel ? this.placing.ghost : null;
    if (ghost) this.touched = false;
    if (this.touched) return;
    const [north, east] = ghost?.at ?? [body[0], body[1]];
    const heading_rad = ghost?.heading_rad ?? body[2];
    const degrees = ((toDegrees(heading_rad) % 360) + 360) % 360;
    const kn = toKnots(frame.vessels[this.vessel]?.ground_mps[0] ?? 0);
    this.known_kn = Number(fixed(kn, 2));
    for (const [{ input }, text] of [
      [this.north, fixed(north, 1)],
      [this.east, fixed(east, 1)],
      [this.heading, fixed(degrees, 1)],
      [this.speed, fixed(kn, 2)],
    ] as const)
      if (input.value !== text) input.value = text;
  }
}

export class Place implements View {
  private readonly rows: Row[];
  private readonly note = h("p", { class: "note" });
  private readonly before = h("div", { class: "place-rows" });
  private readonly after: HTMLElement;
  private frame: Frame | null = null;
  readonly root: HTMLElement;

  constructor(
    page: Page,
    private readonly placing: Placing,
    private readonly hello: Hello,
    /** Called when ships can be dragged. */
    private readonly begins: () => void,
  ) {
    placing.of(hello);
    this.rows = hello.vessels.map(
      ({ name, title }, index) => new Row(page, placing, index, name, title),
    );
    this.before.append(...this.rows.map(({ root }) => root));
    const back = button(
      "Go back to the start",
      () =>
        void page
          .order({ do: "rewind", tick: 0 })
          .then((done) => done && page.order({ do: "branch" })),
      { class: "take" },
    );
    this.after = h(
      "div",
      { class: "after" },
      h(
        "p",
        {},
        "The run has begun: ships are placed before the start. What was done so far stays in the recording as another branch.",
      ),
      back,
    );
    this.root = h("div", { class: "place" }, this.note, this.before, this.after);
  }

  /** While the tab is shown and the run has not begun, ships can be dragged. */
  shown(on: boolean): void {
    const { frame } = this;
    const can = on && frame !== null && frame.tick === 0 && frame.run.last_tick === 0;
    if (can && !this.placing.on) this.begins();
    this.placing.on = can;
    if (!can) this.placing.ghost = null;
  }

  tick(frame: Frame, hello: Hello): void {
    this.frame = frame;
    const can = frame.tick === 0 && frame.run.last_tick === 0;
    setText(
      this.note,
      can
        ? "Drag a ship in the plan, and the knob ahead of her to turn her; or fill in numbers. Positions are of her centre of gravity."
        : "",
    );
    setClass(this.before, "hidden", !can);
    setClass(this.after, "hidden", can);
    for (const row of this.rows) row.tick(frame, hello);
  }

  /** Shows where a dragged ship is. */
  changed(): void {
    if (this.frame) for (const row of this.rows) row.tick(this.frame, this.hello);
  }
}
