/** A headset is offered only where the browser has one, and what went wrong is said in words. */
import { expect, test } from "vitest";
import { type Asked, hasHeadset, whyNot } from "../src/bridge/xr";

const says = (answer: () => Promise<boolean>): Asked => ({ isSessionSupported: answer });

test("a browser without WebXR, without a headset, or that forbids to ask has none", async () => {
  expect(await hasHeadset(undefined)).toBe(false);
  expect(await hasHeadset(says(async () => false))).toBe(false);
  expect(
    await hasHeadset(says(() => Promise.reject(new DOMException("no", "SecurityError")))),
  ).toBe(false);
  expect(await hasHeadset(says(async () => true))).toBe(true);
});

test("why a session did not start is said in words", () => {
  expect(whyNot(new DOMException("", "NotSupportedError"))).toMatch(/no headset/);
  expect(whyNot(new DOMException("", "SecurityError"))).toMatch(/did not allow/);
  expect(whyNot(new DOMException("", "InvalidStateError"))).toMatch(/another page/);
  expect(whyNot(new Error("the cable is out"))).toBe("the cable is out");
  expect(whyNot(undefined)).toBe("the browser says no reason");
});
