import { describe, expect, it } from "vitest";

import { around, kLongest, kShortest, panned, paused, rangeOf, showing, zoomed, type TimeWindow } from "../../../src/scope/view/window";

const kLive: TimeWindow = { follows: true, span: 10, to: 0 };
const kStill: TimeWindow = { follows: false, span: 10, to: 20 };

describe("a window", () => {
  it("follows the newest data", () => {
    expect(rangeOf(kLive, 33)).toEqual({ from: 23, to: 33 });
    expect(rangeOf(kStill, 33)).toEqual({ from: 10, to: 20 });
  });

  it("stands still once it was moved", () => {
    expect(panned(kLive, -2, 33)).toEqual({ follows: false, span: 10, to: 31 });
  });

  it("keeps the instant about which it is zoomed", () => {
    const near = rangeOf(zoomed(kStill, 0.1, 12, 33), 33);
    expect((12 - near.from) / (near.to - near.from)).toBeCloseTo(0.2);
    expect(zoomed(kLive, 0.5, 12, 33)).toEqual({ follows: true, span: 5, to: 0 });
  });

  it("has a shortest and a longest length", () => {
    expect(zoomed(kStill, 0, 15, 33).span).toBe(kShortest);
    expect(zoomed(kStill, 1e9, 15, 33).span).toBe(kLongest);
    expect(showing({ from: 5, to: 5 }).span).toBe(kShortest);
  });

  it("stands still where it is, and follows again", () => {
    expect(paused(kLive, true, 33)).toEqual({ follows: false, span: 10, to: 33 });
    expect(paused(kStill, false, 33).follows).toBe(true);
  });

  it("shows an instant in the middle", () => {
    expect(rangeOf(around(kStill, 100), 0)).toEqual({ from: 95, to: 105 });
  });
});
