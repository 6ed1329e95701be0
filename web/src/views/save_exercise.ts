/** Saves the present state as an exercise: a scenario file of the gallery. */
import type { Page } from "../page";
import type { Hello } from "../protocol";
import { NAME_RULE, followTitle, isFileName } from "../file_name";
import { button, h, setClass, setText } from "../ui/dom";
import { askToEnd } from "../ui/question";

/** A hidden button that opens an exercise that was just saved. */
export const openButton = (
  page: () => Page,
  file: () => string,
  title: () => string,
): HTMLButtonElement =>
  button(
    "Open it now",
    async () => {
      if (await askToEnd(title())) void page().order({ do: "load", file: file() });
    },
    { class: "hidden take", name: "Open it now: the saved exercise" },
  );

export class SaveExercise {
  private readonly title = h("input", {
    type: "text",
    maxlength: 100,
    "aria-label": "Title of the exercise",
    placeholder: "title",
  });
  private readonly name = h("input", {
    type: "text",
    maxlength: 60,
    "aria-label": "File name of the exercise",
    placeholder: "file name",
  });
  private readonly note = h("p", { class: "note", role: "status", "aria-label": "Exercise saved" });
  private readonly replace = button("Replace it", () => void this.save(true), {
    name: "Replace the exercise",
    class: "hidden",
  });
  private readonly open = openButton(
    () => this.page,
    () => `${this.name.value.trim()}.toml`,
    () => this.title.value.trim(),
  );
  readonly root: HTMLElement;

  constructor(private readonly page: Page) {
    followTitle(this.title, this.name);
    this.name.addEventListener("input", () => {
      for (const each of [this.replace, this.open]) setClass(each, "hidden", true);
    });
    this.root = h(
      "form",
      {
        class: "save-exercise",
        onsubmit: (event: Event) => {
          event.preventDefault();
          void this.save(false);
        },
      },
      h("h3", {}, "Save the present state as an exercise"),
      h(
        "p",
        { class: "note" },
        "Ships, speeds, lines, weather, faults, orders and planned events of this moment, as a scenario to open, run and change by hand.",
      ),
      h(
        "div",
        { class: "row" },
        this.title,
        this.name,
        h("button", { type: "submit" }, "Save as exercise"),
        this.replace,
        this.open,
      ),
      this.note,
    );
  }

  /** The server decides: it refuses a name that is taken, and then the page asks. */
  private async save(replace: boolean): Promise<void> {
    const [title, name] = [this.title.value.trim(), this.name.value.trim()];
    if (title === "" || name === "") {
      setText(this.note, "Give the exercise a title and a file name.");
      return;
    }
    if (!isFileName(name)) {
      setText(this.note, `Not saved. ${NAME_RULE}`);
      return;
    }
    setText(this.note, "");
    const done = await this.page.order({ do: "save_exercise", name, title, replace });
    const isTaken = !done && isInGallery(this.page.live.hello, name);
    setClass(this.replace, "hidden", !isTaken);
    setClass(this.open, "hidden", !done);
    setText(
      this.note,
      done
        ? `Saved as ${name}.toml. It is among the scenarios below.`
        : isTaken
          ? `There is an exercise ${name} already. Nothing was changed.`
          : "Not saved: the reason is above.",
    );
  }
}

/** Whether the gallery has an exercise of a name. */
export const isInGallery = (hello: Hello | null, name: string): boolean =>
  hello?.gallery.some(({ file }) => file === `${name}.toml`) ?? false;
