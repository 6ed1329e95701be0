/** The help that `?` shows: the page's keys, and how to use it without them. */
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
          "A control has two marks: the knob or the pressed button is the order, the bar is what the machine does now.",
        ),
        h(
          "li",
          {},
          "The plan: drag to move, pinch or turn the wheel to zoom. Magenta is the predicted path of the ship if nothing changes, with her hull at every minute.",
        ),
        h(
          "li",
          {},
          "View: drag to look around. While the view or one of the buttons of the view has the focus, the keys 1 to 8 choose the camera, M shows the marks, + and − change the angle of view, and Home looks ahead. A click on the controls gives the keys back to the ship. Marks are figures, the loads of fenders, lines and tugs, and in orange the predicted path on the water, with the hull of the ship at every minute.",
        ),
        h(
          "li",
          {},
          "Measure: scale, range rings, a bearing line whose knob you drag, the position under the pointer, and bearing and distance between two points that you touch.",
        ),
        h(
          "li",
          {},
          "Purple arrows are forces of fenders and tugs; a filled dot marks a contact that sticks, a hollow one a contact that slips. Fenders and lines change from green over amber to red at their rating.",
        ),
        h(
          "li",
          {},
          "Docking: the colours follow the speed limit at the foot of the board, which you can change: amber above two thirds of the limit, red above the limit. Farther off the limit is higher: she still has room to slow down. The board has the speeds of the ends of her flat side towards the berth; the plan has the sideways speeds at bow and stern.",
        ),
        h(
          "li",
          {},
          "Tugs: square, fwd and aft set the direction in which a tug pulls: square to the side, or towards bow or stern. A tug with a line takes up its slack first.",
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

  /** The text of the exercise. */
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
