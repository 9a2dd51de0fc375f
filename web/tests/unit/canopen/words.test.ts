import { describe, expect, it } from "vitest";

import { valueText } from "../../../src/canopen/value";
import { changedBits, changeText, commandOf, controlwordBits, stateOf, statuswordBits } from "../../../src/canopen/words";
import { projectText } from "../data/files";

describe("words of CiA 402", () => {
  it.each([
    [0x0000, "Disable voltage (OFF2)"],
    [0x0002, "Quick stop (OFF3)"],
    [0x0006, "Shutdown (OFF1)"],
    [0x0007, "Switch on"],
    [0x000f, "Enable operation"],
    [0x0086, "Shutdown (OFF1), fault reset"],
    [0x010f, "Enable operation, halt"],
  ])("names the command in %i", (word, text) => {
    expect(commandOf(word)).toBe(text);
  });

  it.each([
    [0x1640, "Switch on disabled"],
    [0x1631, "Ready to switch on"],
    [0x1633, "Switched on"],
    [0x1637, "Operation enabled"],
    [0x0617, "Quick stop active"],
    [0x063f, "Fault reaction active"],
    [0x0638, "Fault"],
    [0x0000, "Not ready to switch on"],
  ])("names the state in %i", (word, text) => {
    expect(stateOf(word)).toBe(text);
  });

  it("says which bits have changed", () => {
    expect(changedBits(0x0006, 0x0007).map(changeText)).toEqual(["bit 0 Switch on (ON/OFF1): 0 → 1"]);
    expect(changedBits(0x000f, 0x0006).map((row) => [row.bit, row.value])).toEqual([["0", 0], ["3", 0]]);
    expect(controlwordBits(0).concat(statuswordBits(0))).toHaveLength(32);
  });

  it("has a name for each state of the drive", () => {
    const page = projectText("docs/reference/sequence-control.md");
    for (const word of [0x40, 0x21, 0x23, 0x27, 0x07, 0x0f, 0x08]) expect(page).toContain(`| ${stateOf(word)} |`);
  });
});

describe("values of objects", () => {
  const bytes = (...values: number[]) => Uint8Array.from(values);
  it.each([
    [0x03, bytes(0xfe, 0xff), "-2"],
    [0x06, bytes(0x0f, 0x00), "15 (0xF)"],
    [0x09, bytes(0x41, 0x42, 0), '"AB"'],
    [0x08, bytes(0, 0, 0x80, 0x3f), "1"],
    [0x15, bytes(255, 255, 255, 255, 255, 255, 255, 255), "-1"],
    [0x1b, bytes(255, 255, 255, 255, 255, 255, 255, 255), "18446744073709551615 (0xFFFFFFFFFFFFFFFF)"],
    [0x0f, bytes(1, 2, 0xab), "01 02 AB"],
    [0x07, bytes(1), "01 (too short for UNSIGNED32)"],
    [0, bytes(1, 2), "513 (0x201)"],
    [5, bytes(), "no bytes"],
  ])("type %i", (type, data, text) => {
    expect(valueText(data, type)).toBe(text);
  });
});
