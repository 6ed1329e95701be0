/** Keeps new exercises in the gallery of the server. */
import type { Page } from "../page";
import type { NewExercise } from "../protocol";
import type { Keeper, Kept } from "./new_exercise";
import { isInGallery, openButton } from "./save_exercise";

export class GalleryKeeper implements Keeper {
  readonly keep_text = "Save exercise";
  private kept = "";
  private title = "";
  /** Opens what was saved last. */
  readonly after = openButton(
    () => this.page,
    () => `${this.kept}.toml`,
    () => this.title,
  );

  constructor(private readonly page: Page) {}

  /** The server decides: it refuses a name that is taken, and then the page asks. */
  async keep(name: string, exercise: NewExercise, replace: boolean): Promise<Kept> {
    if (await this.page.order({ do: "create", of: { name, exercise, replace } })) {
      this.kept = name;
      this.title = exercise.title;
      const text = `Saved as ${name}.toml. It is among the scenarios of the tab Session too.`;
      return { outcome: "kept", text };
    }
    if (isInGallery(this.page.live.hello, name))
      return {
        outcome: "taken",
        text: `There is an exercise ${name} already. Nothing was changed.`,
      };
    return { outcome: "refused", text: "Not saved: the reason is above." };
  }
}
