import { describe, expect, it } from "vitest";

import { edsEntry, parentName, parsedEds } from "../../../src/objects/eds";
import { findsObject, hexText, objectHolds, objectsCsv, objectText, parsedObject, searchedObject } from "../../../src/objects/object_text";
import { Objects } from "../../../src/objects/object_source";
import { Refusal } from "../../../src/source/refusal";
import type { Source } from "../../../src/source/source";
import type { ObjectEntry } from "../../../src/source/types";

function object(over: Partial<ObjectEntry>): ObjectEntry {
  const usual = { object: "6040h:00", index: 0x6040, sub_index: 0, name: "Controlword", type: "UNSIGNED16" };
  return { ...usual, access: "rww", mappable: true, ...over };
}

describe("objects", () => {
  it("are named in hexadecimal", () => {
    for (const text of ["6040", "6040h", "0x6040", "6040:0"]) expect(parsedObject(text), text).toEqual({ index: 0x6040, sub: 0 });
    expect(parsedObject("1018:0A")).toEqual({ index: 0x1018, sub: 10 });
    expect(parsedObject("velocity")).toBeUndefined();
    expect(objectText({ index: 0x60ff, sub: 2 })).toBe("60FF:02");
    expect(hexText(15, "UNSIGNED16")).toBe("000Fh");
    expect(hexText(-1, "INTEGER16")).toBe("");
  });

  it("are found by index and name", () => {
    expect(findsObject("60", object({}))).toBe(true);
    expect(findsObject("6040:00", object({}))).toBe(true);
    expect(findsObject("CONTROL", object({}))).toBe(true);
    expect(findsObject("status", object({}))).toBe(false);
    expect(searchedObject("0x60")).toBe("60");
  });

  it("are filtered by access and mapping", () => {
    expect(objectHolds("writable", object({ access: "const" }))).toBe(false);
    expect(objectHolds("writable", object({ access: "wo" }))).toBe(true);
    expect(objectHolds("mappable", object({ mappable: false }))).toBe(false);
  });

  it("stand in CSV below what they belong to", () => {
    const lines = objectsCsv([object({ value: 6 })], () => "Parent");
    expect(lines.split("\n")[1]).toBe("6040h:00,Parent,Controlword,6,UNSIGNED16,rww,true,,");
  });

  it("say why one cannot be read, and go on", async () => {
    const get = (_: string, path: string): Promise<unknown> =>
      path === "objects/6040"
        ? Promise.reject(new Refusal("refused", "no", 409, { abort_text: "cannot be read" }))
        : Promise.resolve(object({ index: 0x6041, value: 5 }));
    const objects = new Objects({ isLive: true, get } as unknown as Source, "vcan0/5");
    const rows = await objects.readAll([object({}), object({ index: 0x6041 })]);
    expect(rows.map((row) => row.said ?? row.value)).toEqual(["cannot be read", 5]);
  });

  it("are not asked for empty entries of the error field", async () => {
    const asked: number[] = [];
    const get = (_: string, __: string, query: { sub_index: number }): Promise<unknown> => {
      asked.push(query.sub_index);
      return Promise.resolve(object({ index: 0x1003, sub_index: query.sub_index, value: query.sub_index === 0 ? 1 : 0x18700 }));
    };
    const entries = [0, 1, 2].map((sub_index) => object({ index: 0x1003, sub_index }));
    const source = { isLive: true, get } as unknown as Source;
    const rows = await new Objects(source, "vcan0/5", "cia402").readAll(entries);
    expect(rows.map((row) => row.said ?? row.value)).toEqual([1, 0x18700, "no error"]);
    expect(asked).toEqual([0, 0, 1]);
    asked.length = 0;
    await new Objects(source, "vcan0/5").readAll(entries);
    expect(asked).toEqual([0, 1, 2]);
  });

  it("are given up when nobody answers", async () => {
    const get = (): Promise<unknown> => Promise.reject(new Refusal("no-gateway", "gone"));
    const objects = new Objects({ isLive: true, get } as unknown as Source, "vcan0/5");
    await expect(objects.readAll([object({})])).rejects.toThrow("gone");
  });
});

describe("an EDS", () => {
  const eds = parsedEds(
    "[1018]\r\nParameterName=Identity Object\r\n[1018sub0]\nParameterName=number of entries\n[1018sub1]\n" +
      "ParameterName=Vendor Id\nDefaultValue=0x53\n[OptionalObjects]\nParameterName=wrong\n[6040]\nParameterName=Controlword\nDefaultValue=0\n",
  );

  it("has names and defaults", () => {
    expect(edsEntry(eds, 0x1018, 1)).toEqual({ name: "Vendor Id", defaultValue: "0x53" });
    expect(edsEntry(eds, 0x6040, 0)?.defaultValue).toBe("0");
    expect(edsEntry(eds, 0x6041, 0)).toBeUndefined();
  });

  it("has the names of records", () => {
    expect(parentName(eds, 0x1018)).toBe("Identity Object");
    expect(parentName(eds, 0x6040)).toBe("");
  });
});
