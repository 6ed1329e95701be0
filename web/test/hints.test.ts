import { expect, test } from "vitest";
import { short } from "../src/hints";

test("the first hint is one sentence and one next step, not the whole text of the exercise", () => {
  const text =
    "She comes at 1.5 knots, with tugs. Stop her 30 m off, abreast of the fenders. Then make her fast.";
  expect(short(text)).toBe("She comes at 1.5 knots, with tugs. Press “?” for all of the task.");
  expect(short("Berth her.")).toBe("Berth her.");
  expect(short("Berth her")).toBe("Berth her");
});
