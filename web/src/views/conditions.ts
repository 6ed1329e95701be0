/** The instructor's weather and faults. */
import { Visibility } from "../controls/visibility";
import type { Page } from "../page";
import type { AnchorFault, Fault, Frame, Hello, RecordedAction, Pair } from "../protocol";
import { button, h, setAttribute, setText, sureButton } from "../ui/dom";
import { Ring } from "../ui/ring";
import { KNOT_MPS, clock, fixed, heading, spoken, toKnots } from "../units";
import { Planned } from "./planned";
import type { View } from "./view";

const FAULTS: { fault: Fault; text: string }[] = [
  { fault: "rudder_stuck", text: "Rudder stuck" },
  { fault: "follow_up_lost", text: "Rudder does not follow" },
  { fault: "engine_lost", text: "Engine lost" },
  { fault: "thrusters_lost", text: "Thrusters lost" },
  { fault: "blackout", text: "Blackout" },
];
/** What her pilot's page shows stays as it is; nobody on board is told. */
const FROZEN: { fault: Fault; text: string }[] = [
  { fault: "heading_frozen", text: "Heading frozen" },
  { fault: "speed_frozen", text: "Speeds frozen" },
  { fault: "position_frozen", text: "Position frozen" },
];

const capital = (text: string): string => text.replace(/^./, (c) => c.toUpperCase());

const ANCHOR_FAULTS: { fault: AnchorFault; text: string }[] = [
  { fault: "windlass_failed", text: "Windlass fails" },
  { fault: "does_not_bite", text: "Does not bite" },
];

/** Whether a change began now, and how long it takes [s]. */
interface Applied {
  done: boolean;
  over_s: number;
}

/** A flow of air or water. "Set" sends speed and direction together, so that a half-turned ring changes nothing yet. */
class Flow {
  private readonly speed = h("output", { class: "wanted" });
  private readonly now = h("p", { class: "note" });
  private readonly ring: Ring;
  private kn = 0;
  private touched = false;
  /** The change that was ordered last on this page and takes its time: where it goes, and from when until when [s]. */
  private going: { to: string; from_s: number; until_s: number } | null = null;
  private t_s = 0;
  readonly root: HTMLElement;

  constructor(
    private readonly name: "Wind" | "Current",
    private readonly verb: string,
    private readonly step_kn: number,
    [least_mps, most_mps]: Pair,
    apply: (mps: number, rad: number) => Promise<Applied>,
  ) {
    const wanted = () =>
      `${fixed(this.kn, step_kn < 1 ? 1 : 0)} kn ${verb} ${heading(this.ring.value, 0)}`;
    const show = () => setText(this.speed, wanted());
    const set = async () => {
      const to = wanted();
      const { done, over_s } = await apply(this.kn * KNOT_MPS, this.ring.value);
      if (!done) return;
      this.touched = false;
      this.going = over_s === 0 ? null : { to, from_s: this.t_s, until_s: this.t_s + over_s };
    };
    this.ring = new Ring(`${name} ${verb}`, name === "Wind" ? "wind" : "current", () => {
      this.touched = true;
      show();
    });
    const change = (by: number) => () => {
      // Whole steps within the limits of the server.
      const least = Math.ceil(toKnots(least_mps) / step_kn) * step_kn;
      const most = Math.floor(toKnots(most_mps) / step_kn) * step_kn;
      this.kn = Math.min(most, Math.max(least, this.kn + by));
      this.touched = true;
      show();
    };
    this.root = h(
      "section",
      { class: "card flow", "aria-label": name },
      h("h3", {}, name),
      this.ring.root,
      this.speed,
      h(
        "div",
        { class: "row" },
        button("−", change(-step_kn), { name: `Less ${name.toLowerCase()}` }),
        button("+", change(step_kn), { name: `More ${name.toLowerCase()}` }),
        button("Set", () => void set(), { name: `Set the ${name.toLowerCase()}`, class: "take" }),
      ),
      this.now,
    );
  }

