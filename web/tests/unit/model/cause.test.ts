import { describe, expect, it } from "vitest";

import { Decoder } from "../../../src/canopen/decode";
import { parseEds } from "../../../src/canopen/eds";
import { ServiceMap } from "../../../src/canopen/services";
import { causeOfState, storyOfFault, type Past } from "../../../src/model/cause";
import { FrameStore } from "../../../src/model/frame_store";
import { openFile } from "../../../src/recording/open_file";
import type { UnitEvent } from "../../../src/source/types";
import { dataFile, frameOf, projectText } from "../data/files";

const kEds = parseEds(projectText("eds/axisd.eds"));
const kServices = new ServiceMap({ nodeId: 5, eds: kEds });

function pastOf(events: UnitEvent[], frames: FrameStore, pdos?: never[]): Past {
  return { events, frames, decoder: new Decoder({ services: kServices, eds: kEds, pdos, events: () => events }) };
}
function storeOf(...frames: [number, string, boolean?][]): FrameStore {
  const store = new FrameStore(kServices.laneOf);
  for (const [t, text, sent] of frames) store.append(frameOf(text, t, sent));
  return store;
}
function state(t: number, before: string, now: string): UnitEvent {
  return { t, kind: "drive-state", axis: 1, drive_object: 2, before, state: now };
}

describe("a recorded run", () => {
  const run = openFile("run.axrec", dataFile("run.axrec"));
  const past = pastOf(run.events, run.frames);
  const states = run.events.filter((event) => event.kind === "drive-state");
  const cause = (place: number) => causeOfState(states[place] as UnitEvent, past);

  it("names the controlword of each change of state, with its bits and its frame", () => {
    expect(cause(0).text).toMatch(/^Controlword 0x0006 \(Shutdown \(OFF1\)\) in RPDO 1 \(205\), 0\.\d+\u2009ms before\.$/);
    expect(cause(1).text).toContain("Controlword 0x0006 → 0x0007 (Switch on) in RPDO 1 (205)");
    expect(cause(1).text).toContain("bit 0 Switch on (ON/OFF1): 0 → 1");
    expect(cause(2).controlword).toMatchObject({ before: 7, now: 15 });
    expect(run.frames.frame(cause(2).pointer?.frame ?? -1)).toMatchObject({ id: 0x205 });
  });

  it("names the fault of a state of faults", () => {
    expect(states[3]?.state).toBe("Fault");
    expect(cause(3)).toMatchObject({ text: "Fault F07860 External fault 1 of axis 1.", pointer: { event: { kind: "fault" } } });
  });

  it("knows an acknowledgement, an SDO download, and a standstill", () => {
    expect(cause(4).text).toContain("→ 0x0080 (Disable voltage (OFF2), fault reset) in RPDO 1");
    expect(cause(7).text).toContain("0x0007 → 0x000F (Enable operation) in an SDO download (605)");
    expect(cause(8).text).toContain("0x000F → 0x0006 (Shutdown (OFF1))");
    expect(cause(9).text).toMatch(/^The drive has come to a standstill by itself, 24\u2009ms after OFF1 braking began\.$/);
    expect(cause(9).pointer?.event?.state).toBe("OFF1 braking");
  });

  it("knows the command of a change of the NMT state", () => {
    const nmt = run.events.find((event) => event.kind === "nmt") as UnitEvent;
    expect(causeOfState(nmt, past).text).toBe("NMT command: Start remote node, node 5.");
  });

  it("tells what the unit did after a fault", () => {
    const fault = run.events.find((event) => event.kind === "fault") as UnitEvent;
    const story = storyOfFault(fault, past);
    expect(story).toMatchObject({ title: "F07860 External fault 1", value: "fault value 3 (0x3)" });
    expect(story.reaction.map(({ text }) => text)).toEqual([
      "EMCY: 0x1000 generic error: F07860 External fault 1",
      "drive state of axis 1: Operation enabled → Fault",
      "EMCY: no error is left",
      "F07860 External fault 1 of axis 1 has gone",
      "drive state of axis 1: Fault → Switch on disabled",
    ]);
    expect(story.reaction[0]?.frame).toBeDefined();
    expect(story.reaction.at(-1)?.after).toBeCloseTo(0.683, 2);
  });
});

