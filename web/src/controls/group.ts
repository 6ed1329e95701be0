/** What the control strip is made of. */
import type { Page } from "../page";
import type { Control, Frame, Hello } from "../protocol";
import { button, h, setClass, setText } from "../ui/dom";

export interface KeyAction {
  /** As `KeyboardEvent.key`. */
  key: string;
  text: string;
  /** Held, it goes on. */
  repeats?: boolean;
  run(): void;
}

/** Controls that are shown together. */
export interface Group {
  name: string;
  root: HTMLElement;
  tick(frame: Frame, hello: Hello): void;
  claims(hello: Hello): void;
  draw?(now_ms: number): void;
  keys: KeyAction[];
}

/** Takes and gives back one helm, and says who has it. */
export class ClaimBar {
  private readonly who = h("span", { class: "who" });
  private readonly take: HTMLButtonElement;
  private readonly release: HTMLButtonElement;
  readonly root: HTMLElement;

  constructor(private readonly page: Page, private readonly control: Control, private readonly what: string) {
    this.take = button(`Take ${what}`, () => void this.claim(), { class: "take" });
    this.release = button("Release", () => void page.order({ do: "release", control }), { name: `Release ${what}`, class: "release" });
    this.root = h("div", { class: "claim" }, this.take, this.who, this.release);
  }

  private async claim(): Promise<void> {
    if (await this.page.order({ do: "claim", control: this.control })) this.page.did("claim");
  }

  /** Whether the control is this page's. */
  show(): boolean {
    const { live } = this.page;
    const mine = live.mine(this.control);
    const claim = live.holder(this.control);
    const other = mine ? null : (claim?.holder ?? null);
    // A page may command a tug that nobody holds, without taking her: then there is nothing to give back.
    const claimed = mine && claim?.holder !== null;
    setClass(this.take, "hidden", mine);
    setClass(this.release, "hidden", !claimed);
    setText(this.who, mine ? (claimed ? `You have ${this.what}` : "") : other ? `${other} has ${this.what}${claim?.connected ? "" : " (gone)"}` : "");
    return mine;
  }
}
