/** The timeline of a run: plays the kept frames, and goes to any of them. */
import { button, h, setAttribute, setText } from "../src/ui/dom";
import { clock, fixed } from "../src/units";

/** Time in which a run is played, whatever its length [ms]. */
const PLAYS_MS = 20_000;

export class Timeline {
  private readonly range = h("input", {
    type: "range",
    min: 0,
    max: 0,
    step: 1,
    "aria-label": "Time of the run",
  });
  private readonly playButton = button("▶", () => this.toggle(), { name: "Play (Space)" });
  private readonly peakButton = button("Peak", () => this.toPeak(), {
    name: "Peak: go to the largest contact force",
  });
  private readonly label = h("output", { class: "at" });
  private playing: { from_ms: number; index: number } | null = null;
  /** The last frame is followed while the run goes on. */
  private follows = true;
  readonly root = h(
    "footer",
    { class: "controls timeline-bar", "aria-label": "Timeline" },
    h("div", { class: "row" }, this.playButton, this.peakButton, this.range, this.label),
  );

  /** `go` shows the frame of an index; `peak` finds that of the largest contact force. */
  constructor(
    private readonly go: (index: number) => void,
    private readonly peak: () => number,
  ) {
    this.range.addEventListener("input", () => {
      this.pause();
      this.at(Number(this.range.value));
    });
  }

  /** A new run: follows it. */
  begin(): void {
    this.pause();
    this.follows = true;
    this.range.max = this.range.value = "0";
  }

  /** A frame was added. */
  added(count: number): void {
    this.range.max = String(count - 1);
    if (this.follows) this.at(count - 1);
  }

  show(t_s: number, duration_s: number): void {
    const digits = duration_s < 120 ? 1 : 0;
    setText(
      this.label,
      duration_s < 600
        ? `${fixed(t_s, digits)} of ${fixed(duration_s, digits)} s`
        : `${clock(t_s)} of ${clock(duration_s)}`,
    );
  }

  private toPeak(): void {
    this.pause();
    this.at(this.peak());
  }

  toggle(): void {
    if (this.playing) {
      this.pause();
      return;
    }
    const last = Number(this.range.max);
    const index = Number(this.range.value) >= last ? 0 : Number(this.range.value);
    this.playing = { from_ms: performance.now(), index };
    this.mark("❚❚", "Pause (Space)");
  }

  pause(): void {
    this.playing = null;
    this.mark("▶", "Play (Space)");
  }

  /** Goes on while playing. */
  draw(now_ms: number): void {
    if (!this.playing) return;
    const last = Number(this.range.max);
    const passed = ((now_ms - this.playing.from_ms) / PLAYS_MS) * last;
    const index = Math.min(last, Math.floor(this.playing.index + passed));
    if (index !== Number(this.range.value)) this.at(index);
    if (index >= last) this.pause();
  }

  private at(index: number): void {
    this.follows = index >= Number(this.range.max);
    this.range.value = String(index);
    this.go(index);
  }

  private mark(text: string, name: string): void {
    setText(this.playButton, text);
    setAttribute(this.playButton, "aria-label", name);
    this.playButton.title = name;
  }
}
