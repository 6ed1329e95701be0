/** What can be measured of a page: axe's findings, contrast of all texts, touch targets, elements that stick out. */
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import type { BrowserContext, Page } from "playwright-core";

/** Large texts too: axe alone asks 3:1 of those. */
const LEAST_CONTRAST = 4.5;

const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** Makes axe available to every page of a context. */
export async function withAxe(context: BrowserContext): Promise<void> {
  await context.addInitScript({
    content: `${AXE}
      axe.configure({ checks: [{ id: "color-contrast", options: { contrastRatio: {
        normal: { expected: ${LEAST_CONTRAST} }, large: { expected: ${LEAST_CONTRAST} } } } }] });`,
  });
}

interface Found {
  violations: {
    id: string;
    nodes: { html: string; target: unknown[]; failureSummary?: string }[];
  }[];
}

/** axe's findings, within an element of the page or in all of it. `rules`: only these. */
export async function axe(page: Page, within?: string, rules?: string[]): Promise<string[]> {
  const { violations } = await page.evaluate(
    async ({ within, rules }) => {
      const { axe } = window as unknown as {
        axe: { run(where: unknown, options: object): Promise<Found> };
      };
      return axe.run(within ?? document, {
        resultTypes: ["violations"],
        ...(rules && { runOnly: { type: "rule", values: rules } }),
      });
    },
    { within, rules },
  );
  return violations.flatMap(({ id, nodes }) =>
    nodes.map(
      ({ html, failureSummary }) =>
        `${id}: ${html.slice(0, 160)} ${failureSummary?.split("\n").slice(1).join(" ").trim() ?? ""}`,
    ),
  );
}

/** Names of visible touch targets smaller than 44 px, and of elements that extend beyond their card or the page. */
export const sizes = (page: Page): Promise<string[]> =>
  page.evaluate(() => {
    const found: string[] = [];
    for (const each of document.querySelectorAll<HTMLElement>("button, select, input, a[href]")) {
      if (each.offsetParent === null) continue;
      const box = each.getBoundingClientRect();
      const name = each.getAttribute("aria-label") ?? each.textContent ?? "";
      // A slider's track may be thinner if there are other ways to set the value.
      if (box.width < 43.5 || (box.height < 43.5 && !each.closest(".thruster .track")))
        found.push(`${name}: ${box.width.toFixed(0)} × ${box.height.toFixed(0)}`);
      const card = each.closest(".card")?.getBoundingClientRect();
      if (card && (box.right > card.right + 1 || box.left < card.left - 1))
        found.push(`${name} sticks out of its card`);
      // The row of tabs scrolls by its arrows.
      const scrolls = each.closest(".tab-list") !== null;
      if (!scrolls && (box.right > innerWidth + 1 || box.left < -1))
        found.push(`${name} is out of the page`);
    }
    for (const each of document.querySelectorAll<HTMLElement>(
      "html, body, #app, .view.shown, .controls, .groups",
    ))
      if (each.scrollWidth > each.clientWidth + 1 && each.clientWidth > 0)
        found.push(
          `${each.className || each.tagName} scrolls sideways: ${each.scrollWidth} in ${each.clientWidth}`,
        );
    return found;
  });

/** The labels of the plan: those that overlap or stick out, and the texts of all. */
export const labels = (page: Page): Promise<{ faults: string[]; texts: string[] }> =>
  page.getByRole("img", { name: "Plan of ship" }).evaluate((root) => {
    type Box = [number, number, number, number];
    const { labelled, clientWidth, clientHeight } = root as HTMLCanvasElement & {
      labelled: { placed: { label: { text: string }; box: Box }[]; taken: Box[] };
    };
    const all = [
      ...labelled.placed.map(({ label, box }) => ({ text: label.text, box })),
      ...labelled.taken.map((box) => ({ text: "scale, rose or buttons", box })),
    ];
    const faults = labelled.placed
      .filter(
        ({ box: [x, y, w, h] }) => x < 0 || y < 0 || x + w > clientWidth || y + h > clientHeight,
      )
      .map(({ label }) => `${label.text} sticks out`);
    all.forEach(({ text, box: [x, y, w, h] }, i) => {
      if (i >= labelled.placed.length) return;
      for (const other of all.slice(i + 1)) {
        const [left, top, wide, high] = other.box;
        if (x < left + wide && left < x + w && y < top + high && top < y + h)
          faults.push(`${text} over ${other.text}`);
      }
    });
    return { faults, texts: labelled.placed.map(({ label }) => label.text) };
  });
