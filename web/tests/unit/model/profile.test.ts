import { describe, expect, it } from "vitest";

import { ServiceMap } from "../../../src/canopen/services";
import { Decoder } from "../../../src/canopen/decode";
import { causeOfState } from "../../../src/model/cause";
import { FrameStore } from "../../../src/model/frame_store";
import { hasParameters, profileAt, profileOf } from "../../../src/model/profile";
import { moversOf } from "../../../src/model/story/transitions";
import { RecordedSource } from "../../../src/source/recorded_source";
import type { UnitEvent } from "../../../src/source/types";
import { indexFor, wordsFor } from "../../../src/hands/drive_orders";
import { frameOf } from "../data/files";

describe("the profile of a unit", () => {
  it("is that of the drive unit where nothing is said", () => {
    expect([undefined, {}, { profile: "s120" }, { profile: "other" }].map(profileOf)).toEqual(["s120", "s120", "s120", "s120"]);
    expect(profileOf({ profile: "cia402" })).toBe("cia402");
    expect([hasParameters("s120"), hasParameters("cia402")]).toEqual([true, false]);
  });

  it("stands in the recorded state of a unit", async () => {
    const unitOf = (unit: string, status: object) => ({ unit, resources: { "": status }, recordings: [] });
    const units = [unitOf("vcan0/5", { node_id: 5, profile: "cia402" }), unitOf("vcan0/6", { node_id: 6 })];
    const source = new RecordedSource({ format: "axisd-session", version: 1, title: "", made_by: "", made_at: "", units });
    expect(await profileAt(source, "vcan0/5")).toBe("cia402");
    expect(await profileAt(source, "vcan0/6")).toBeUndefined();
    expect(await profileAt(source, "vcan0/7")).toBeUndefined();
  });
});

describe("transitions of a CiA 402 axis", () => {
  it("are those of CiA 402", () => {
    expect(moversOf("Quick stop active", "Operation enabled", "cia402")).toEqual(["enable-operation"]);
    expect(moversOf("Quick stop active", "Operation enabled")).toEqual([]);
    expect(moversOf("Operation enabled", "OFF1 braking", "cia402")).toEqual([]);
  });

  it("are told without the words of the drive unit", () => {
    const services = new ServiceMap({ nodeId: 5 });
    const frames = new FrameStore(services.laneOf);
    for (const [t, text] of [[0.9, "605#2B40600007000000"], [1, "605#2B40600006000000"]] as const) frames.append(frameOf(text, t));
    const past = (profile: "cia402" | "s120") => ({ events: [], frames, decoder: new Decoder({ services, profile }) });
    const event: UnitEvent = { t: 1.001, kind: "drive-state", axis: 1, before: "Switched on", state: "Ready to switch on" };
    expect(causeOfState(event, past("cia402")).text).toContain("0x0007 → 0x0006 (Shutdown) in an SDO download");
    expect(causeOfState(event, past("cia402")).text).toContain("bit 0 Switch on: 1 → 0");
    expect(causeOfState(event, past("s120")).text).toContain("bit 0 Switch on (ON/OFF1): 1 → 0");
    const lost: UnitEvent = { t: 9, kind: "drive-state", axis: 1, before: "Operation enabled", state: "Switch on disabled" };
    expect(causeOfState(lost, past("cia402")).text).toContain("The DC link has lost its voltage.");
  });
});

describe("orders by hand", () => {
  it("reach the objects of the axis", () => {
    expect([indexFor(0x6040, 1), indexFor(0x6040, 2), indexFor(0x6060, 8)]).toEqual(["6040", "6840", "9860"]);
  });
  it("raise bit 7 for a reset in Fault, and touch nothing else elsewhere", () => {
    expect(wordsFor(0x80, "Fault")).toEqual([0, 0x80]);
    expect(wordsFor(0x80, "Operation enabled")).toEqual([0x80]);
    expect(wordsFor(0x0f, "Fault")).toEqual([0x0f]);
  });
});
