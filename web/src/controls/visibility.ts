/** The instructor's choice of how far people see. */
import type { Frame, Hello, RecordedAction } from "../protocol";
import { button, h, setAttribute, setText } from "../ui/dom";

/** Distances to choose from [m]: from thick fog to haze. */
const DISTANCES_M = [100, 200, 500, 1000, 2000, 5000];

export const visibilityWords = (distance_m: number | null): string => {
  if (distance_m === null) return "clear";
  // While it changes it is not round.
  const round = distance_m < 1000 ? 10 : 100;
  const shown = Math.round(distance_m / round) * round;
  return shown < 1000 ? `${shown} m` : `${shown / 1000} km`;
};

export class Visibility {
  private readonly now = h("p", { class: "note" });
  private readonly buttons: { distance_m: number | null; root: HTMLButtonElement }[];
  readonly root: HTMLElement;

  /** `happen` gives a command, at once or later; `over_s` is the time over which it changes. */
  constructor(
    happen: (event: RecordedAction) => Promise<boolean>,
    over_s: () => number,
    { limits }: Hello,
  ) {
    const [least, most] = limits.visibility_m;
    const distances = DISTANCES_M.filter((m) => m >= least && m <= most);
    this.buttons = [...distances, null].map((distance_m) => ({
      distance_m,
      root: button(
        visibilityWords(distance_m),
        () => void happen({ do: "visibility", distance_m, over_s: over_s() }),
        {
          name: `Visibility ${visibilityWords(distance_m)}`,
          "aria-pressed": "false",
        },
      ),
    }));
    this.root = h(
      "section",
      { class: "visibility", "aria-label": "Visibility" },
      h("h3", {}, "Visibility"),
      h("div", { class: "row" }, ...this.buttons.map(({ root }) => root)),
      this.now,
    );
  }

  tick({ visibility_m }: Frame): void {
    setText(
      this.now,
      visibility_m === null
        ? "Clear: everybody sees everything."
        : `Pilot and tug masters do not see ships beyond ${visibilityWords(visibility_m)}.`,
    );
    for (const { distance_m, root } of this.buttons)
      setAttribute(root, "aria-pressed", String(distance_m === visibility_m));
  }
}
