/** The instructor's control of time: pause, step, pace, the timeline with its branches. */
import type { Page } from "../page";
import type { Frame, Hello, RunState } from "../protocol";
import { button, choices, h, setAttribute, setClass, setText } from "../ui/dom";
import { clock } from "../units";
import type { Group, KeyAction } from "./group";

/** The server's limit (characters). */
const LONGEST_NOTE = 300;
const PACES = [0.25, 0.5, 1, 2, 4, 8];
const PACE_WORDS: Record<number, string> = { 0.25: "¼", 0.5: "½" };

export class Run implements Group {
  readonly name = "Time";
  readonly root: HTMLElement;
  readonly keys: KeyAction[];
  private readonly pauseButton = button("Pause", () => this.pause(), {
    name: "Pause (K)",
    class: "wide-button",
  });
  private readonly pace;
  private readonly timeline = h("input", {
    type: "range",
    min: 0,
    max: 1,
    step: 1,
    value: 0,
    "aria-label": "Timeline",
  });
  private readonly now = h("output", { class: "big", "aria-label": "Simulated time" });
  private readonly end = h("span", { class: "ordered" });
  private readonly branchButton = button("Go on from here", () => this.branch(), {
    name: "Go on from here as a new branch",
  });
  private readonly lanes = h("div", { class: "lanes", role: "group", "aria-label": "Branches" });
  private readonly late = h("p", { class: "note" });
  private readonly note = h("input", {
    type: "text",
    "aria-label": "Note for the debriefing",
    placeholder: "note for the debriefing",
    maxlength: LONGEST_NOTE,
  });
  private run: RunState | null = null;
  private tickNow = 0;
  private step_s = 0.1;
  private shownLanes = "";
  private dragging = false;

  constructor(
    private readonly page: Page,
    hello: Hello,
  ) {
    const [least, most] = hello.limits.pace;
    this.pace = choices(
      "Pace",
      PACES.filter((p) => p >= least && p <= most).map((p) => ({
        value: p,
        label: `${PACE_WORDS[p] ?? p}×`,
        name: `Pace ${PACE_WORDS[p] ?? p}`,
      })),
      (pace) => void page.order({ do: "pace", pace }),
    );
    const jump = (seconds: number) => () =>
      this.rewind(this.tickNow + Math.round(seconds / this.step_s));
    this.timeline.addEventListener("input", () => {
      this.page.drag("timeline", { do: "rewind", tick: Number(this.timeline.value) });
      this.page.did("rewind");
    });
    this.timeline.addEventListener("pointerdown", () => (this.dragging = true));
    for (const end of ["pointerup", "pointercancel", "blur"])
      this.timeline.addEventListener(end, () => (this.dragging = false));
    this.root = h(
      "div",
      { class: "group run", role: "group", "aria-label": "Time" },
      h(
        "section",
        { class: "card", "aria-label": "Run" },
        h("div", { class: "card-head" }, h("h3", {}, "Run"), this.now, this.end),
        h(
          "div",
          { class: "row" },
          this.pauseButton,
          button("Step", () => void page.order({ do: "single_step" }), { name: "Single step (.)" }),
        ),
        this.pace.root,
        h(
          "form",
          {
            class: "row note-form",
            onsubmit: (event) => {
              event.preventDefault();
              void this.drop(this.note.value.trim());
            },
          },
          this.note,
          h("button", { type: "submit", title: "Drop the note, or a mark (N)" }, "Note"),
          button("Report", () => void this.page.report(), {
            name: "Report of the session up to now, in a new tab",
          }),
        ),
        this.late,
      ),
      h(
        "section",
        { class: "card timeline", "aria-label": "Timeline and branches" },
        h("div", { class: "card-head" }, h("h3", {}, "Timeline")),
        this.timeline,
        h(
          "div",
          { class: "row" },
          button("|◀ Start", () => this.rewind(0), { name: "Rewind to the start" }),
          button("−1 min", jump(-60), { name: "Back one minute, −1 min" }),
          button("−10 s", jump(-10), { name: "Back ten seconds, −10 s" }),
          button("+10 s", jump(10), { name: "On ten seconds, +10 s" }),
          button("End ▶|", () => this.rewind(this.run?.last_tick ?? 0), {
            name: "To the end of the branch",
          }),
          this.branchButton,
        ),
        this.lanes,
      ),
    );
    this.keys = [
      { key: "k", text: "Pause or go on", run: () => this.pause() },
      { key: "n", text: "Mark this moment for the debriefing", run: () => void this.drop("") },
      { key: ".", text: "Single step", run: () => void page.order({ do: "single_step" }) },
    ];
  }

