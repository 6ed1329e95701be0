/** The exercise: its goal and how far it is reached; for the instructor the score with every deduction, and the report. */
import type { Page } from "../page";
import type { ExerciseInfo, ExerciseNow, Frame, Hello } from "../protocol";
import { button, h, setClass, setText } from "../ui/dom";
import { clock } from "../units";
import type { View } from "./view";

interface Row {
  root: HTMLElement;
  now: HTMLElement;
  points: HTMLElement;
}

/** How an exercise that is over has ended. */
export function ended({ state, ended_s }: ExerciseNow): string {
  const at = ended_s === null ? "" : ` at ${clock(ended_s)}`;
  return state === "reached"
    ? `Exercise finished: goal reached${at}.`
    : `Exercise finished: time over${at}, goal not reached.`;
}

export class Exercise implements View {
  readonly root: HTMLElement;
  private readonly state = h("p", { class: "state", role: "status" });
  private readonly held = h("p", { class: "note" });
  private readonly goal: Row[];
  private readonly score = h("output", { class: "big", "aria-label": "Score" });
  private readonly limits: Row[];
  private readonly marks: HTMLElement;
  private readonly report: HTMLButtonElement | null;

  constructor(
    page: Page,
    hello: Hello,
    private readonly of: ExerciseInfo,
  ) {
    this.goal = of.goal.map((text) => row(text, null));
    this.limits = of.limits.map(({ text, rule, fails }) =>
      row(text, fails ? `${rule}; decides` : rule),
    );
    this.report =
      hello.role.name === "instructor"
        ? button("Report", () => void page.report(), {
            name: "Report of the exercise, in a new tab",
            class: "hidden",
          })
        : null;
    this.marks = h(
      "section",
      { class: "hidden", "aria-label": "Marks" },
      h("div", { class: "card-head" }, h("h3", {}, "Score"), this.score),
      h("ul", { class: "rows", "aria-label": "Limits" }, ...this.limits.map((each) => each.root)),
      h(
        "p",
        { class: "note" },
        `Passed with the goal reached and a score of ${of.pass_mark} or more.`,
      ),
    );
    const until = of.time_limit_s === null ? "" : `, within ${clock(of.time_limit_s)}`;
    this.root = h(
      "div",
      { class: "exercise" },
      of.task === "" ? null : h("p", { class: "task" }, of.task),
      this.state,
      this.report,
      h("h3", {}, "Goal"),
      h("ul", { class: "rows", "aria-label": "Goal" }, ...this.goal.map((each) => each.root)),
      this.held,
      h("p", { class: "note" }, `All together for ${of.hold_s} s${until}.`),
      this.marks,
    );
  }

  tick({ exercise, marks }: Frame): void {
    if (!exercise) return;
    const { state, held_s, conditions } = exercise;
    const open = state === "running";
    setText(this.state, open ? "The exercise goes on." : ended(exercise));
    setClass(this.state, "ok", state === "reached");
    setClass(this.state, "alarm", state === "time_over");
    setClass(this.root, "over", !open);
    if (this.report) setClass(this.report, "hidden", open);
    this.goal.forEach((each, i) => {
      const { met, now } = conditions[i] ?? { met: false, now: "" };
      setText(each.now, now);
      setText(each.points, met ? "✓" : "–");
      setClass(each.root, "ok", met);
    });
    setText(
      this.held,
      open && held_s > 0 ? `Fulfilled for ${held_s.toFixed(0)} of ${this.of.hold_s} s.` : "",
    );
    setClass(this.marks, "hidden", !marks);
    if (!marks) return;
    const passed = marks.passed === null ? "" : marks.passed ? ", passed" : ", not passed";
    setText(this.score, `${marks.score.toFixed(0)} of 100${passed}`);
    this.limits.forEach((each, i) => {
      const limit = marks.limits[i];
      if (!limit) return;
      setText(each.now, limit.why ?? (limit.worst === null ? "" : `worst ${limit.worst}`));
      setText(each.points, limit.exceeded ? `−${limit.points.toFixed(1)}` : "0");
      setClass(each.root, "alarm", limit.exceeded);
    });
  }
}

/** A line with a text, a rule, what holds now, and a mark. */
function row(text: string, rule: string | null): Row {
  const [now, points] = [h("span", { class: "now" }), h("span", { class: "points" })];
  const root = h(
    "li",
    {},
    h(
      "span",
      { class: "what" },
      h("strong", {}, text),
      rule === null ? null : h("span", { class: "note" }, rule),
      now,
    ),
    points,
  );
  return { root, now, points };
}
