import { describe, expect, it } from "vitest";

import { bitRows, keyOf, neighboursOf, wiringOf } from "../../../src/parameters/detail/wiring";
import { entry, kInput, kWord } from "./samples";

const kNone = new Map();

describe("the wiring", () => {
  it("of an output has its users on the right, of other places with their names", () => {
    const known = new Map([[keyOf(1, "p2549"), kInput]]);
    const wiring = wiringOf(kWord, known);
    expect(wiring?.nodes.map((node) => [node.title, node.column])).toEqual([
      ["r0899", 1],
      ["p2549", 2],
      ["p0840, Axis 2", 2],
    ]);
    expect(wiring?.edges).toEqual([
      { from: 0, to: 1, label: "bit 2" },
      { from: 0, to: 2, label: "" },
    ]);
    expect(wiring?.nodes[1]?.target).toEqual({ place: 1, name: "p2549" });
  });

  it("of a bit has only the users of that bit", () => {
    expect(wiringOf({ ...kWord, parameter: "r0899.3", bit: 3 }, kNone)?.nodes).toHaveLength(1);
    expect(wiringOf({ ...kWord, parameter: "r0899.2", bit: 2 }, kNone)?.nodes).toHaveLength(3);
  });

  it("of an input has its source on the left, and the others at the same source below", () => {
    const known = new Map([[keyOf(1, "r0899.2"), { ...kWord, parameter: "r0899.2", bit: 2 }]]);
    const wiring = wiringOf(kInput, known);
    expect(wiring?.nodes.map((node) => [node.title, node.column, node.row])).toEqual([
      ["p2549", 1, 0],
      ["r0899.2", 0, 0],
      ["p0840, Axis 2", 1, 1],
    ]);
    expect(wiring?.edges[0]).toEqual({ from: 1, to: 0, label: "bit 2" });
    expect(wiring?.nodes[1]?.value).toBe("1");
  });

  it("of an input without a source is a constant", () => {
    const wiring = wiringOf(entry({ type: "BI", value: "1" }), kNone);
    expect(wiring?.nodes.map((node) => node.title)).toEqual(["p1120", "1"]);
    expect(wiring?.nodes[1]?.target).toBeUndefined();
  });

  it("says how many users are not drawn, and that there is none", () => {
    expect(wiringOf({ ...kWord, uses: 15 }, kNone)?.remark).toBe("13 more inputs use it than are drawn.");
    expect(wiringOf({ ...kWord, uses: 0, used_by: [] }, kNone)?.remark).toBe("No input uses it.");
  });

  it("is none of a parameter that is neither", () => {
    expect(wiringOf(entry({}), kNone)).toBeUndefined();
    expect(neighboursOf(entry({}))).toEqual([]);
  });

  it("has bits with their users", () => {
    const bits = bitRows(kWord, 16);
    expect(bits.filter((bit) => bit.isSet).map((bit) => bit.bit)).toEqual([2, 6, 7, 9]);
    expect(bits[2]?.users).toHaveLength(2);
  });
});
