/** A row of tabs in one line: where they do not fit, arrows show that there are more, and scroll to them. */
import { button, h, setClass } from "./dom";

export class TabRow {
  private readonly list: HTMLElement;
  private readonly before = button("‹", () => this.scroll(-1), {
    name: "Earlier tabs",
    class: "more hidden",
  });
  private readonly after = button("›", () => this.scroll(1), {
    name: "More tabs",
    class: "more hidden",
  });
  readonly root: HTMLElement;

  constructor(tabs: HTMLButtonElement[]) {
    this.list = h(
      "div",
      { class: "tab-list", role: "tablist", "aria-label": "Views", onscroll: () => this.mark() },
      ...tabs,
    );
    this.root = h("div", { class: "tab-row" }, this.before, this.list, this.after);
    new ResizeObserver(() => this.mark()).observe(this.list);
  }

  /** Scrolls a tab into the row. */
  reveal(tab: HTMLElement): void {
    const [left, right] = [tab.offsetLeft - this.list.offsetLeft, tab.offsetWidth];
    if (left < this.list.scrollLeft) this.list.scrollLeft = left;
    else if (left + right > this.list.scrollLeft + this.list.clientWidth)
      this.list.scrollLeft = left + right - this.list.clientWidth;
    this.mark();
  }

  private scroll(way: number): void {
    this.list.scrollLeft += way * 0.7 * this.list.clientWidth;
  }

  /** Both arrows keep their room while tabs do not fit: a tab must not move away under a finger as the row scrolls to it. */
  private mark(): void {
    const { scrollLeft, scrollWidth, clientWidth } = this.list;
    // Without the arrows the tabs have the whole row.
    const fits = scrollWidth <= this.root.clientWidth + 1;
    for (const each of [this.before, this.after]) setClass(each, "hidden", fits);
    setClass(this.before, "ended", scrollLeft < 1);
    setClass(this.after, "ended", scrollLeft + clientWidth > scrollWidth - 1);
    for (const tab of this.list.children) {
      const { offsetLeft, offsetWidth } = tab as HTMLElement;
      const from = offsetLeft - this.list.offsetLeft - scrollLeft;
      setClass(tab, "cut", from < -1 || from + offsetWidth > clientWidth + 1);
    }
  }
}
