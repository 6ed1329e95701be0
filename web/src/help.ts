/** What `?` shows: the keys of this page, and how to use it without them. */
import type { KeyAction } from "./controls/group";
import { button, h, setText } from "./ui/dom";

const NAMES: Record<string, string> = {
  ArrowLeft: "←",
  ArrowRight: "→",
  ArrowUp: "↑",
  ArrowDown: "↓",
  Escape: "Esc",
};

export class Help {
  private readonly keys = h("dl", { class: "keys" });
  private readonly briefing = h("p", { class: "briefing" });
  readonly root: HTMLDialogElement;

  constructor(again: () => void) {
    this.root = h(
      "dialog",
      { class: "help", "aria-label": "Help" },
      h(
        "div",
        { class: "help-head" },
        h("h2", {}, "How to use this page"),
        button("Close", () => this.root.close()),
      ),
      this.briefing,
      h(
        "ul",
        {},
        h(
          "li",
          {},
          "Take the helm first: the button is at the controls. Two pages cannot hold one helm.",
        ),
        h(
          "li",
          {},
          "A control has two marks: the knob or the pressed button is what is ordered, the bar is what the machine does now.",
        ),
        h(
          "li",
          {},
          "The plan: drag to move, pinch or turn the wheel to zoom. Magenta is where the ship goes if nothing changes, her hull at every minute.",
        ),
        h(
          "li",
          {},
          "Purple arrows are forces of fenders and tugs; a filled dot sticks, a hollow one slips. Fenders and lines go from green over amber to red at what they are rated for.",
        ),
        h(
          "li",
          {},
          "Docking: the colours follow the limit at the foot of the board, which is yours to set; further off it is more, by what she can still lose. Its speeds are those of the ends of her flat side towards the berth; on the plan those of stem and stern, sideways.",
        ),
        h(
          "li",
          {},
          "Tugs: ⊥, fwd or aft is which way a tug leads when she pulls, square to the side or towards bow or stern; who has a line first takes up its slack.",
        ),
      ),
      h("h3", {}, "Keys"),
      this.keys,
      button("Show the hints again", () => {
        this.root.close();
        again();
      }),
    );
    this.root.addEventListener("click", (event) => {
      if (event.target === this.root) this.root.close();
    });
  }

  /** What the exercise is about. */
  brief(text: string): void {
    setText(this.briefing, text);
  }

  open(keys: KeyAction[]): void {
    this.keys.replaceChildren(
      ...keys.flatMap(({ key, text }) => [
        h("dt", {}, h("kbd", {}, NAMES[key] ?? key.toUpperCase())),
        h("dd", {}, text),
      ]),
    );
    this.root.showModal();
  }
}
