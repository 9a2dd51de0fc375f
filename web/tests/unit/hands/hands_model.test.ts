import { describe, expect, it } from "vitest";

import { bodyOf, faultWords, fieldsOf, missingOf } from "../../../src/hands/faults/wire_form";
import { Journal } from "../../../src/hands/journal";
import { numberIn } from "../../../src/hands/number_text";
import { scaleEnd } from "../../../src/hands/panel/meters";
import { refusalLines } from "../../../src/hands/refusal_lines";
import { Refusal } from "../../../src/source/refusal";
import type { InjectKind } from "../../../src/source/types";

const kLate: InjectKind = {
  kind: "sdo.late", nature: "each", event: "sdo-response", summary: "the answer comes late",
  arguments: [
    { key: "delay_ms", expected: "a whole number", summary: "how late", required: true },
    { key: "object", expected: "a number", summary: "index", required: false, absent: "every object" },
  ],
};

describe("form of a fault on the wire", () => {
  it("has the arguments of its kind and when it acts", () => {
    expect(fieldsOf(kLate).own.map((field) => field.absent)).toEqual(["", "every object"]);
    expect(fieldsOf(kLate).when.map((field) => field.key)).toContain("times");
  });
  it("sends numbers as numbers, the rest as text, and leaves out what is empty", () => {
    const texts = { delay_ms: "500", object: "0x6040", step: " ", until: "10 heartbeat", probability: "0.5" };
    expect(bodyOf("sdo.late", texts)).toEqual({ kind: "sdo.late", delay_ms: 500, object: "0x6040", until: "10 heartbeat", probability: 0.5 });
  });
  it("knows what is missing", () => {
    expect(missingOf(kLate, { delay_ms: " " })).toEqual(["delay_ms"]);
    expect(missingOf(kLate, { delay_ms: "1" })).toEqual([]);
  });
  it("shows a fault as it was given", () => {
    expect(faultWords({ kind: "sdo.late", delay_ms: 500, object: "0x6040" })).toBe("delay_ms 500, object 0x6040");
  });
});

describe("journal", () => {
  it("tells what came of each action", async () => {
    const journal = new Journal();
    await journal.run("Acknowledge", () => Promise.resolve());
    await expect(journal.run("Load 1 N·m", () => Promise.reject(new Error("no such axis")))).rejects.toThrow();
    void journal.run("Slow", () => new Promise(() => undefined));
    expect(journal.entries.value.map(({ words, outcome, text }) => [words, outcome, text])).toEqual([
      ["Acknowledge", "done", ""],
      ["Load 1 N·m", "refused", "no such axis"],
      ["Slow", "waiting", ""],
    ]);
  });
  it("has an end", async () => {
    const journal = new Journal();
    for (let i = 0; i < 150; i++) await journal.run(String(i), () => Promise.resolve());
    expect(journal.entries.value.length).toBe(100);
    expect(journal.entries.value.at(-1)?.words).toBe("149");
  });
});

describe("numbers and refusals", () => {
  it("reads what people type", () => {
    expect(["1.5", "1,5", " -3 ", "1e3"].map(numberIn)).toEqual([1.5, 1.5, -3, 1000]);
    expect(["", "x", "1.5x", "Infinity"].map(numberIn)).toEqual([undefined, undefined, undefined, undefined]);
  });
  it("says the limits behind the message", () => {
    expect(refusalLines(new Refusal("out-of-range", "line_voltage_V: 2000 is no voltage", 422, { limits: { low: 0, high: 1000 } }))).toEqual([
      "line_voltage_V: 2000 is no voltage.",
      "It takes 0 to 1000.",
    ]);
    expect(refusalLines(new Error("off."))).toEqual(["off."]);
  });
  it("has round ends of scales", () => {
    expect([0, 1, 3, 7, 12, 4200].map(scaleEnd)).toEqual([1, 1, 5, 10, 20, 5000]);
  });
});
