/** What the control strip is made of. */
import type { Page } from "../page";
import { instrument } from "../instruments/instrument";
import type { Control, Frame, Hello } from "../protocol";
import { button, h, setClass, setText } from "../ui/dom";
import { spoken } from "../units";

export interface KeyAction {
  /** As `KeyboardEvent.key`. */
  key: string;
  text: string;
  /** Repeats while the key is held. */
  repeats?: boolean;
  run(): void;
}

/** Controls that are shown together. */
export interface Group {
  name: string;
  root: HTMLElement;
  tick(frame: Frame, hello: Hello): void;
  claims(hello: Hello): void;
  /** The part of the bar that is visible while this page holds the helm. */
  held?: HTMLElement;
  draw?(now_ms: number): void;
  keys: KeyAction[];
}

/** Takes and gives back one helm and shows its holder. It covers the controls until the helm is taken. */
export class ClaimBar {
  private readonly text = h("span");
  private readonly badge = instrument("obc-badge-command", { large: true });
  private readonly who = h("span", { class: "who" }, this.badge.root, this.text);
  private readonly release: HTMLButtonElement;
  /** Over the controls. */
  readonly root: HTMLElement;
  /** For the bar, while it is held. */
  readonly held: HTMLElement;

  constructor(
    private readonly page: Page,
    private readonly control: Control,
    private readonly what: string,
  ) {
    const take = button(`Take ${what}`, () => void this.claim(), { class: "take" });
    this.release = button(`Release ${what}`, () => void page.order({ do: "release", control }), {
      class: "release",
    });
    this.release.prepend(
      instrument("obc-badge-command", { status: "in-command", large: true }).root,
    );
    this.root = h("div", { class: "claim" }, take, this.who);
    this.held = this.release;
  }

  private async claim(): Promise<void> {
    if (await this.page.order({ do: "claim", control: this.control })) this.page.did("claim");
  }

  /** Whether the control is this page's. */
  show(): boolean {
    const { live } = this.page;
    const mine = live.mine(this.control);
    const claim = live.holder(this.control);
    setClass(this.root, "hidden", mine);
    // A page may command a free helm without taking it: then there is nothing to give back.
    setClass(this.release, "hidden", !mine || !claim?.holder || !claim.connected);
    const isTaken = (claim?.holder ?? null) !== null && claim?.connected === true;
    this.badge.show({ status: isTaken ? "no-command" : "command-available" });
    setText(
      this.text,
      claim?.holder
        ? `${spoken(claim.holder)} has ${this.what}${claim.connected ? "" : ", but has gone"}`
        : `Nobody has ${this.what} now.`,
    );
    return mine;
  }
}