describe("the cause of a state", () => {
  it("is a write over the control socket", () => {
    const event = state(2, "Switched on", "Operation enabled");
    const write: UnitEvent = { t: 1.999, kind: "object", object: "6040:00", by: "control", value: 15, before: 7 };
    const { text, controlword } = causeOfState(event, pastOf([write, event], storeOf([1, "205#0700"])));
    expect(text).toContain("Controlword 0x0007 → 0x000F (Enable operation) in a write over the control socket, 1\u2009ms before");
    expect(controlword?.changed).toHaveLength(1);
  });

  it("is no controlword that was too early, or that says something else", () => {
    const event = state(2, "Switched on", "Operation enabled");
    expect(causeOfState(event, pastOf([event], storeOf([1, "205#0700"], [1.5, "205#0F00"]))).text).toBe(
      "By itself: no controlword has changed within the last cycles.",
    );
    expect(causeOfState(event, pastOf([event], storeOf([1, "205#0700"], [1.999, "205#0600"]))).pointer).toBeUndefined();
  });

  it("is the first of equal controlwords", () => {
    const event = state(2, "Switched on", "Operation enabled");
    const past = pastOf([event], storeOf([1, "205#0700"], [1.99, "205#0F00"], [1.998, "305#0F0000000000"]));
    expect(causeOfState(event, past).pointer?.frame).toBe(1);
  });

  it("is what a panel did", () => {
    const event = state(2, "Switched on", "Operation enabled");
    const panel = { t: 1.98, kind: "control", method: "panel.set", text: "axis=1 on=true", axis: 1, by: "control" } as unknown as UnitEvent;
    expect(causeOfState(event, pastOf([panel, event], storeOf())).text).toBe(
      "Just before: panel.set axis=1 on=true of axis 1 over the control socket.",
    );
  });

  it("is not the NMT command to another node", () => {
    const event: UnitEvent = { t: 2, kind: "nmt", state: "Stopped", before: "Operational" };
    const link: UnitEvent = { t: 1.99, kind: "link", up: false };
    expect(causeOfState(event, pastOf([event], storeOf([1.999, "000#0206"]))).text).toBe("By itself: no NMT command was received.");
    expect(causeOfState(event, pastOf([link, event], storeOf())).text).toBe(
      "Without an NMT command; just before: the bus cannot be used any more.",
    );
  });
});

describe("the cause of a fault", () => {
  const fault = (t: number, number: number): UnitEvent => ({ t, kind: "fault", axis: 1, number, name: `F0${number}`, text: "x", value: 0, active: true });
  const act = (t: number, method: string, text: string, axis?: number) => ({ t, kind: "control", method, text, by: "control", ...(axis === undefined ? {} : { axis }) }) as unknown as UnitEvent;

  it("is what was done to the unit for it, not what is the nearest", () => {
    const event = fault(5, 7860);
    const past = pastOf([act(1, "load.set", "axis=1 torque_Nm=8"), act(4.9, "fault.inject", "axis=1 number=7860"), act(4.99, "load.set", "axis=1"), event], storeOf());
    const { causes } = storyOfFault(event, past);
    expect(causes.map(({ text }) => text)).toEqual([
      "fault.inject axis=1 number=7860 over the control socket",
      "load.set axis=1 over the control socket",
      "load.set axis=1 torque_Nm=8 over the control socket",
    ]);
    expect(causes[0]?.after).toBeCloseTo(-0.1);
  });

  it("is the load of a blocked motor, the supply of a DC link, the NMT state of the bus", () => {
    const first = (number: number, ...events: UnitEvent[]) => storyOfFault(fault(5, number), pastOf([...events, fault(5, number)], storeOf())).causes[0]?.text;
    const load = act(4, "load.set", "axis=1", 1);
    const supply = act(3.5, "supply.set", "line_V=0");
    const nmt: UnitEvent = { t: 4, kind: "nmt", state: "Stopped", before: "Operational" };
    expect(first(7900, supply, load)).toContain("load.set");
    expect(first(30003, supply, load)).toContain("supply.set");
    expect(first(8701, load, nmt)).toBe("NMT state Operational → Stopped");
  });

  it("is nothing that is too long ago, of another axis, or later", () => {
    const other = { ...fault(4.9, 7900), axis: 2 };
    const past = pastOf([act(-20, "load.set", "axis=1"), other, fault(5, 7860), act(5.1, "load.set", "")], storeOf());
    expect(storyOfFault(fault(5, 7860), past).causes).toEqual([]);
  });
});
