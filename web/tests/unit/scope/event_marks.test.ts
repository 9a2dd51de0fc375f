import { describe, expect, it } from "vitest";

import { clustersOf, markLook } from "../../../src/scope/view/event_marks";
import type { UnitEvent } from "../../../src/source/types";

function event(t: number, kind: string): UnitEvent {
  return { t, kind } as UnitEvent;
}

describe("marks of events", () => {
  it("are not made of states: these are bands", () => {
    expect(markLook(event(0, "drive-state"))).toBeUndefined();
    expect(markLook(event(0, "nmt"))).toBeUndefined();
    expect(markLook(event(0, "something-new"))?.letter).toBe("?");
  });

  it("are one where they would cover each other, the most important in front", () => {
    const events = [event(0, "object"), event(1, "fault"), event(2, "emcy"), event(30, "alarm"), event(31, "drive-state")];
    const clusters = clustersOf(events, (t) => t, 13);
    expect(clusters.map(({ x, count, event: { kind } }) => [x, count, kind])).toEqual([
      [0, 3, "fault"],
      [30, 1, "alarm"],
    ]);
  });

  it("have letters that differ from kind to kind", () => {
    const kinds = ["fault", "alarm", "refusal", "control", "emcy", "bus", "link", "parameter", "object", "power", "boot-up", "store", "restore"];
    expect(new Set(kinds.map((kind) => markLook(event(0, kind))?.letter)).size).toBe(kinds.length);
  });
});
