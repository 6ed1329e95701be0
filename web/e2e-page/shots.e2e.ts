/** Pictures of the page on a desk, a tablet and a phone, for people to look at; nothing may stick out of the screen. */
import { expect, test } from "vitest";
import { SHOTS } from "../e2e/browser";
import { opened, reran } from "./served";

const SIZES = [
  { name: "desk", size: { width: 1600, height: 900 }, touch: false },
  { name: "tablet", size: { width: 1024, height: 768 }, touch: true },
  { name: "phone", size: { width: 390, height: 844 }, touch: true },
];

test.each(SIZES)("$name", async ({ name, size, touch }) => {
  const { page, close, errors } = await opened(size, touch);
  try {
    for (const tab of ["Scenario", "Fenders", "Charts", "Verdict", "Report"]) {
      const own = page.getByRole("tab", { name: tab });
      if ((await own.count()) === 0) continue;
      await own.click();
      if (tab === "Fenders") await page.getByRole("button", { name: "Go to the largest" }).click();
      await page.waitForTimeout(600);
      await page.screenshot({ path: `${SHOTS}page-${name}-${tab.toLowerCase()}.png` });
    }
    const own = page.getByRole("tab", { name: "Scenario" });
    if ((await own.count()) > 0) await own.click();
    const editor = page.getByRole("textbox", { name: "Scenario" });
    const broken = (await editor.inputValue()).replace("restitution", "restitutoin");
    await reran(page, () => editor.fill(broken));
    await page.screenshot({ path: `${SHOTS}page-${name}-mistake.png` });
    const wider = await page.evaluate(
      () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
    );
    expect(wider).toBe(0);
    expect(errors).toEqual([]);
  } finally {
    await close();
  }
});
