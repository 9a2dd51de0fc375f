import { describe, expect, it } from "vitest";

import { LiveClock } from "../../../src/scope/view/live_clock";

describe("the clock of a live picture", () => {
  it("goes evenly between answers, and not beyond what has come", () => {
    const clock = new LiveClock();
    for (let i = 0; i < 50; ++i) clock.note(100 + i * 0.1, i * 0.1);
    const before = clock.at(4.9);
    expect(clock.at(4.95) - before).toBeCloseTo(0.05, 3);
    expect(clock.at(60)).toBe(104.9);
  });

  it("never goes back", () => {
    const clock = new LiveClock();
    clock.note(10, 0);
    clock.note(10.1, 0.1);
    const shown = clock.at(0.3);
    clock.note(10.2, 3);
    expect(clock.at(3)).toBeGreaterThanOrEqual(shown);
  });

  it("begins anew with a unit that was started anew", () => {
    const clock = new LiveClock();
    clock.note(500, 0);
    clock.at(10);
    clock.reset();
    clock.note(0.5, 11);
    expect(clock.at(20)).toBe(0.5);
  });
});
