import { describe, expect, it } from "vitest";

import { decimalsOf, differenceText, instantText, niceStep, roomy, StickyRange, ticksOf } from "../../../src/scope/view/scale";

describe("a scale", () => {
  it("has round steps", () => {
    expect([0.9, 1, 1.1, 3, 7, 0.0004].map(niceStep)).toEqual([1, 1, 2, 5, 10, 0.0005]);
    expect(ticksOf(0.9, 3.1, 3)).toEqual([1, 2, 3]);
    expect(ticksOf(1, 1, 3)).toEqual([]);
  });

  it("says instants no finer than its steps", () => {
    expect(instantText(12.3456, 0.01)).toBe("12.35\u2009s");
    expect(instantText(192.5, 0.5)).toBe("3:12.5");
    expect(instantText(7384, 1)).toBe("2:03:04");
    expect(instantText(-130, 1)).toBe("-2:10");
    expect(instantText(179.99999, 0.01)).toBe("3:00.00");
    expect(decimalsOf(0.002)).toBe(3);
  });

  it("says differences in their unit", () => {
    expect([0.00025, 0.01235, 3.2, 0].map(differenceText)).toEqual(["250\u2009µs", "12.35\u2009ms", "3.2\u2009s", "0\u2009µs"]);
  });

  it("leaves room, also for what does not change", () => {
    const [low, high] = roomy(0, 100);
    expect(low).toBeLessThan(0);
    expect(high).toBeGreaterThan(100);
    const [flatLow, flatHigh] = roomy(540, 540);
    expect(flatHigh).toBeGreaterThan(flatLow);
    expect(flatLow).toBeLessThan(540);
  });
});

describe("limits that do not jump", () => {
  it("widen at once and narrow when little is used", () => {
    const limits = new StickyRange();
    const first = limits.next(0, 100);
    expect(limits.next(10, 90)).toEqual(first);
    expect(limits.next(0, 300)[1]).toBeGreaterThan(300);
    expect(limits.next(0, 20)[1]).toBeLessThan(40);
  });

  it("are some without any value", () => {
    expect(new StickyRange().next(Infinity, -Infinity)).toEqual([0, 1]);
  });
});
