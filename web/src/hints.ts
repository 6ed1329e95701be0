/** Hints for new users: one at a time, at the control that it is about, until that control is used. */
import type { Role } from "./protocol";
import { button, h, setText } from "./ui/dom";

interface Hint {
  /** The action that ends it; controls report actions by `did`. */
  until: string;
  /** Where it points: the first of these that is visible. */
  at: string[];
  text: string;
  /** It is about the whole page: in the corner below that element, without a tip. */
  corner?: boolean;
}

const CLAIM: Hint = {
  until: "claim",
  at: [".take:not(.hidden)"],
  text: "Start here: until you take her, this page only watches.",
};
const HINTS: Record<Role["name"], Hint[]> = {
  pilot: [
    CLAIM,
    {
      until: "rudder",
      at: [".rudder .slider", '[data-group="Helm"]'],
      text: "Steer: drag the knob or press a number; the bar below the knob is the rudder now.",
    },
    {
      until: "engine",
      at: [".telegraph", '[data-group="Helm"]'],
      text: "The engine telegraph: upper row ahead, lower row astern.",
    },
    {
      until: "tug",
      at: [".tugs .tug", '[data-group="Tugs"]'],
      text: "Tell a tug to push, stop or pull, and how hard in per cent.",
    },
    {
      until: "tab",
      at: ['[role="tab"][aria-label="Docking"]'],
      text: "The docking board has distance and speed at bow and stern; amber is near the speed limit, red is too fast.",
    },
  ],
  tugmaster: [
    CLAIM,
    {
      until: "tug",
      at: [".tugmaster .ring"],
      text: "Drag the ring for the direction, the slider for the power.",
    },
  ],
  instructor: [
    {
      until: "rewind",
      at: [".timeline input"],
      text: "Drag back in time; “Go on from here” then starts a new branch, and nothing is lost.",
    },
    {
      until: "tab",
      at: ['[role="tab"][aria-label="Session"]'],
      text: "Links for the others, scenarios, weather and faults are in these tabs.",
    },
  ],
  observer: [
    {
      until: "tab",
      at: ['[role="tab"][aria-label="Docking"]'],
      text: "You watch. Choose what to see here; drag and pinch the plan.",
    },
  ],
};

/** The first sentence of an exercise's text, and where the rest is: a hint must not cover the plan. */
export function short(briefing: string): string {
  const first = /^.*?[.!?](?=\s|$)/s.exec(briefing)?.[0] ?? briefing;
  return first.length < briefing.trim().length ? `${first} Press “?” for all of the task.` : first;
}

export class Hints {
  private readonly text = h("p");
  private readonly bubble: HTMLElement;
  private steps: Hint[] = [];
  private key = "";
  private briefing: Hint[] = [];

  constructor() {
    this.bubble = h(
      "div",
      { class: "hint hidden", role: "status", "aria-label": "Hint" },
      this.text,
      h(
        "div",
        { class: "row" },
        button("Next hint", () => this.next()),
        button("No hints", () => this.stop()),
      ),
    );
    document.body.append(this.bubble);
    setInterval(() => this.place(), 200);
  }

  /**
   * Starts the hints of a role. `fresh`: the page did not show this exercise before. Its text is shown, but not again to
   * somebody who has read it and loads the page again.
   */
  start(role: Role["name"], briefing: string, fresh: boolean): void {
    const key = `hints seen ${role}`;
    if (this.key === key && !fresh) return;
    this.key = key;
    this.briefing =
      briefing === ""
        ? []
        : [{ until: "briefing", at: [".readout"], text: short(briefing), corner: true }];
    const isRead = sessionStorage.getItem("briefing read") === short(briefing);
    this.steps = [
      ...(isRead ? [] : this.briefing),
      ...(localStorage.getItem(key) === null ? HINTS[role] : []),
    ];
    this.place();
  }

  again(role: Role["name"]): void {
    this.steps = [...this.briefing, ...HINTS[role]];
    this.place();
  }

  /** Keeps over a reload that the text of the exercise was read. */
  private read(): void {
    sessionStorage.setItem("briefing read", this.briefing[0]?.text ?? "");
  }

  did(what: string): void {
    if (what === "briefing") this.read();
    this.steps = this.steps.filter((step) => step.until !== what);
    if (this.steps.length === 0 && this.key !== "") localStorage.setItem(this.key, "yes");
    this.place();
  }

  private next(): void {
    const first = this.steps[0];
    if (first) this.did(first.until);
  }

  private stop(): void {
    this.steps = [];
    this.read();
    localStorage.setItem(this.key, "yes");
    this.place();
  }

  private place(): void {
    const step = this.steps[0];
    const anchor = step?.at
      .flatMap((selector) => [...document.querySelectorAll<HTMLElement>(selector)])
      .find((each) => each.offsetParent !== null && !each.classList.contains("hidden"));
    // No hint to take the helm for a user who has it already.
    if (step && !anchor && step.until === "claim") {
      const taken = document.querySelector(".claim .release:not(.hidden)");
      if (taken) this.did("claim");
    }
    const shown =
      step !== undefined && anchor !== undefined && !document.querySelector("dialog[open]");
    this.bubble.classList.toggle("hidden", !shown);
    if (!shown) return;
    setText(this.text, step.text);
    const [at, own] = [anchor.getBoundingClientRect(), this.bubble.getBoundingClientRect()];
    const above = !step.corner && at.top - own.height - 14 > 4;
    this.bubble.classList.toggle("corner", step.corner ?? false);
    const left = Math.min(
      innerWidth - own.width - 8,
      Math.max(8, step.corner ? at.left + 8 : at.left + at.width / 2 - own.width / 2),
    );
    this.bubble.style.left = `${left}px`;
    this.bubble.style.top = `${above ? at.top - own.height - 14 : at.bottom + 14}px`;
    this.bubble.style.setProperty(
      "--tip",
      `${Math.min(own.width - 24, Math.max(24, at.left + at.width / 2 - left))}px`,
    );
    this.bubble.classList.toggle("below", !above);
  }
}
