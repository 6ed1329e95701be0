/** The page without a server: axe-core finds nothing in any tab, palette and size of screen, and all texts have a contrast of 4.5:1. */
import { afterAll, beforeAll, expect, test } from "vitest";
import { axe, sizes, withAxe } from "../e2e/faults";
import { type Opened, ended, opened } from "./served";

const SIZES = [
  { width: 1366, height: 768 },
  { width: 1024, height: 768 },
  { width: 390, height: 844 },
];
const PALETTES = ["day", "dusk", "night"];
/** In CI the contrast of dusk and night is tried at one size: colours do not depend on it. */
const palettesAt = (size: { width: number }) =>
  process.env.CI && size.width !== SIZES[0]?.width ? ["day"] : PALETTES;

let at: Opened;
beforeAll(async () => {
  at = await opened();
  await withAxe(at.context);
  await at.page.reload();
  await ended(at.page);
});
afterAll(async () => {
  await at.close();
});

test.each(SIZES)("no finding at $width × $height", async (size) => {
  const { page } = at;
  await page.setViewportSize(size);
  const found: string[] = [];
  for (const tab of await page.getByRole("tab").all()) {
    await tab.click();
    for (const name of palettesAt(size)) {
      for (let i = 0; i < 4; i++) {
        if ((await page.locator("html").getAttribute("data-palette")) === name) break;
        await page.getByRole("button", { name: /^Palette/ }).click();
      }
      const rules = name === "day" ? undefined : ["color-contrast"];
      const where = `${await tab.textContent()}, ${name}`;
      found.push(...(await axe(page, undefined, rules)).map((fault) => `${where}: ${fault}`));
    }
    found.push(...(await sizes(page)));
  }
  expect([...new Set(found)]).toEqual([]);
});
