/** The safety depth of the chart: draught and the clearance below the keel that the mariner asks for. A browser keeps the clearance. */
import { button, h, setAttribute, setClass, setText } from "../ui/dom";
import { fixed } from "../units";

const KEPT = "clearance";
/** Without a choice of the mariner [m]. */
const USUAL_M = 1.5;
const [LEAST_M, MOST_M, STEP_M] = [0, 20, 0.5];

export class Safety {
  /** Clearance below the keel that the mariner asks for [m]. */
  clearance_m = kept();
  private readonly value = h("output", { class: "clearance", "aria-label": "Safety contour" });
  /** The row with the choice. */
  readonly row: HTMLElement;
  /** Shows and hides the row. */
  readonly opener = button("Depths", () => this.open(), {
    name: "Depths: safety contour of the chart (H)",
    "aria-expanded": "false",
  });

  constructor(private readonly draught_m: () => number) {
    this.row = h(
      "div",
      { class: "measuring hidden", role: "group", "aria-label": "Safety contour of the chart" },
      this.value,
      button("−", () => this.change(-STEP_M), { name: "Half a metre less clearance" }),
      button("+", () => this.change(STEP_M), { name: "Half a metre more clearance" }),
    );
  }

  open(): void {
    const opens = this.row.classList.contains("hidden");
    setClass(this.row, "hidden", !opens);
    setAttribute(this.opener, "aria-expanded", String(opens));
    this.show();
  }

  private change(by_m: number): void {
    this.clearance_m = Math.min(MOST_M, Math.max(LEAST_M, this.clearance_m + by_m));
    localStorage.setItem(KEPT, String(this.clearance_m));
    this.show();
  }

  private show(): void {
    const draught_m = this.draught_m();
    setText(
      this.value,
      `Safety ${fixed(draught_m + this.clearance_m, 1)} m = draught ${fixed(draught_m, 1)} + ${fixed(this.clearance_m, 1)} clearance`,
    );
  }
}

function kept(): number {
  const given = Number(localStorage.getItem(KEPT) ?? USUAL_M);
  return given >= LEAST_M && given <= MOST_M ? given : USUAL_M;
}
