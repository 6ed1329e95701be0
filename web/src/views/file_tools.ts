/** Renames and deletes recordings and saved exercises of the gallery; what was deleted can be put back. */
import type { Page } from "../page";
import type { Hello } from "../protocol";
import { NAME_RULE, isFileName, withoutSpaces } from "../file_name";
import { button, h, setClass, setText } from "../ui/dom";
import { ask } from "../ui/question";

type Entry = Hello["gallery"][number];

/** The name of a file without its ending. */
const stemOf = ({ file }: Entry): string => file.replace(/(\.session\.jsonl|\.toml)$/, "");
const filesOf = (entries: Hello["deleted"]): Set<string> =>
  new Set(entries?.map(({ file }) => file));

export class FileTools {
  /** What was done last, with a way back. It is kept when the lists are built anew. */
  readonly root: HTMLElement;
  private readonly note = h("span", { role: "status", "aria-label": "Recordings and exercises" });
  private readonly undo = button("Undo", () => void this.undoDelete(), { class: "hidden take" });
  /** Deleted by this page a moment ago: the greeting with its file is still to come. */
  private waiting: { stem: string; before: Set<string> } | null = null;
  /** The file that "Undo" puts back. */
  private last: Entry | null = null;

  constructor(private readonly page: Page) {
    this.root = h("div", { class: "row file-note" }, this.note, this.undo);
  }

  /** The buttons of a recording or an exercise; none of one that the server does not change. */
  of(entry: Entry, hello: Hello): HTMLElement[] {
    if (!entry.changeable || entry.file === hello.file) return [];
    const stem = stemOf(entry);
    const rename = button("Rename", () => form.show(), { name: `Rename ${stem}` });
    const form = this.form(entry, rename);
    return [
      rename,
      button("Delete", () => void this.remove(entry), { name: `Delete ${stem}` }),
      form.root,
    ];
  }

  /** A field for another name, hidden until it is asked for. */
  private form(entry: Entry, after: HTMLElement): { root: HTMLElement; show(): void } {
    const stem = stemOf(entry);
    const name = h("input", {
      type: "text",
      "aria-label": `New name of ${stem}`,
      maxlength: 60,
      value: stem,
    });
    withoutSpaces(name);
    const shows = (on: boolean) => {
      setClass(root, "hidden", !on);
      (on ? name : after).focus();
    };
    const root = h(
      "form",
      {
        class: "row rename hidden",
        onsubmit: (event: Event) => {
          event.preventDefault();
          void this.rename(entry, name.value.trim());
        },
        onkeydown: (event: KeyboardEvent) => {
          if (event.key === "Escape") shows(false);
        },
      },
      name,
      h("button", { type: "submit", "aria-label": `Save name of ${stem}` }, "Save name"),
      button("Cancel", () => shows(false), { name: `Cancel renaming ${stem}` }),
    );
    return {
      root,
      show: () => {
        shows(true);
        name.select();
      },
    };
  }

  private async rename(entry: Entry, name: string): Promise<void> {
    const stem = stemOf(entry);
    if (!isFileName(name)) {
      this.page.say(`Not renamed. ${NAME_RULE}`, "refusal");
      return;
    }
    if (name === stem) {
      this.page.say(`It is named ${stem}.`);
      return;
    }
    if (await this.page.order({ do: "rename", file: entry.file, name }))
      this.tell(`${stem} is named ${name} now.`, null);
  }

  private async remove(entry: Entry): Promise<void> {
    const stem = stemOf(entry);
    const sure = await ask({
      title: `Delete ${stem}?`,
      text: `“${entry.title}” goes out of the list. Undo, or the list Deleted at the end of this tab, puts it back.`,
      yes: "Delete it",
      no: "Keep it",
    });
    if (!sure) return;
    this.waiting = { stem, before: filesOf(this.page.live.hello?.deleted) };
    if (!(await this.page.order({ do: "delete", file: entry.file }))) this.waiting = null;
  }

  private async undoDelete(): Promise<void> {
    if (this.last) await this.putBack(this.last);
  }

  private async putBack(entry: Entry): Promise<void> {
    if (await this.page.order({ do: "put_back", file: entry.file }))
      this.tell(`${stemOf(entry)} is back.`, null);
  }

  /** Says what was done; with a file, that it can be put back. */
  private tell(text: string, last: Entry | null): void {
    this.last = last;
    setText(this.note, text);
    setClass(this.undo, "hidden", last === null);
  }

  /** What was deleted, the latest first; it takes note of what this page has deleted. */
  deleted(hello: Hello): HTMLElement | null {
    const entries = hello.deleted ?? [];
    const { waiting } = this;
    const gone = waiting && entries.findLast(({ file }) => !waiting.before.has(file));
    if (waiting && gone) {
      this.waiting = null;
      this.tell(`${waiting.stem} is deleted.`, gone);
      // The button that was pressed is gone. The lists are put into the page first.
      setTimeout(() => this.undo.focus());
    } else if (this.last && !filesOf(entries).has(this.last.file)) this.tell("", null);
    if (entries.length === 0) return null;
    const row = (entry: Entry) =>
      h(
        "li",
        {},
        h("div", {}, h("b", {}, entry.title), h("p", { class: "note" }, `File ${entry.file}.`)),
        button("Put back", () => void this.putBack(entry), { name: `Put back ${stemOf(entry)}` }),
      );
    return h(
      "ul",
      { class: "rows gallery", "aria-label": "Deleted" },
      ...entries.toReversed().map(row),
    );
  }
}
