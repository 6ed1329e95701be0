import { join } from "node:path";
import { test } from "vitest";
import { SHOTS, browse, open, serve } from "./browser";
test("shots", async () => {
  const served = await serve();
  const { context, close } = await browse({ width: 390, height: 844 }, true);
  for (const [role, pal, tab, group, w, h] of JSON.parse(process.env.LIST ?? "[]")) {
    const page = await open(context, served, role, []);
    await page.setViewportSize({ width: w, height: h });
    for (let i = 0; i < 3 && (await page.locator("html").getAttribute("data-palette")) !== pal; i++)
      await page.keyboard.press("b");
    if (group) {
      const b = page.locator(`[data-group="${group}"]`);
      if (await b.isVisible()) await b.click();
    }
    if (tab) await page.getByRole("tab", { name: tab }).click();
    await page.waitForTimeout(900);
    await page.screenshot({ path: join(SHOTS, `a-${role}-${pal}-${tab}-${w}.png`) });
    if (w < 600) {
      await page.evaluate(() => window.scrollTo(0, 430));
      await page.waitForTimeout(200);
      await page.screenshot({ path: join(SHOTS, `a-${role}-${pal}-${tab}-${w}-2.png`) });
    }
    await page.close();
  }
  await close();
  await served.close();
});
