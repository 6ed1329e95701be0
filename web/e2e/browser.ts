/** A headless browser, and the server under test: the mock, or the one that the environment names. */
import { mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { type BrowserContext, type Page, chromium } from "playwright-core";
import { startMock } from "../mock/server";

const FLAGS = [
  "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update", "--disable-sync",
];

export interface Served {
  url: string;
  /** By role: `instructor`, `pilot`, `tugmaster`, `observer`. */
  tokens: Record<string, string>;
  mock: boolean;
  close(): Promise<void>;
}

/**
 * The server under test. `FENDERLINE_URL` names a real one, and `FENDERLINE_TOKENS` its tokens as JSON by role:
 * `{"instructor": "…", "pilot": "…", "tugmaster": "…"}`; `FENDERLINE_TUG` is the tug of that tugmaster.
 */
export async function serve(): Promise<Served> {
  const url = process.env.FENDERLINE_URL;
  if (url) {
    const tokens = JSON.parse(process.env.FENDERLINE_TOKENS ?? "{}") as Record<string, string>;
    return { url, tokens, mock: false, close: async () => {} };
  }
  const mock = await startMock({ port: 0, serveDist: true });
  const { "tugmaster-alpha": tugmaster, ...rest } = mock.tokens;
  return { url: mock.url, tokens: { ...rest, tugmaster: tugmaster ?? "" }, mock: true, close: () => mock.close() };
}

export interface Browser {
  context: BrowserContext;
  close(): Promise<void>;
}

export async function browse(size: { width: number; height: number }, touch = false): Promise<Browser> {
  const context = await chromium.launchPersistentContext(mkdtempSync(join(tmpdir(), "fenderline-e2e-")), {
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    headless: true,
    args: FLAGS,
    viewport: size,
    hasTouch: touch,
  });
  return { context, close: () => context.close() };
}

/** Opens the page of a role and waits until it has data. What goes wrong in the page fails the test. */
export async function open(context: BrowserContext, served: Served, role: string, errors: string[], hints = false): Promise<Page> {
  const page = await context.newPage();
  page.on("pageerror", (error) => errors.push(`${role}: ${error.message}`));
  page.on("console", (message) => message.type() === "error" && errors.push(`${role}: ${message.text()}`));
  if (!hints) {
    await page.addInitScript(() => {
      for (const name of ["pilot", "tugmaster", "instructor", "observer"]) localStorage.setItem(`hints seen ${name}`, "yes");
    });
  }
  const token = served.tokens[role];
  if (token === undefined) throw new Error(`there is no token for ${role}`);
  await page.goto(`${served.url}/?token=${encodeURIComponent(token)}`);
  await page.getByRole("img", { name: "Plan of ship" }).waitFor();
  await page.waitForFunction(() => (document.querySelector(".readout dd")?.textContent ?? "–") !== "–");
  return page;
}
