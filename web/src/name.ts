/** The name of the person at this page: kept by the browser, told to the server at each connection. */
import { button, h, setText } from "./ui/dom";

/** The server's limit (characters). */
const LONGEST_NAME = 30;
const KEY = "name";

export class NameBadge {
  private readonly input = h("input", {
    type: "text",
    id: "person-name",
    maxlength: LONGEST_NAME,
    autocomplete: "off",
  });
  private readonly dialog: HTMLDialogElement;
  private told = false;
  private role = "";
  /** Shows the role and the name; a press asks for the name. */
  readonly root: HTMLButtonElement;

  constructor(private readonly tell: (name: string) => Promise<boolean>) {
    this.root = button("", () => this.ask(), { class: "badge name-badge" });
    this.dialog = h(
      "dialog",
      { class: "name-dialog", "aria-label": "Your name" },
      h(
        "form",
        { method: "dialog", onsubmit: () => void this.change(this.input.value.trim()) },
        h("label", { for: "person-name" }, "Your name, as the others see it"),
        this.input,
        h(
          "div",
          { class: "row" },
          h("button", { type: "submit", class: "take" }, "Use this name"),
          button("Cancel", () => this.dialog.close()),
        ),
      ),
    );
    document.body.append(this.dialog);
  }

  show(role: string): void {
    this.role = role;
    const name = localStorage.getItem(KEY) ?? "";
    setText(this.root, name === "" ? role : `${role} · ${name}`);
    this.root.title = name === "" ? "Say who you are" : "Change your name";
  }

  /** The connection is new: the server does not know the name. */
  forgotten(): void {
    this.told = false;
  }

  /** Tells the server the name, once per connection. */
  greet(): void {
    const name = localStorage.getItem(KEY);
    if (this.told || !name) return;
    this.told = true;
    void this.tell(name);
  }

  private ask(): void {
    this.input.value = localStorage.getItem(KEY) ?? "";
    this.dialog.showModal();
  }

  private async change(name: string): Promise<void> {
    if (name === "" || !(await this.tell(name))) return;
    localStorage.setItem(KEY, name);
    this.told = true;
    this.show(this.role);
  }
}
