import { describe, expect, it } from "vitest";

import { readLink, writeLink, type ScopeLink } from "../../../src/scope/view/link";

function read(text: string) {
  return readLink(new URLSearchParams(text));
}

describe("the link of a view", () => {
  it("is read as it was written", () => {
    const link: ScopeLink = {
      signals: ["1/speed", "1/r0899.2", "1/r0949[3]"],
      periodMs: 1,
      span: 0.25,
      to: 12.345678,
      isPaused: true,
      a: -1.5,
      b: 3,
      result: 4,
      recording: "fault-1.axrec",
      fault: { place: "infeed", number: 7900 },
    };
    expect(readLink(new URLSearchParams(writeLink(link).toString()))).toEqual({ link, wrong: [] });
  });

  it("keeps that no signal is shown", () => {
    expect(read(writeLink({ signals: [] }).toString()).link).toEqual({ signals: [] });
  });

  it("takes a fault of an axis", () => {
    expect(read("fault=1.7900").link.fault).toEqual({ place: 1, number: 7900 });
  });

  it.each([
    "span=0",
    "span=1e9",
    "span=ten",
    "to=12s",
    "to=Infinity",
    "period=3",
    "signals=1/speed,1/speed",
    "signals=<b>",
    "signals=1,2,3,4,5,6,7,8,9",
    "result=0",
    "result=1.5",
    "fault=1",
    "fault=12.7900",
    "fault=1.F07900",
    "recording=../x",
    "paused=0",
    "zoom=1",
  ])("refuses %s and names it", (text) => {
    const { link, wrong } = read(`a=1&${text}`);
    expect(link).toEqual({ a: 1 });
    expect(wrong).toHaveLength(1);
  });
});
