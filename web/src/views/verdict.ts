/**
 * The verdict on the run up to the shown tick, and what it comes from. The words are those of the terminal and the report;
 * times are by the clock of the page.
 */
import type { FindingNow, Frame, Gravity, VerdictNow } from "../protocol";
import { button, h, setClass, setText } from "../ui/dom";
import { clock, spokenFinding } from "../units";
import { ended } from "./exercise";
import type { View } from "./view";

/** The style class of a gravity; none for what is well or only to be known. */
const CLASSES: Record<Gravity, "alarm" | "caution" | null> = {
  ok: null,
  note: null,
  attention: "caution",
  failed: "alarm",
};

/** Colours an element by gravity. */
export function setGravity(element: HTMLElement, gravity: Gravity): void {
  for (const level of ["alarm", "caution"] as const)
    setClass(element, level, CLASSES[gravity] === level);
  setClass(element, "well", gravity === "ok");
}

export class Verdict implements View {
  private readonly goal = h("p", { class: "verdict-goal hidden" });
  private readonly words = h("p", { class: "verdict", "aria-label": "Verdict" });
  private readonly when = h("p", { class: "note" });
  private readonly list = h("ul", { class: "rows", "aria-label": "Findings" });
  private readonly notes = h("ul", { class: "rows", "aria-label": "Notes" });
  private readonly noted = h(
    "section",
    { class: "hidden", "aria-label": "Notes on the run" },
    h("h3", {}, "Notes"),
    this.notes,
  );
  private shown = "";
  readonly root: HTMLElement;

  /** `largest`: goes to the moment of the largest fender load and saves a picture of that fender; `null` where nobody can. */
  constructor(largest: (() => void) | null = null) {
    this.root = h(
      "div",
      { class: "verdict-view" },
      this.goal,
      this.words,
      this.when,
      this.list,
      h(
        "p",
        { class: "note" },
        `The verdict is the worst finding of the run since its start.${largest ? " Go back on the timeline to see when it came." : ""}`,
      ),
      largest && button("Picture of the largest fender load", largest),
      this.noted,
    );
  }

  tick(frame: Frame): void {
    const { verdict, exercise } = frame;
    const isOver = exercise !== null && exercise.state !== "running";
    setClass(this.goal, "hidden", !isOver);
    if (isOver) setText(this.goal, ended(exercise));
    setText(this.words, verdict.text);
    setGravity(this.words, verdict.gravity);
    const rewound = frame.tick < frame.run.last_tick;
    setText(
      this.when,
      rewound
        ? `From the start to ${clock(frame.t_s)}, where the run is rewound to.`
        : `From the start to ${clock(frame.t_s)}.`,
    );
    this.find(verdict);
  }

  private find({ findings }: VerdictNow): void {
    const key = JSON.stringify(findings);
    if (key === this.shown) return;
    this.shown = key;
    const row = ({ gravity, text }: FindingNow) => {
      const item = h("li", {}, `${spokenFinding(text)}.`);
      setGravity(item, gravity);
      return item;
    };
    // What asks nothing of a pilot comes last.
    const isNote = ({ gravity }: FindingNow) => gravity === "note";
    this.list.replaceChildren(...findings.filter((each) => !isNote(each)).map(row));
    this.notes.replaceChildren(...findings.filter(isNote).map(row));
    setClass(this.noted, "hidden", !findings.some(isNote));
  }
}
