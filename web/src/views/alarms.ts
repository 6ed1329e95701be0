/** Alarms: what stands, whether it was acknowledged, and what happened before; sound only where asked for. */
import type { Alarm, Frame } from "../protocol";
import { button, h, setAttribute, setClass, setText } from "../ui/dom";
import { clock, spoken } from "../units";
import type { View } from "./view";

const KEPT_EVENTS = 200;
const BEEP_EVERY_MS = 1500;

export class Alarms implements View {
  private readonly list = h("ul", { class: "rows", "aria-label": "Alarms" });
  private readonly log = h("ol", { class: "log", "aria-label": "Events" });
  private readonly none = h("p", { class: "nothing" }, "No alarms.");
  private readonly soundButton: HTMLButtonElement;
  private readonly ackAll = button("Acknowledge all", () => this.acknowledge(null));
  private readonly standing = new Map<string, { row: HTMLElement; text: HTMLElement; ack: HTMLButtonElement; since: number; alarm: Alarm; acknowledged: boolean }>();
  private audio: AudioContext | null = null;
  private beeped_ms = 0;
  readonly root: HTMLElement;

  constructor(private readonly changed: (open: number, worst: Alarm["level"] | null) => void) {
    this.soundButton = button("Sound off", () => this.toggleSound(), { "aria-pressed": "false" });
    this.root = h("div", { class: "alarms" }, h("div", { class: "alarm-tools" }, this.ackAll, this.soundButton), this.none, this.list, h("h3", {}, "Events and past alarms"), this.log);
  }

  tick(frame: Frame): void {
    const now = new Set(frame.alarms.map((a) => a.key));
    for (const [key, entry] of this.standing) {
      if (now.has(key)) continue;
      entry.row.remove();
      this.standing.delete(key);
    }
    for (const alarm of frame.alarms) this.stand(alarm, frame.t_s);
    for (const event of frame.events) this.note(event.t_s, event.text);
    setClass(this.none, "hidden", this.standing.size > 0);
    const open = [...this.standing.values()].filter((entry) => !entry.acknowledged);
    this.ackAll.disabled = open.length === 0;
    const worst = open.some((e) => e.alarm.level === "alarm") ? "alarm" : open.length > 0 ? "caution" : null;
    this.changed(open.length, worst);
    this.beep(worst);
  }

  private note(t_s: number, text: string, level = ""): void {
    this.log.prepend(h("li", { class: level }, h("time", {}, clock(t_s)), ` ${spoken(text)}`));
    while (this.log.children.length > KEPT_EVENTS) this.log.lastChild?.remove();
  }

  private stand(alarm: Alarm, t_s: number): void {
    const there = this.standing.get(alarm.key);
    if (there) {
      // One that grows worse wants to be acknowledged again.
      if (there.alarm.level === "caution" && alarm.level === "alarm") {
        this.mark(there, false);
        this.note(t_s, `ALARM: ${alarm.text}`, "alarm");
      }
      there.alarm = alarm;
      setText(there.text, alarm.text);
      setClass(there.row, "alarm", alarm.level === "alarm");
      setClass(there.row, "caution", alarm.level === "caution");
      return;
    }
    const text = h("span", { class: "alarm-text" }, alarm.text);
    const ack = button("Ack", () => this.acknowledge(alarm.key), { name: `Acknowledge ${alarm.text}` });
    const row = h("li", { class: `open ${alarm.level}` }, h("time", {}, clock(t_s)), text, ack);
    this.standing.set(alarm.key, { row, text, ack, since: t_s, alarm, acknowledged: false });
    this.list.prepend(row);
    this.note(t_s, `${alarm.level === "alarm" ? "ALARM" : "Caution"}: ${alarm.text}`, alarm.level);
  }

  private mark(entry: { row: HTMLElement; ack: HTMLButtonElement; acknowledged: boolean }, acknowledged: boolean): void {
    entry.acknowledged = acknowledged;
    entry.ack.disabled = acknowledged;
    setText(entry.ack, acknowledged ? "✓" : "Ack");
    setClass(entry.row, "open", !acknowledged);
  }

  acknowledge(key: string | null): void {
    for (const [each, entry] of this.standing) if (key === null || key === each) this.mark(entry, true);
  }

  private toggleSound(): void {
    const on = this.audio === null;
    if (on) this.audio = new AudioContext();
    else {
      void this.audio?.close();
      this.audio = null;
    }
    setText(this.soundButton, on ? "Sound on" : "Sound off");
    setAttribute(this.soundButton, "aria-pressed", String(on));
  }

  private beep(worst: Alarm["level"] | null): void {
    const now = performance.now();
    if (!this.audio || worst === null || now - this.beeped_ms < BEEP_EVERY_MS) return;
    this.beeped_ms = now;
    const [tone, loud] = [this.audio.createOscillator(), this.audio.createGain()];
    tone.frequency.value = worst === "alarm" ? 880 : 440;
    loud.gain.value = 0.15;
    tone.connect(loud).connect(this.audio.destination);
    tone.start();
    tone.stop(this.audio.currentTime + 0.25);
  }
}
