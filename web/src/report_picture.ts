/** Puts the picture of the largest fender load into a report, which the program has made without pictures of the view. */
import type { Drawn } from "./bridge/moment";

/** The class of what is put in; a second picture takes the place of the first. */
const CLASS = "view-picture";

/** Puts a picture, or why there is none, below the heading of the fenders, or at the end. */
export function insertPicture(report: Document, drawn: Drawn): void {
  const make = <K extends keyof HTMLElementTagNameMap>(tag: K, text = "") => {
    const element = report.createElement(tag);
    element.textContent = text;
    return element;
  };
  const root = make("figure");
  if ("image" in drawn) {
    const image = make("img");
    image.src = drawn.image;
    image.alt = `The view at the largest fender load. ${drawn.words}`;
    image.style.cssText = "display: block; width: 100%; height: auto";
    const note = make(
      "p",
      `${drawn.words} Drawn by the page; the report that the program writes has no such picture.`,
    );
    note.className = "note";
    root.append(make("figcaption", "The moment of the largest fender load"), image, note);
  } else {
    const note = make("p", `There is no picture of the largest fender load: ${drawn.none}.`);
    note.className = "note";
    root.append(note);
  }
  root.className = CLASS;
  report.querySelector(`.${CLASS}`)?.remove();
  const heading = [...report.querySelectorAll("h2")].find(
    ({ textContent }) => textContent === "Fenders",
  );
  if (heading) heading.after(root);
  else report.querySelector("main")?.append(root);
}

/** The text of a report with the picture. */
export function withPicture(html: string, drawn: Drawn): string {
  const report = new DOMParser().parseFromString(html, "text/html");
  insertPicture(report, drawn);
  return `<!DOCTYPE html>\n${report.documentElement.outerHTML}\n`;
}

/** How often a tab is looked at, and for how long [ms]. */
const LOOKS_MS = 100;
const GIVES_UP_MS = 60_000;

/** Whether a tab shows the whole report at the address; `null`: the tab is closed, or shows another site. */
function shows(tab: Window, address: string): boolean | null {
  if (tab.closed) return null;
  try {
    return tab.location.href === address && tab.document.readyState === "complete";
  } catch {
    // A browser refuses to tell the address of another site, to which the user has led the tab.
    return null;
  }
}

/**
 * Puts the picture into the report that a tab of ours shows or will show, with a link that saves the report with the picture.
 * `address`: that of the report; `name`: of the saved file.
 */
export function illustrate(tab: Window, address: string, name: string, drawn: Drawn): void {
  const begun = performance.now();
  const timer = setInterval(() => {
    const isThere = shows(tab, address);
    if (isThere === false && performance.now() - begun < GIVES_UP_MS) return;
    clearInterval(timer);
    if (!isThere) return;
    insertPicture(tab.document, drawn);
    void offerToSave(tab.document, address, name, drawn);
  }, LOOKS_MS);
}

/** A link that saves the report with the picture: a browser that saves a page may fetch it again, without the picture. */
async function offerToSave(
  report: Document,
  address: string,
  name: string,
  drawn: Drawn,
): Promise<void> {
  if (!("image" in drawn)) return;
  const answer = await fetch(address);
  if (!answer.ok) return;
  const file = new Blob([withPicture(await answer.text(), drawn)], { type: "text/html" });
  const style = report.createElement("style");
  style.textContent = `@media print { .${CLASS} a { display: none; } }`;
  const link = report.createElement("a");
  link.href = URL.createObjectURL(file);
  link.download = name;
  link.textContent = "Save this report with the picture";
  report.querySelector(`.${CLASS}`)?.append(link, style);
}
