import { describe, expect, it } from "vitest";

import { heightOf, isBit, laneHeights, plotLanes, rowAt, rowsOf } from "../../../src/scope/view/layout";

describe("lanes of curves", () => {
  const kSignals = [
    { signal: "1/speed", unit: "rpm" },
    { signal: "1/r0899.2", unit: "" },
    { signal: "1/torque", unit: "Nm" },
    { signal: "2/speed", unit: "rpm" },
  ];

  it("have a unit of measure each, bits below", () => {
    expect(plotLanes(kSignals)).toEqual([
      { title: "rpm", isBit: false, signals: [0, 3] },
      { title: "Nm", isBit: false, signals: [2] },
      { title: "1/r0899.2", isBit: true, signals: [1] },
    ]);
  });

  it("share the height, but are never too low", () => {
    expect(laneHeights(plotLanes(kSignals), 440)).toEqual([200, 200, 40]);
    expect(laneHeights(plotLanes(kSignals), 50)).toEqual([84, 84, 40]);
  });

  it("know bits by their names", () => {
    expect(["1/r0899.2", "1/p1001[2].0", "1/r0063", "1/speed"].map(isBit)).toEqual([true, true, false, false]);
  });
});

describe("rows below the curves", () => {
  const rows = rowsOf([1, "infeed"], [0, 4]);

  it("are states, events and frames from the top", () => {
    expect(rows.map(({ name }) => name)).toEqual(["Axis 1", "Infeed", "NMT state", "Events", "NMT", "TPDO"]);
    expect(heightOf(rows)).toBeGreaterThan(rows.length * 18);
    expect(heightOf([])).toBe(0);
  });

  it("are found by their height", () => {
    for (const row of rows) expect(rowAt(rows, row.top + row.height / 2)).toBe(row);
    expect(rowAt(rows, -5)).toBeUndefined();
  });
});
