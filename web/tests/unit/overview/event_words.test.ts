import { describe, expect, it } from "vitest";

import { eventLook, eventWords, originWords, placeWords, withoutRepeats } from "../../../src/overview/event_words";
import type { UnitEvent } from "../../../src/source/types";

function event(members: Partial<UnitEvent> & { kind: UnitEvent["kind"] }): UnitEvent {
  return { t: 1, ...members };
}

describe("words of an event", () => {
  it("names both states of a change", () => {
    expect(eventWords(event({ kind: "drive-state", before: "Switched on", state: "Operation enabled" }))).toBe("Switched on → Operation enabled");
  });
  it("shows a controlword in hexadecimal digits, another object as it is", () => {
    expect(eventWords(event({ kind: "object", object: "6040:00", value: 15, before: 7 }))).toBe("6040:00 = 000Fh, was 0007h");
    expect(eventWords(event({ kind: "object", object: "6083:00", value: 100 }))).toBe("6083:00 = 100");
  });
  it("tells a fault's value and that it has gone", () => {
    expect(eventWords(event({ kind: "fault", name: "F07900", text: "Motor blocked", value: 2, active: true }))).toBe("F07900 Motor blocked (value 2)");
    expect(eventWords(event({ kind: "fault", name: "F07900", text: "Motor blocked", value: 0, active: false }))).toBe("F07900 Motor blocked has gone");
  });
  it("names the abort code of a refusal", () => {
    const refusal = event({ kind: "refusal", object: "6083:00", abort_code: "0x06090031", text: "too high", by: "sdo", server: 0 });
    expect(eventWords(refusal)).toBe("write of 6083:00 refused with 0x06090031: too high");
  });
  it("has words for kinds of later versions", () => {
    expect(eventWords(event({ kind: "moon" as "power", text: "full" }))).toBe("full");
    expect(eventLook(event({ kind: "moon" as "power" })).title).toBe("moon");
  });
});

describe("where and by whom", () => {
  it("names places", () => {
    expect(placeWords(event({ kind: "fault", axis: 0 }))).toBe("control unit");
    expect(placeWords(event({ kind: "fault", axis: 2 }))).toBe("axis 2");
    expect(placeWords(event({ kind: "power" }))).toBe("");
  });
  it("names who has acted", () => {
    expect(originWords(event({ kind: "parameter", by: "sdo", server: 1 }))).toBe("SDO 2");
    expect(originWords(event({ kind: "parameter", by: "control" }))).toBe("control socket");
    expect(originWords(event({ kind: "drive-state" }))).toBe("unit");
  });
});

describe("look of an event", () => {
  it("has the tone of the state that was reached, and is quiet for what has gone", () => {
    expect(eventLook(event({ kind: "drive-state", state: "Fault" })).tone).toBe("fault");
    expect(eventLook(event({ kind: "alarm", active: false })).tone).toBe("off");
  });
});

describe("repeats", () => {
  it("of an operator panel that renews its command are told once", () => {
    const set = (t: number, text: string): UnitEvent => ({ t, kind: "control", unit: "vcan0/5", method: "panel.set", text });
    const state = event({ kind: "drive-state", state: "Switched on" });
    const events = [set(1, "on false"), set(2, "on false"), state, set(3, "on true"), set(4, "on true"), set(5, "on false")];
    expect(withoutRepeats(events).map((each) => each.t)).toEqual([1, 1, 3, 5]);
  });
});
