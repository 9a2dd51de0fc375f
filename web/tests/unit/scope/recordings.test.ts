import { describe, expect, it } from "vitest";

import { presentRun } from "../../../src/scope/data/present_run";
import { findFault, stepMarks } from "../../../src/scope/data/recordings";
import type { UnitEvent } from "../../../src/source/types";

function at(t: number, more: Partial<UnitEvent> = {}): UnitEvent {
  return { t, kind: "fault", ...more };
}

describe("events of a run", () => {
  it("begin anew when time does", () => {
    expect(presentRun([at(1), at(900), at(0.1), at(2), at(1.9)]).map(({ t }) => t)).toEqual([0.1, 2, 1.9]);
    expect(presentRun([at(1), at(2)])).toHaveLength(2);
    expect(presentRun([])).toEqual([]);
  });

  it("hold the last coming of a fault", () => {
    const events = [
      at(1, { axis: 1, number: 7900, active: true }),
      at(2, { axis: 2, number: 7900, active: true }),
      at(3, { axis: 1, number: 7900, active: true }),
      at(4, { axis: 1, number: 7900, active: false }),
    ];
    expect(findFault(events, 1, 7900)?.t).toBe(3);
    expect(findFault(events, 0, 7900)).toBeUndefined();
    expect(findFault([at(5, { number: 1000, active: true })], 0, 1000)?.t).toBe(5);
  });
});

describe("steps of a scenario", () => {
  it("are marks from the beginning of the recording", () => {
    const report = {
      steps: [
        { step: 1, name: "start", what: "nmt start", t: 0.5, outcome: "passed" },
        { step: 2, what: "expect state", t: 1.5, outcome: "failed" },
        { step: 3, what: "later", t: 0, outcome: "not run" },
      ],
    };
    expect(stepMarks(report, 10)).toEqual([
      { t: 10.5, text: "start", isFailed: false },
      { t: 11.5, text: "expect state", isFailed: true },
    ]);
  });

  it("are none without a report", () => {
    expect(stepMarks(undefined, 0)).toEqual([]);
    expect(stepMarks({ steps: 3 }, 0)).toEqual([]);
  });
});