  tick(mps: number, rad: number, t_s: number): void {
    this.t_s = t_s;
    const now = `now ${fixed(toKnots(mps), 1)} kn ${this.verb} ${heading(rad, 0)}`;
    const { going } = this;
    const changes = going !== null && t_s >= going.from_s && t_s < going.until_s;
    setText(
      this.now,
      (this.touched ? "not set yet; " : "") +
        now +
        (changes ? `; goes to ${going.to} until ${clock(going.until_s)}` : ""),
    );
    if (this.touched) return;
    this.kn = Math.round(toKnots(mps) / this.step_kn) * this.step_kn;
    this.ring.follow(rad);
    setText(
      this.speed,
      `${fixed(this.kn, this.name === "Wind" ? 0 : 1)} kn ${this.verb} ${heading(rad, 0)}`,
    );
  }

  draw(mps: number, rad: number): void {
    this.ring.draw(rad, mps);
  }
}

export class Conditions implements View {
  private readonly wind: Flow;
  private readonly current: Flow;
  private readonly visibility: Visibility;
  private readonly faults: {
    vessel: number;
    fault: Fault;
    root: HTMLButtonElement;
    on: boolean;
  }[] = [];
  private readonly thrusters: {
    vessel: number;
    thruster: string;
    root: HTMLButtonElement;
    on: boolean;
  }[] = [];
  private readonly tugs: { root: HTMLButtonElement; on: boolean }[];
  private readonly anchors: {
    anchor: number;
    fault: AnchorFault;
    on: boolean;
    root: HTMLButtonElement;
  }[] = [];
  readonly planned: Planned;
  private frame: Frame | null = null;
  readonly root: HTMLElement;

  constructor(page: Page, hello: Hello) {
    const planned = new Planned(page);
    this.planned = planned;
    const over_s = () => planned.over_s();
    // What is planned for later is in the list of what is planned.
    const applied = async (event: RecordedAction, over_s: number): Promise<Applied> => {
      const isNow = planned.after_s() === 0;
      const done = await planned.happen(event);
      return { done, over_s: isNow ? over_s : 0 };
    };
    this.wind = new Flow("Wind", "from", 1, hello.limits.wind_mps, (speed_mps, from_rad) =>
      applied({ do: "wind", speed_mps, from_rad, over_s: over_s() }, over_s()),
    );
    this.current = new Flow("Current", "to", 0.1, hello.limits.current_mps, (speed_mps, to_rad) =>
      applied({ do: "current", speed_mps, to_rad, over_s: over_s() }, over_s()),
    );
    const faults = hello.vessels.map((vessel, index) => {
      const fits = FAULTS.filter(
        ({ fault }) =>
          ((fault !== "rudder_stuck" && fault !== "follow_up_lost") ||
            vessel.rudder_stop_rad !== null) &&
          (fault !== "engine_lost" || vessel.full_rps !== null) &&
          (fault !== "thrusters_lost" || vessel.thrusters.length + vessel.azimuths.length > 0),
      );
      const buttons = [...fits, ...FROZEN].map(({ fault, text }) => {
        const entry = {
          vessel: index,
          fault,
          on: false,
          root: button(
            text,
            () => void planned.happen({ do: "fault", vessel: vessel.name, fault, on: !entry.on }),
            { name: `${vessel.name}: ${text}`, "aria-pressed": "false", class: "fault" },
          ),
        };
        this.faults.push(entry);
        return entry.root;
      });
      return h(
        "div",
        { class: "fault-row" },
        h("b", {}, `${spoken(vessel.name)} · ${vessel.title}`),
        h("div", { class: "row" }, ...buttons, ...this.trips(hello, index)),
      );
    });
    this.tugs = hello.tugs.map(({ name }) => {
      const entry = {
        on: false,
        root: button(
          "Drops out",
          () => void planned.happen({ do: "tug_out", tug: name, on: !entry.on }),
          { name: `${name}: drops out`, "aria-pressed": "false", class: "fault" },
        ),
      };
      return entry;
    });
    const tugRows = hello.tugs.map(({ name }, i) =>
      h("div", { class: "fault-row" }, h("b", {}, spoken(name)), this.tugs[i]?.root),
    );
    const anchorRows = hello.anchors.map(({ name }, anchor) => {
      const buttons = ANCHOR_FAULTS.map(({ fault, text }) => {
        const entry = {
          anchor,
          fault,
          on: false,
          root: button(
            text,
            () => void planned.happen({ do: "anchor_fault", anchor: name, fault, on: !entry.on }),
            {
              name: `Anchor ${spoken(name)}: ${text}`,
              "aria-pressed": "false",
              class: "fault",
            },
          ),
        };
        this.anchors.push(entry);
        return entry.root;
      });
      return h(
        "div",
        { class: "fault-row" },
        h("b", {}, `Anchor ${spoken(name)}`),
        h("div", { class: "row" }, ...buttons),
      );
    });
    const lines = hello.lines.map(({ name }) =>
      sureButton(
        spoken(name),
        "Parts?",
        () => void planned.happen({ do: "part_line", line: name }),
        { name: `Line ${spoken(name)} parts`, class: "fault" },
      ),
    );
    const lineRow = h(
      "div",
      { class: "fault-row" },
      h("b", {}, "A line parts"),
      h("div", { class: "row" }, ...lines),
    );
    this.visibility = new Visibility((event) => planned.happen(event), over_s, hello);
    this.root = h(
      "div",
      { class: "conditions" },
      planned.when,
      h("div", { class: "flows" }, this.wind.root, this.current.root),
      h("p", { class: "note" }, "Rings are north up."),
      this.visibility.root,
      h("h3", {}, "Faults"),
      h(
        "p",
        { class: "note" },
        "Frozen instruments: the page of her pilot or master shows old values and is not told. Yours shows the truth.",
      ),
      ...faults,
      ...tugRows,
      lines.length > 0 && lineRow,
      ...anchorRows,
      planned.root,
    );
  }

