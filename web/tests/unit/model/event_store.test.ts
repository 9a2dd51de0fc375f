import { describe, expect, it } from "vitest";

import { EventStore } from "../../../src/model/event_store";
import { bandsIn, timelineOf } from "../../../src/model/timeline";
import type { UnitEvent } from "../../../src/source/types";

function event(t: number, more: Partial<UnitEvent> = {}): UnitEvent {
  return { t, kind: "store", ...more };
}

describe("a store of events", () => {
  it("sorts them and keeps each once", () => {
    const store = new EventStore();
    expect(store.add([event(2, { id: 1 }), event(1.5, { id: 2 })])).toBe(2);
    const before = store.all;
    expect(store.add([event(2, { id: 1 })])).toBe(0);
    expect(store.all).toBe(before);
    expect(store.all.map(({ t }) => t)).toEqual([1.5, 2]);
    store.add([event(2.2)]);
    expect(store.all).not.toBe(before);
  });

  it("keeps the newest, of one unit", () => {
    const store = new EventStore(2, "vcan0/5");
    store.add([event(1, { unit: "vcan0/6" }), event(2, { unit: "vcan0/5" }), event(3), event(4)]);
    expect(store.all.map(({ t }) => t)).toEqual([3, 4]);
    expect(store.latest(1).map(({ t }) => t)).toEqual([4]);
    expect(store.latest(0)).toEqual([]);
  });

  it("finds a window, and begins anew with the time of the unit", () => {
    const store = new EventStore();
    store.add([1, 2, 2, 3].map((t) => event(t)));
    expect(store.window(2, 3)).toHaveLength(2);
    store.add([event(0.5)]);
    expect(store.all).toHaveLength(1);
  });
});

describe("bands of states", () => {
  const events: UnitEvent[] = [
    { t: 1, kind: "nmt", state: "Operational", before: "Pre-operational" },
    { t: 2, kind: "drive-state", axis: 1, state: "Switched on", before: "Ready to switch on" },
    { t: 3, kind: "drive-state", axis: 1, state: "Operation enabled", before: "Switched on" },
    { t: 3, kind: "drive-state", axis: "infeed", state: "Fault", before: "Operation enabled" },
  ];

  it("go from event to event, with the state before the first", () => {
    const { nmt, axes } = timelineOf(events, { nmt: "Stopped", axes: [{ axis: 1, state: "x" }, { axis: 2, state: "Fault" }] });
    expect(nmt.map(({ from, to, state }) => [from, to, state])).toEqual([
      [-Infinity, 1, "Pre-operational"],
      [1, Infinity, "Operational"],
    ]);
    expect(axes.get(1)?.map(({ state }) => state)).toEqual(["Ready to switch on", "Switched on", "Operation enabled"]);
    expect(axes.get(2)).toEqual([{ from: -Infinity, to: Infinity, state: "Fault" }]);
    expect(axes.get("infeed")?.at(-1)?.event).toBe(events[3]);
    expect(bandsIn(axes.get(1) ?? [], 2.5, 3).map(({ state }) => state)).toEqual(["Switched on"]);
  });
});
