/** A slider with two pointers: the thumb is the order, the bar below it the actual value. */
import { Bar } from "./bar";
import { h, setAttribute } from "./dom";

/** The thumb's middle goes from here to here before the end. */
const HALF_THUMB_PX = 13;

export interface SliderOptions {
  label: string;
  least: number;
  most: number;
  step: number;
  /** The text of a value. */
  say(value: number): string;
  /** Called while it is dragged, and at the end. */
  order(value: number): void;
  /** Marks of the scale: value and text. */
  marks: { at: number; text: string; side?: "port" | "starboard" }[];
}

export class Slider {
  private readonly input: HTMLInputElement;
  private readonly actual: Bar;
  readonly root: HTMLElement;
  private dragged = false;

  constructor(private readonly options: SliderOptions) {
    const { label, least, most, step, marks } = options;
    this.actual = new Bar(least, most, false, HALF_THUMB_PX);
    this.input = h("input", {
      type: "range",
      min: least,
      max: most,
      step,
      "aria-label": label,
      value: 0,
    });
    const scale = h(
      "div",
      { class: "scale", "aria-hidden": "true" },
      ...marks.map(({ at, text, side }) =>
        h("span", { style: `left:${this.place(at)}%`, class: side }, text),
      ),
    );
    this.root = h(
      "div",
      { class: "slider" },
      h("div", { class: "track" }, this.actual.root, this.input),
      scale,
    );
    this.input.addEventListener("pointerdown", () => (this.dragged = true));
    for (const end of ["pointerup", "pointercancel", "blur"])
      this.input.addEventListener(end, () => (this.dragged = false));
    this.input.addEventListener("input", () => {
      const value = Number(this.input.value);
      this.options.order(value);
      setAttribute(this.input, "aria-valuetext", this.options.say(value));
    });
  }

  private place(value: number): number {
    return ((value - this.options.least) / (this.options.most - this.options.least)) * 100;
  }

  show(order: number, actual: number): void {
    this.actual.show(actual);
    if (this.dragged) return;
    const text = String(Math.round(order / this.options.step) * this.options.step);
    if (Number(this.input.value) !== Number(text)) this.input.value = text;
    setAttribute(this.input, "aria-valuetext", this.options.say(order));
  }

  enable(on: boolean): void {
    this.input.disabled = !on;
    this.actual.enable(on);
  }
}
