/** Signatures of pictures: mean colours of a coarse grid, as text, so that references stay small. */
import type { Locator, Page } from "playwright-core";

/** Fields of the grid across and down. */
export const GRID: [number, number] = [16, 9];

/** The mean colours of the fields of a picture of an element, row by row, as hexadecimal numbers. */
export async function signature(page: Page, of: Locator): Promise<string> {
  const png = (await of.screenshot()).toString("base64");
  return page.evaluate(
    async ([png, wide, high]) => {
      const image = new Image();
      image.src = `data:image/png;base64,${png}`;
      await image.decode();
      const area = document.createElement("canvas");
      [area.width, area.height] = [image.width, image.height];
      const to = area.getContext("2d");
      if (!to) throw new Error("a browser has a canvas");
      to.drawImage(image, 0, 0);
      const { data } = to.getImageData(0, 0, area.width, area.height);
      const sums = Array.from({ length: wide * high }, () => [0, 0, 0, 0]);
      for (let y = 0; y < area.height; y++)
        for (let x = 0; x < area.width; x++) {
          const field =
            Math.floor((y * high) / area.height) * wide + Math.floor((x * wide) / area.width);
          const at = 4 * (y * area.width + x);
          const sum = sums[field];
          if (!sum) continue;
          for (let k = 0; k < 3; k++) sum[k] = (sum[k] ?? 0) + (data[at + k] ?? 0);
          sum[3] = (sum[3] ?? 0) + 1;
        }
      const two = (n: number) => Math.round(n).toString(16).padStart(2, "0");
      return sums
        .map(([r = 0, g = 0, b = 0, count = 1]) => two(r / count) + two(g / count) + two(b / count))
        .join("");
    },
    [png, ...GRID] as const,
  );
}

/** How far two pictures are apart: the mean and the largest difference of a field's channels, of 255. */
export function apart(one: string, other: string): { mean: number; most: number } {
  const numbers = (text: string) =>
    (text.match(/../g) ?? []).map((pair) => Number.parseInt(pair, 16));
  const [a, b] = [numbers(one), numbers(other)];
  if (a.length !== b.length || a.length === 0) return { mean: 255, most: 255 };
  const off = a.map((v, i) => Math.abs(v - (b[i] ?? 0)));
  return { mean: off.reduce((sum, v) => sum + v, 0) / off.length, most: Math.max(...off) };
}