  private pause(): void {
    void this.page.order({ do: this.run?.paused ? "resume" : "pause" });
  }

  /** Drops a note; without a text, a mark. */
  private async drop(text: string): Promise<void> {
    const done = await this.page.order(text === "" ? { do: "note" } : { do: "note", text });
    if (!done) return;
    if (text === "") this.page.say("Marked for the debriefing.");
    else if (this.note.value.trim() === text) this.note.value = "";
  }

  private rewind(tick: number): void {
    this.page.did("rewind");
    void this.page.order({
      do: "rewind",
      tick: Math.min(this.run?.last_tick ?? 0, Math.max(0, tick)),
    });
  }

  private branch(): void {
    void this.page.order({ do: "branch" });
  }

  tick(frame: Frame, hello: Hello): void {
    const { run } = frame;
    this.run = run;
    this.tickNow = frame.tick;
    this.step_s = hello.step_s;
    const rewound = frame.tick < run.last_tick;
    setText(this.pauseButton, run.paused ? "▶ Resume" : "❚❚ Pause");
    setAttribute(this.pauseButton, "aria-label", run.paused ? "Resume (K)" : "Pause (K)");
    setClass(this.pauseButton, "go", run.paused);
    this.pace.show(run.pace);
    setText(this.now, clock(frame.t_s));
    setText(this.end, `of ${clock(run.last_tick * hello.step_s)}${rewound ? " · rewound" : ""}`);
    setText(
      this.late,
      `${run.clients} connected · ${run.late_ticks} late ticks${run.late_ticks > 0 ? `, latest ${run.latest_ms.toFixed(0)} ms` : ""}`,
    );
    if (Number(this.timeline.max) !== run.last_tick)
      this.timeline.max = String(Math.max(1, run.last_tick));
    if (!this.dragging) this.timeline.value = String(frame.tick);
    setAttribute(this.timeline, "aria-valuetext", clock(frame.t_s));
    this.branchButton.disabled = !rewound;
    this.showLanes(run, hello.step_s);
  }

  private showLanes(run: RunState, step_s: number): void {
    const end = Math.max(1, ...run.branches.map((b) => b.ends_tick));
    // The end moves with every tick: redraw once a second.
    const key = JSON.stringify([
      run.branch,
      run.branches.map((b) => [b.id, b.from_tick, Math.floor(b.ends_tick * step_s)]),
    ]);
    if (key === this.shownLanes) return;
    this.shownLanes = key;
    this.lanes.replaceChildren(
      ...run.branches.map((branch) => {
        const [from, till] = [(branch.from_tick / end) * 100, (branch.ends_tick / end) * 100];
        const text = branch.parent === null ? "First run" : `Branch ${branch.id}`;
        const lane = button("", () => void this.page.order({ do: "show_branch", id: branch.id }), {
          class: "lane",
          "aria-pressed": String(branch.id === run.branch),
        });
        lane.append(
          h(
            "span",
            { class: "lane-name" },
            `${text} · ${clock(branch.from_tick * step_s)}–${clock(branch.ends_tick * step_s)}`,
          ),
          h("span", {
            class: "lane-bar",
            style: `left:${from}%;width:${Math.max(0.5, till - from)}%`,
          }),
        );
        return lane;
      }),
    );
  }

  claims(): void {}
}
