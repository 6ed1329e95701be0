/** A bar that shows an actual value, and an order if it has one, along a scale with zero in it. */
import { inSteps, instrument } from "../instruments/instrument";
import { h } from "./dom";

export class Bar {
  private readonly bar;
  readonly root: HTMLElement;
  private readonly step: number;

  /** `ordered`: has a mark for the order, in a band below. `margin_px`: at both ends. */
  constructor(least: number, most: number, ordered: boolean, margin_px: number) {
    this.step = (most - least) / 400;
    this.bar = instrument("obc-bar-horizontal", {
      minValue: least,
      maxValue: most,
      mainTickmarks: ordered ? [least, 0, most] : [],
      hasBar: true,
      hasScale: ordered,
      showLabels: false,
      instrumentMode: true,
      borderRadius: 4,
      barThickness: 12,
      tickThickness: 12,
      paddingLeft: margin_px,
      paddingRight: margin_px,
      autoAtSetpointDeadband: (most - least) / 100,
    });
    this.root = h("div", { class: "value-bar" }, this.bar.root);
    // The component has a width in pixels.
    new ResizeObserver(([entry]) => {
      const width = Math.floor(entry?.contentRect.width ?? 0);
      if (width > 0) this.bar.show({ width });
    }).observe(this.root);
  }

  show(actual: number, order?: number): void {
    this.bar.show({
      value: inSteps(actual, this.step),
      setpoint: order === undefined ? undefined : inSteps(order, this.step),
    });
  }

  /** In the colours of what this page commands, or not. */
  enable(on: boolean): void {
    this.bar.show({ priority: on ? "enhanced" : "regular" });
  }
}