  /** A button for each thruster and azimuth unit of a vessel. */
  private trips(hello: Hello, vessel: number): HTMLButtonElement[] {
    const info = hello.vessels[vessel];
    return [...(info?.thrusters ?? []), ...(info?.azimuths ?? [])].map(({ name }) => {
      const entry = {
        vessel,
        thruster: name,
        on: false,
        root: button(
          `${capital(spoken(name))} unit trips`,
          () =>
            void this.planned.happen({
              do: "thruster_out",
              vessel: info?.name ?? "",
              thruster: name,
              on: !entry.on,
            }),
          {
            name: `${info?.name}: ${capital(spoken(name))} unit trips`,
            "aria-pressed": "false",
            class: "fault",
          },
        ),
      };
      this.thrusters.push(entry);
      return entry.root;
    });
  }

  tick(frame: Frame): void {
    this.frame = frame;
    this.visibility.tick(frame);
    this.wind.tick(frame.wind.speed_mps, frame.wind.from_rad, frame.t_s);
    this.current.tick(frame.current.speed_mps, frame.current.to_rad, frame.t_s);
    for (const entry of this.faults) {
      entry.on = frame.vessels[entry.vessel]?.faults.includes(entry.fault) ?? false;
      setAttribute(entry.root, "aria-pressed", String(entry.on));
    }
    for (const entry of this.anchors) {
      entry.on = frame.anchors[entry.anchor]?.faults.includes(entry.fault) ?? false;
      setAttribute(entry.root, "aria-pressed", String(entry.on));
    }
    for (const entry of this.thrusters) {
      entry.on = frame.vessels[entry.vessel]?.tripped.includes(entry.thruster) ?? false;
      setAttribute(entry.root, "aria-pressed", String(entry.on));
    }
    this.tugs.forEach((entry, i) => {
      entry.on = frame.tugs[i]?.out ?? false;
      setAttribute(entry.root, "aria-pressed", String(entry.on));
    });
    this.planned.tick(frame);
  }

  draw(): void {
    if (!this.frame) return;
    this.wind.draw(this.frame.wind.speed_mps, this.frame.wind.from_rad);
    this.current.draw(this.frame.current.speed_mps, this.frame.current.to_rad);
  }
}
