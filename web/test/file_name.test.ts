import { expect, test } from "vitest";
import { fileNameOf, isFileName } from "../src/file_name";

test("a title becomes a file name that the server accepts", () => {
  expect(fileNameOf("Training berth 1")).toBe("Training_berth_1");
  expect(fileNameOf("  Kaimauer Süd, 20 kn – E-Pier ")).toBe("Kaimauer_Sud_20_kn_E-Pier");
  expect(fileNameOf("../outside")).toBe("outside");
  expect(fileNameOf("港")).toBe("");
  expect(isFileName(fileNameOf("x y ".repeat(40)))).toBe(true);
  for (const bad of ["", "a b", "a.b", "ü", "a".repeat(61)]) expect(isFileName(bad)).toBe(false);
});
