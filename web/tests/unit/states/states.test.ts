import { describe, expect, it } from "vitest";

import { edgesOf, edgeWords, opennessWords, visitsOf, type Transition } from "../../../src/states/edges";
import { borderPoint, curveOf, kNarrow, kNarrowCia402, kWide, kWideCia402, layoutOf } from "../../../src/states/layout";
import type { DriveState, StateMachine, UnitEvent } from "../../../src/source/types";
import { kStateLooks } from "../../../src/ui/state_words";

const kOff1 = { text: "OFF1 is given (p0840 = r8890.0)", met: false, parameter: "p0840" };
const kNoOff2 = { text: "OFF2 is not given (p0844 = r8890.1)", met: true, parameter: "p0844" };

function way(members: Partial<Transition>): Transition {
  return { from: "Switch on disabled", to: "Ready to switch on", is_open: false, conditions: [], ...members };
}

const kMachine: StateMachine = {
  axis: 1,
  state: "Switch on disabled",
  states: ["Switch on disabled", "Ready to switch on", "Fault"],
  transitions: [
    way({ number: 2, conditions: [kOff1, kNoOff2] }),
    way({ number: 12, from: "Quick stop active", to: "Switch on disabled" }),
    way({ from: "Quick stop active", to: "Switch on disabled", is_open: true }),
  ],
};

describe("edges", () => {
  it("gather the transitions between the same two states", () => {
    const edges = edgesOf(kMachine);
    expect(edges.map(edgeWords)).toEqual(["2: Switch on disabled → Ready to switch on", "12: Quick stop active → Switch on disabled"]);
    expect(edges.map((edge) => edge.isOpen)).toEqual([false, true]);
  });
  it("have words for what is missing", () => {
    expect(opennessWords(way({ conditions: [kOff1, kNoOff2] }), "Switch on disabled")).toBe("1 condition is missing");
    expect(opennessWords(way({ conditions: [kOff1, kOff1] }), "Switch on disabled")).toBe("2 conditions are missing");
    expect(opennessWords(way({ conditions: [kNoOff2] }), "Fault")).toBe("starts from another state");
    expect(opennessWords(way({ is_open: true }), "Switch on disabled")).toBe("open");
  });
});

describe("visits", () => {
  const events = [
    { kind: "drive-state", unit: "vcan0/5", axis: 1, t: 1, before: "Switch on disabled", state: "Ready to switch on" },
    { kind: "drive-state", unit: "vcan0/5", axis: 2, t: 2, before: "Switched on", state: "Fault" },
    { kind: "drive-state", unit: "vcan0/5", axis: 1, t: 3, before: "Ready to switch on", state: "Switched on" },
    { kind: "drive-state", unit: "vcan0/6", axis: 1, t: 4, before: "Switched on", state: "Fault" },
  ] as UnitEvent[];
  it("are those of the axis, the newest first, with how long they lasted", () => {
    expect(visitsOf(events, "vcan0/5", 1, 9)).toEqual([
      { t: 3, before: "Ready to switch on", state: "Switched on", stayed: undefined },
      { t: 1, before: "Switch on disabled", state: "Ready to switch on", stayed: 2 },
    ]);
    expect(visitsOf(events, "vcan0/5", 1, 1).map((visit) => visit.t)).toEqual([3]);
  });
  it("know no stay across a restart of the unit", () => {
    const restarted = [...events, { ...events[0], t: 0.5 } as UnitEvent];
    expect(visitsOf(restarted, "vcan0/5", 1, 9)[1]?.stayed).toBeUndefined();
  });
});

describe.each([["wide", kWide], ["narrow", kNarrow], ["wide CiA 402", kWideCia402], ["narrow CiA 402", kNarrowCia402]])("%s layout", (_, layout) => {
  const places = Object.entries(layout.places);
  it("has a place inside for every state, and no two overlap", () => {
    expect(Object.keys(layout.places).sort()).toEqual(Object.keys(kStateLooks).sort());
    for (const [name, { x, y }] of places) {
      expect(x - layout.box.width / 2).toBeGreaterThan(0);
      expect(x + layout.box.width / 2).toBeLessThan(layout.width);
      expect(y - layout.box.height / 2).toBeGreaterThan(0);
      expect(y + layout.box.height / 2).toBeLessThan(layout.height);
      for (const [other, at] of places)
        if (other !== name) expect(Math.abs(at.x - x) > layout.box.width || Math.abs(at.y - y) > layout.box.height).toBe(true);
    }
  });
  it("draws both directions apart, with numbers inside of the picture", () => {
    const down = curveOf(layout, "Switched on", "Operation enabled").label;
    const up = curveOf(layout, "Operation enabled", "Switched on").label;
    expect(Math.hypot(down.x - up.x, down.y - up.y)).toBeGreaterThan(22);
    for (const key of Object.keys(layout.detours)) {
      const [from, to] = key.split(">") as [keyof typeof kStateLooks, keyof typeof kStateLooks];
      const { label } = curveOf(layout, from, to);
      expect(label.x).toBeGreaterThan(11);
      expect(label.x).toBeLessThan(layout.width - 11);
    }
  });
});

describe("the layout", () => {
  it("is that of the machine and of the window", () => {
    const plain: DriveState[] = ["Switch on disabled", "Operation enabled", "Fault"];
    expect([layoutOf(plain, false), layoutOf(plain, true)]).toEqual([kWideCia402, kNarrowCia402]);
    expect([layoutOf([...plain, "OFF1 braking"], false), layoutOf([...plain, "OFF1 braking"], true)]).toEqual([kWide, kNarrow]);
  });
});

describe("border of a box", () => {
  it("is met at the nearer side", () => {
    expect(borderPoint({ width: 100, height: 40 }, { x: 0, y: 0 }, { x: 200, y: 0 })).toEqual({ x: 50, y: 0 });
    expect(borderPoint({ width: 100, height: 40 }, { x: 0, y: 0 }, { x: 0, y: -90 })).toEqual({ x: 0, y: -20 });
  });
});
