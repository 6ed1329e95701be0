import { expect, test } from "vitest";
import { numberAt, stepped } from "../run/numbers";

test("a number steps by about a tenth of itself, in its own decimals", () => {
  const steps: [string, string, string][] = [
    ["4", "4.1", "3.9"],
    ["186", "196", "176"],
    ["0.1494", "0.1594", "0.1394"],
    ["87800", "88800", "86800"],
    ["-5", "-4.9", "-5.1"],
    ["0", "1", "-1"],
    ["0.0", "0.1", "-0.1"],
    ["1.5", "1.6", "1.4"],
  ];
  for (const [text, up, down] of steps)
    expect([stepped(text, true), stepped(text, false)]).toEqual([up, down]);
});

test("the number at the cursor is one of a value, not of a name or a comment", () => {
  const text = 'a_1 = [12.5, "-3 kn"] # 7\n# 8\nmass = "930 t"\n';
  const at = (place: number) => numberAt(text, place)?.text ?? null;
  expect(at(0)).toBe("12.5");
  expect(at(9)).toBe("12.5");
  expect(at(text.indexOf("kn"))).toBe("-3");
  expect(at(text.indexOf("7"))).toBe("-3");
  expect(at(text.indexOf("8"))).toBe(null);
  expect(at(text.indexOf("mass") + 1)).toBe("930");
  expect(at(text.length)).toBe(null);
});
