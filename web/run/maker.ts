/** Makes new exercises in the page: they open as its scenario, and can be saved as files. */
import type { LibraryInfo, NewExercise } from "../src/protocol";
import { button, h } from "../src/ui/dom";
import { type Keeper, type Kept, NewExerciseView } from "../src/views/new_exercise";
import type { View } from "../src/views/view";
import { EXAMPLES, titleOf } from "./examples";
import type { Runner } from "./runner";

/** Takes the text of a new exercise, with the files that it names. */
export type Take = (file: string, text: string, files: Record<string, string>) => void;

/** A name that is safe as one of a file everywhere, as the server wants it. */
const NAME = /^[A-Za-z0-9_-]{1,60}$/;

export class Maker implements Keeper, View {
  readonly keep_text = "Make exercise";
  /** Saves what was made last. */
  readonly after = button("Save file", () => this.save(), {
    class: "hidden take",
    name: "Save the exercise as a file",
  });
  readonly root = h("div", {}, h("p", { class: "nothing" }, "The libraries are being read."));
  private view: NewExerciseView | null = null;
  private asked = false;
  private made = { file: "", text: "" };

  constructor(
    private readonly runner: Runner,
    private readonly take: Take,
  ) {}

  tick(): void {}

  /** Reads what can be chosen, once. */
  async open(): Promise<void> {
    if (this.asked) return;
    this.asked = true;
    const answer = await this.runner.choices(EXAMPLES.map(job));
    if (answer.type !== "choices") {
      this.asked = false;
      return;
    }
    const library = JSON.parse(answer.library) as LibraryInfo;
    this.view = new NewExerciseView(this, library);
    this.view.offer(
      EXAMPLES.map((example, i) => ({
        file: example.file,
        title: titleOf(example),
        berth: answer.berths[i] ?? null,
      })),
    );
    this.root.replaceChildren(this.view.root);
  }

  async keep(name: string, exercise: NewExercise): Promise<Kept> {
    if (!NAME.test(name))
      return { outcome: "refused", text: "A name has 1 to 60 letters, digits, - and _." };
    const berth = EXAMPLES.find(({ file }) => file === exercise.berth_of) ?? null;
    const answer = await this.runner.make(exercise, berth ? job(berth) : null);
    if (answer.type !== "made") {
      const why = answer.type === "unmade" ? answer.why : "";
      return { outcome: "refused", text: `No exercise was made: ${why}.` };
    }
    this.made = { file: `${name}.toml`, text: answer.text };
    this.take(this.made.file, answer.text, berth?.files ?? {});
    const text = `${name}.toml is the scenario of this page now, and runs. Save the file to run it by fenderline run or serve.`;
    return { outcome: "kept", text };
  }

  private save(): void {
    const { file, text } = this.made;
    const url = URL.createObjectURL(new Blob([text], { type: "application/toml" }));
    h("a", { href: url, download: file }).click();
    URL.revokeObjectURL(url);
  }
}

const job = ({ file, text, files }: (typeof EXAMPLES)[number]) => ({
  file,
  text,
  files: files ?? {},
});
