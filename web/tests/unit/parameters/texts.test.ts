import { describe, expect, it } from "vitest";

import { suggestionsOf } from "../../../src/parameters/detail/bico";
import { filterOf, holds } from "../../../src/parameters/text/filters";
import { parsedName, parsedPlaced, placedText, placeWords, withoutBit } from "../../../src/parameters/text/names";
import { refusalLines } from "../../../src/parameters/text/refusal_text";
import { finds, searchedText } from "../../../src/parameters/text/search_text";
import { bitsOf, parametersCsv, rangeText, valueText, whenWords } from "../../../src/parameters/text/value_text";
import { Refusal } from "../../../src/source/refusal";
import { entry, kInput, kWord } from "./samples";

describe("names", () => {
  it("have number, index and bit", () => {
    expect(parsedName("p1120")).toEqual({ base: "p1120" });
    expect(parsedName(" P1070[1] ")).toEqual({ base: "p1070", index: 1 });
    expect(parsedName("r0722.3")).toEqual({ base: "r0722", bit: 3 });
    expect(parsedName("ramp")).toBeUndefined();
    expect(withoutBit("r0722.3")).toBe("r0722");
    expect(withoutBit("p1070[1]")).toBe("p1070[1]");
  });

  it("are placed in an address and read back", () => {
    for (const place of [0, 3, "infeed"] as const) {
      expect(parsedPlaced(placedText({ place, name: "p0840" }))).toEqual({ place, name: "p0840" });
    }
    expect(parsedPlaced("none")).toBeUndefined();
    expect(parsedPlaced(null)).toBeUndefined();
    expect([0, 2, "infeed"].map(placeWords)).toEqual(["Control unit", "Axis 2", "Infeed"]);
  });
});

describe("search", () => {
  it("finds the beginning of a number, with or without letter and zeros", () => {
    for (const text of ["899", "0899", "r0899", "r08", "R0899.2", ""]) expect(finds(text, kWord), text).toBe(true);
    for (const text of ["p0899", "99", "r0898"]) expect(finds(text, kWord), text).toBe(false);
  });

  it("finds words that all occur in name or effect", () => {
    expect(finds("WORD status", kWord)).toBe(true);
    expect(finds("ramp p1082", entry({}))).toBe(true);
    expect(finds("ramp word", entry({}))).toBe(false);
  });

  it("leaves index and bit away", () => {
    expect(searchedText("p1070[1]")).toBe("p1070");
    expect(searchedText(" ramp time ")).toBe("ramp time");
  });
});

describe("filters", () => {
  it("say of an entry what the unit would", () => {
    expect(holds("outputs", kWord)).toBe(true);
    expect(holds("inputs", kWord)).toBe(false);
    expect(holds("inputs", kInput)).toBe(true);
    expect(holds("changed", entry({ differs_from_factory: true }))).toBe(true);
    expect(holds("unsaved", entry({}))).toBe(false);
    expect(filterOf("changed")).toBe("changed");
    expect(filterOf("nothing")).toBe("all");
  });
});

describe("values", () => {
  it("have the digits of a F32", () => {
    expect(valueText(0.10000000149)).toBe("0.1");
    expect(valueText(4294967295)).toBe("4294967295");
    expect(valueText("r0899.2")).toBe("r0899.2");
    expect(rangeText(0, 999999)).toBe("0 … 999999");
    expect(rangeText(undefined, undefined)).toBe("");
  });

  it("are written when the words say", () => {
    expect(whenWords("U, T")).toBe("while the motor runs, with the pulses off");
    expect(whenWords("C(1,3)")).toBe("in commissioning (p0010 or p0009 = 1, 3)");
    expect(whenWords(undefined)).toBe("never: read-only");
  });

  it("have bits up to the 32nd", () => {
    expect(bitsOf(0x80000001, 32).flatMap((isSet, bit) => (isSet ? [bit] : []))).toEqual([0, 31]);
  });

  it("stand in CSV with all fields", () => {
    const [head, line] = parametersCsv([entry({ effect: 'acts, "now"' })]).split("\n");
    expect(head).toMatch(/^place,parameter,number,/);
    expect(line).toBe('1,p1120,1120,0,RFG ramp-up time,10,s,,,,,F32,read-write,,"acts, ""now"""');
  });
});

describe("sources of BICO inputs", () => {
  it("are bits of words for a binector input, of other drive objects by their number", () => {
    expect(suggestionsOf([kWord], "BI", 2, "r0899.1")).toEqual([
      "0", "1", "r0899.1", "r0899.10", "r0899.11", "r0899.12", "r0899.13", "r0899.14", "r0899.15",
    ]);
    expect(suggestionsOf([kWord], "BI", 3, "r0899.15")).toContain("r0899.15 of drive object 2");
  });

  it("are whole outputs for a connector input, and never what is no output", () => {
    expect(suggestionsOf([kWord, entry({})], "CI", 2, "r0899")).toEqual(["0", "r0899"]);
  });
});

describe("a refusal", () => {
  it("tells limits and abort code", () => {
    const details = {
      limits: { minimum: 0, maximum: 10, unit: "s" },
      abort_code: 0x06090032,
      abort_text: "value too low",
    };
    expect(refusalLines(new Refusal("out-of-range", "p1121: below the minimum", 422, details))).toEqual([
      "p1121: below the minimum.",
      "It takes 0 … 10\u2009s.",
      "SDO abort code 06090032h: value too low.",
    ]);
  });

  it("tells when the parameter can be written", () => {
    const refusal = new Refusal("read-only", "p0300: not now", 409, { when: "C(1,3)" });
    expect(refusalLines(refusal)[1]).toBe("It can be written in commissioning (p0010 or p0009 = 1, 3).");
  });
});
