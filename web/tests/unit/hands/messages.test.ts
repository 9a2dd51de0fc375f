import { readFileSync } from "node:fs";

import { describe, expect, it } from "vitest";

import { findMessages, numberOf } from "../../../src/hands/faults/message_search";
import { kMessages } from "../../../src/hands/faults/messages";

const kPlaces: Record<string, string> = { Axis: "axis", ControlUnit: "unit", Both: "both" };

/** The rows of the unit's own table. */
function rowsOfUnit(): string[][] {
  const text = readFileSync(new URL("../../../../drive/messages/fault_table.cpp", import.meta.url), "utf8");
  const row = /FaultRow\{(\d+), Kind::(\w)\w+, Scope::(\w+),[^"]*"([^"]*)", "([^"]*)"\}/g;
  return [...text.matchAll(row)].map(([, number = "", kind = "", scope = "", name = "", cause = ""]) => [
    `${kind}${number.padStart(5, "0")}`,
    kPlaces[scope] ?? scope,
    name,
    cause,
  ]);
}

describe("faults and alarms", () => {
  it("are those of the unit", () => {
    expect(kMessages).toEqual(rowsOfUnit());
  });
  it("are found by number, code and words", () => {
    expect(findMessages("7860", 1, 5).map((row) => row[0])).toContain("F07860");
    expect(findMessages("f07860", 1, 5).map((row) => row[0])).toEqual(["F07860"]);
    expect(findMessages("motor overtemp", 1, 5).map((row) => row[0])).toContain("F07011");
    expect(findMessages("motor moon", 1, 5)).toEqual([]);
  });
  it("are those of the place", () => {
    expect(findMessages("internal software", 1, 5)).toEqual([]);
    expect(findMessages("internal software", 0, 5).length).toBeGreaterThan(0);
  });
  it("have a number in three spellings", () => {
    expect(["7860", "F7860", "a07850", " F07860 "].map(numberOf)).toEqual([7860, 7860, 7850, 7860]);
    expect(["", "F", "motor", "7860x", "123456"].map(numberOf)).toEqual([undefined, undefined, undefined, undefined, undefined]);
  });
});
