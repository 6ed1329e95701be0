/**
 * Sounds of the page, made by the browser without files. It allows them after the first touch or key; until then, and while
 * they are muted, the page says so.
 */
import { Bells, type Tone } from "./bells";
import type { Live } from "./live";
import type { Alarm, Frame, Role } from "./protocol";
import { button, setAttribute, setClass, setText } from "./ui/dom";

type Kind = "alarms" | "engine";
const KINDS: readonly Kind[] = ["alarms", "engine"];
const NAMES: Record<Kind, string> = { alarms: "Alarm sound", engine: "Engine sound" };
const KEPT = "muted sounds";
const LOUD = 0.15;
/** Time of rise and fall, so that a tone does not click [s]. */
const EDGE_S = 0.012;
/** The press that starts the audio does not mute it. */
const STARTED_MS = 700;

export class Sound {
  private readonly bells = new Bells();
  private muted = new Set<Kind>();
  private audio: AudioContext | null = null;
  private started_ms = -Infinity;
  /** In the bar: whether there is sound; a press mutes all of it, or none. */
  readonly state = button("♪", () => this.toggleAll(), { class: "sound-state" });
  /** One for each kind of sound. */
  readonly toggles: HTMLButtonElement[];

  constructor() {
    this.toggles = KINDS.map((kind) => button(NAMES[kind], () => this.toggle(kind)));
    for (const gesture of ["pointerdown", "keydown"])
      document.addEventListener(gesture, () => this.start(), { capture: true });
    this.show();
  }

  /** An observer's page is silent at first. */
  welcome(role: Role): void {
    const kept = localStorage.getItem(KEPT);
    const silent = kept === null ? (role.name === "observer" ? KINDS : []) : JSON.parse(kept);
    this.muted = new Set(KINDS.filter((kind) => (silent as Kind[]).includes(kind)));
    this.bells.forget();
    this.show();
  }

  tick(frame: Frame, live: Live, now_ms: number): void {
    const open = frame.alarms.filter(({ acknowledged }) => !acknowledged);
    const worst: Alarm["level"] | null = open.some(({ level }) => level === "alarm")
      ? "alarm"
      : open.length > 0
        ? "caution"
        : null;
    this.play("alarms", this.bells.alarm(worst, now_ms));
    const now = frame.vessels[live.conned()];
    const order = live.vessel(live.conned())?.full_rps ? (now?.shaft.order ?? null) : null;
    // Orders that are played again after a rewind are not answered.
    const byHand = now?.speed_order_mps === null && frame.tick >= frame.run.last_tick;
    this.play("engine", this.bells.engine(order, byHand, now_ms));
  }

  /** The browser allows sound from a touch or a key on. */
  private start(): void {
    if (this.audio) {
      if (this.audio.state === "suspended") void this.audio.resume();
      return;
    }
    this.audio = new AudioContext();
    this.audio.addEventListener("statechange", () => this.show());
    this.started_ms = performance.now();
    this.show();
  }

  private toggle(kind: Kind): void {
    if (!this.muted.delete(kind)) this.muted.add(kind);
    localStorage.setItem(KEPT, JSON.stringify([...this.muted]));
    this.show();
  }

  private toggleAll(): void {
    if (performance.now() - this.started_ms < STARTED_MS && this.muted.size === 0) return;
    const silent = this.muted.size < KINDS.length ? KINDS : [];
    this.muted = new Set(silent);
    localStorage.setItem(KEPT, JSON.stringify([...this.muted]));
    this.show();
  }

  private show(): void {
    const heard = KINDS.filter((kind) => !this.muted.has(kind));
    const waits = this.audio?.state !== "running";
    const word =
      heard.length === 0
        ? "muted"
        : waits
          ? "waits"
          : heard.length < KINDS.length
            ? `${heard[0] ?? ""} only`
            : "on";
    const why = word === "waits" ? "; the browser allows it after the first touch or key" : "";
    setText(this.state, `♪ ${word}`);
    setAttribute(this.state, "aria-label", `Sound ${word}${why}`);
    setAttribute(this.state, "title", `Sound ${word}${why}`);
    setAttribute(this.state, "aria-pressed", String(heard.length > 0 && !waits));
    setClass(this.state, "muted", heard.length === 0);
    KINDS.forEach((kind, i) => {
      const own = this.toggles[i];
      if (!own) return;
      setText(own, `${NAMES[kind]} ${this.muted.has(kind) ? "muted" : "on"}`);
      setAttribute(own, "aria-pressed", String(!this.muted.has(kind)));
    });
  }

  private play(kind: Kind, tones: Tone[] | null): void {
    const { audio } = this;
    if (!tones || !audio || audio.state !== "running" || this.muted.has(kind)) return;
    for (const { hz, at_s, for_s } of tones) {
      const [tone, loud] = [audio.createOscillator(), audio.createGain()];
      const from = audio.currentTime + at_s;
      tone.frequency.value = hz;
      loud.gain.setValueAtTime(0, from);
      loud.gain.linearRampToValueAtTime(LOUD, from + EDGE_S);
      loud.gain.setValueAtTime(LOUD, from + for_s - EDGE_S);
      loud.gain.linearRampToValueAtTime(0, from + for_s);
      tone.connect(loud).connect(audio.destination);
      tone.start(from);
      tone.stop(from + for_s);
    }
    // For tests, which hear nothing.
    const count = Number(this.state.dataset[kind] ?? 0) + 1;
    this.state.dataset[kind] = String(count);
  }
}
