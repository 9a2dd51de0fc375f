import { describe, expect, it } from "vitest";

import { kFirstForm, kTriggers, traceRequest, type TraceForm } from "../../../src/scope/data/trace_request";

function form(changes: Partial<TraceForm>): TraceForm {
  return { ...kFirstForm, ...changes };
}

describe("the form of a trace", () => {
  it("asks for what is typed", () => {
    const typed = { signal: "1/speed", level: "-12.5" };
    expect(traceRequest(form({ on: "rising", typed, every: "0.001", before: "0.25", length: "2" }), ["1/speed", "1/torque"])).toEqual({
      signals: ["1/speed", "1/torque"],
      every: 0.001,
      trigger: { on: "rising", signal: "1/speed", level: -12.5 },
      before_s: 0.25,
      length_s: 2,
    });
  });

  it("takes only fields of the kind, and leaves empty ones out", () => {
    const typed = { number: "F07900", axis: "1", level: "3" };
    expect(traceRequest(form({ on: "fault", typed, every: "cycle" }), ["1/speed"])).toMatchObject({
      every: "cycle",
      trigger: { on: "fault", number: 7900, axis: 1 },
    });
    expect(traceRequest(form({ on: "fault" }), ["1/speed"]).trigger).toEqual({ on: "fault" });
  });

  it("repeats and keeps several if wanted", () => {
    expect(traceRequest(form({ isRepeated: true }), ["1/speed"])).toMatchObject({ repeat: true, keep: 8 });
  });

  it.each<[Partial<TraceForm>, RegExp]>([
    [{ every: "0.0001" }, /Every/],
    [{ every: "0.0002" }, /Every.*multiple/],
    [{ before: "2", length: "1" }, /Before/],
    [{ length: "" }, /Length/],
    [{ on: "rising", typed: { signal: "1/speed", level: "x" } }, /Level/],
    [{ on: "rising", typed: { level: "3" } }, /Signal/],
    [{ on: "fault", typed: { number: "zero" } }, /Number/],
    [{ on: "bits", typed: { signal: "1/r0899", value: "xyz" } }, /Value/],
    [{ on: "state" }, /State/],
  ])("names the field that is wrong: %j", (changes, words) => {
    expect(() => traceRequest(form(changes), ["1/speed"])).toThrow(words);
  });

  it("needs a signal", () => {
    expect(() => traceRequest(kFirstForm, [])).toThrow(/Signals/);
  });

  it("has every kind of trigger once", () => {
    const kinds = kTriggers.map(({ on }) => on);
    expect(kinds).toEqual([...new Set(kinds)]);
    expect(kinds).toHaveLength(13);
  });
});
