/**
 * The server's alarms: active ones, those that wait to be acknowledged, and past events.
 */
import { type Instrument, instrument } from "../instruments/instrument";
import type { Page } from "../page";
import type { Alarm, Frame, Hello, Role, Then } from "../protocol";
import { button, h, setAttribute, setClass, setText } from "../ui/dom";
import { clock, spoken } from "../units";
import type { View } from "./view";

const KEPT_EVENTS = 200;
/** Events among which one that is there already is looked for. */
const LATEST_EVENTS = 20;

interface Row {
  row: HTMLElement;
  icon: Instrument<"obc-alert-icon">;
  time: HTMLElement;
  text: HTMLElement;
  ack: HTMLButtonElement;
  alarm: Alarm;
}

export class Alarms implements View {
  private readonly list = h("ul", { class: "rows", "aria-label": "Alarms" });
  private readonly log = h("ol", { class: "log", "aria-label": "Events" });
  private readonly none = h("p", { class: "nothing" }, "No alarms.");
  private readonly ackAll = button("Acknowledge all", () => this.acknowledge(null));
  private readonly standing = new Map<string, Row>();
  private role: Role = { name: "observer" };
  readonly root: HTMLElement;

  constructor(
    private readonly page: Page,
    private readonly changed: (open: number, worst: Alarm["level"] | null) => void,
    soundButtons: HTMLElement[],
  ) {
    this.root = h(
      "div",
      { class: "alarms" },
      h("div", { class: "alarm-tools" }, this.ackAll, ...soundButtons),
      this.none,
      this.list,
      h("h3", {}, "Events and past alarms"),
      this.log,
    );
  }

  tick(frame: Frame, hello: Hello): void {
    const now = new Set(frame.alarms.map((a) => a.key));
    for (const [key, entry] of this.standing) {
      if (now.has(key)) continue;
      entry.row.remove();
      this.standing.delete(key);
    }
    this.role = hello.role;
    for (const alarm of frame.alarms) this.stand(alarm);
    // In the server's order, so that a page that was loaded again shows the same as the others.
    frame.alarms.forEach(({ key }, place) => {
      const row = this.standing.get(key)?.row;
      const there = this.list.children[place];
      if (row && row !== there) this.list.insertBefore(row, there ?? null);
    });
    for (const event of frame.events) this.note(event.t_s, event.text);
    setClass(this.none, "hidden", this.standing.size > 0);
    const open = frame.alarms.filter((alarm) => !alarm.acknowledged);
    this.ackAll.disabled = !open.some((alarm) => this.mayAcknowledge(alarm));
    const worst = open.some((alarm) => alarm.level === "alarm")
      ? "alarm"
      : open.length > 0
        ? "caution"
        : null;
    this.changed(open.length, worst);
  }

  /** Shows the events that the server kept from before the page was opened. */
  restore(events: Then[]): void {
    this.log.replaceChildren();
    for (const { t_s, text, level } of events) this.note(t_s, text, level ?? "");
  }

  private note(t_s: number, text: string, level = ""): void {
    const line = h("li", { class: level }, h("time", {}, clock(t_s)), ` ${spoken(text)}`);
    // A frame on its way may have what the server's list has already.
    const latest = [...this.log.children].slice(0, LATEST_EVENTS);
    if (latest.some((other) => other.textContent === line.textContent)) return;
    this.log.prepend(line);
    while (this.log.children.length > KEPT_EVENTS) this.log.lastChild?.remove();
  }

  /** The server's rule: pilot and instructor any, a tugmaster those of the own tug, an observer none. */
  private mayAcknowledge(alarm: Alarm): boolean {
    if (this.role.name === "tugmaster") return ` ${alarm.key} `.includes(` ${this.role.tug} `);
    return this.role.name !== "observer";
  }

  private stand(alarm: Alarm): void {
    let there = this.standing.get(alarm.key);
    if (!there) {
      const [time, text] = [h("time", {}), h("span", { class: "alarm-text" })];
      const ack = button("Ack", () => this.acknowledge(alarm.key));
      const icon = instrument("obc-alert-icon");
      there = {
        row: h("li", {}, icon.root, time, text, ack),
        icon,
        time,
        text,
        ack,
        alarm,
      };
      this.standing.set(alarm.key, there);
      this.noteAlarm(alarm);
    } else if (there.alarm.level === "caution" && alarm.level === "alarm") this.noteAlarm(alarm);
    there.alarm = alarm;
    // What we call a caution asks to be acknowledged: OpenBridge and IEC 62923 call it a warning.
    there.icon.show({
      type: alarm.level === "alarm" ? "alarm" : "warning",
      active: alarm.stands,
      acknowledged: alarm.acknowledged,
    });
    setText(there.time, clock(alarm.since_s));
    setText(there.text, alarm.stands ? alarm.text : `${alarm.text} (over; not acknowledged)`);
    for (const level of ["alarm", "caution"] as const)
      setClass(there.row, level, alarm.level === level);
    setClass(there.row, "open", !alarm.acknowledged);
    setClass(there.row, "over", !alarm.stands);
    there.ack.disabled = alarm.acknowledged || !this.mayAcknowledge(alarm);
    setText(there.ack, alarm.acknowledged ? "✓" : "Ack");
    setAttribute(there.ack, "aria-label", `Acknowledge ${alarm.text}, Ack`);
  }

  private noteAlarm(alarm: Alarm): void {
    this.note(
      alarm.since_s,
      `${alarm.level === "alarm" ? "ALARM" : "Caution"}: ${alarm.text}`,
      alarm.level,
    );
  }

  /** Acknowledges one alarm, or all of them. */
  private acknowledge(key: string | null): void {
    for (const [each, { alarm }] of this.standing) {
      const asked = key === null ? this.mayAcknowledge(alarm) : key === each;
      if (asked && !alarm.acknowledged) void this.page.order({ do: "acknowledge", key: each });
    }
  }
}
