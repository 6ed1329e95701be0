/** A model of a ship for tests: a red box; and how much red a view has. */
import type { Page } from "playwright-core";

/** Corners of a box, in the axes of glTF [m]: 30 m wide, from 2 m below the water to 25 m above it, 180 m long. */
export function box(): number[] {
  const [x, y, z] = [
    [-15, 15],
    [-2, 25],
    [-90, 90],
  ] as const;
  const at = (i: number, j: number, k: number) => [x[i] ?? 0, y[j] ?? 0, z[k] ?? 0];
  const quad = (a: number[], b: number[], c: number[], d: number[]) => [a, b, c, a, c, d].flat();
  return [
    quad(at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0)),
    quad(at(1, 0, 1), at(0, 0, 1), at(0, 1, 1), at(1, 1, 1)),
    quad(at(1, 0, 0), at(1, 0, 1), at(1, 1, 1), at(1, 1, 0)),
    quad(at(0, 0, 1), at(0, 0, 0), at(0, 1, 0), at(0, 1, 1)),
    quad(at(0, 1, 0), at(1, 1, 0), at(1, 1, 1), at(0, 1, 1)),
  ].flat();
}

/** Share of the picture that is as red as the box. */
export async function red(page: Page): Promise<number> {
  const png = (await page.getByRole("img", { name: /^View / }).screenshot()).toString("base64");
  return page.evaluate(async (png) => {
    const image = new Image();
    image.src = `data:image/png;base64,${png}`;
    await image.decode();
    const area = new OffscreenCanvas(image.width, image.height).getContext("2d");
    if (!area) throw new Error("a browser has a canvas");
    area.drawImage(image, 0, 0);
    const { data } = area.getImageData(0, 0, image.width, image.height);
    let count = 0;
    for (let i = 0; i < data.length; i += 4)
      if ((data[i] ?? 0) > 90 && (data[i] ?? 0) > 2 * Math.max(data[i + 1] ?? 0, data[i + 2] ?? 0))
        count += 1;
    return count / (data.length / 4);
  }, png);
}
