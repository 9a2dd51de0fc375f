import { describe, expect, it } from "vitest";

import { parseEds } from "../../../src/canopen/eds";
import { pdosOfEds } from "../../../src/canopen/pdo";
import { projectText } from "../data/files";

describe("an EDS", () => {
  it.each(["eds/axisd.eds", "eds/axisd-unit.eds", "eds/axisd-servo.eds", "examples/example_slave.eds"])("is read: %s", (path) => {
    const eds = parseEds(projectText(path));
    expect(eds.remarks).toEqual([]);
    expect(eds.find(0x1000, 0)?.dataType).toBe(7);
  });

  it("names objects, types and access", () => {
    const eds = parseEds(projectText("eds/axisd.eds"));
    expect(eds.find(0x6040, 0)).toMatchObject({ name: "Controlword", dataType: 6, access: "rww", isMappable: true });
    expect(eds.nameOf(0x1018, 1)).toBe("Identity Object: Vendor Id");
    expect(eds.nameOf(0x5555, 0)).toBe("");
    expect(eds.productName).toBe("SINAMICS S120 CU320-2 CBC10");
  });

  it("puts the node-ID into defaults", () => {
    const eds = parseEds(projectText("eds/axisd.eds"));
    expect(eds.defaultOf(0x1400, 1, 5)).toBe(0x205);
    expect(eds.defaultOf(0x1400, 1)).toBeUndefined();
    expect(eds.defaultOf(0x1800, 1, 5)).toBe(0x40000185);
    expect(eds.defaultOf(0x9999, 0)).toBeUndefined();
  });

  it("has the PDOs of a unit at power-on", () => {
    const pdos = pdosOfEds(parseEds(projectText("eds/axisd.eds")), 5);
    expect(pdos.find((pdo) => pdo.pdo === "RPDO 2")).toMatchObject({
      identifier: 0x305,
      direction: "receive",
      axis: 1,
      mapping: [
        { object: "6040h:00", bits: 16, name: "Controlword" },
        { object: "60FFh:00", bits: 32, name: "Target Velocity" },
      ],
    });
  });

  it("expands compact objects", () => {
    const text = [
      "[2000]", "ParameterName=Levels", "ObjectType=0x8", "DataType=0x0003", "AccessType=rw", "CompactSubObj=3", "DefaultValue=7",
      "[2000Name]", "NrOfEntries=1", "2=Second", "[2000Value]", "NrOfEntries=1", "3=0x10",
    ].join("\r\n");
    const eds = parseEds(text);
    expect(eds.defaultOf(0x2000, 0)).toBe(3);
    expect(eds.nameOf(0x2000, 1)).toBe("Levels: Levels1");
    expect(eds.nameOf(0x2000, 2)).toBe("Levels: Second");
    expect([1, 2, 3].map((sub) => eds.defaultOf(0x2000, sub))).toEqual([7, 7, 16]);
  });

  it("bears comments, CRLF, bad lines and octal numbers, and says where they are", () => {
    const eds = parseEds("; a comment\r\n[1000]\r\nParameterName=Type\r\nDefaultValue=010\r\nnonsense\r\n[bad\r\n");
    expect(eds.remarks).toEqual(["line 5: neither [section] nor key=value", "line 6: a section without ]"]);
    expect(eds.defaultOf(0x1000, 0)).toBe(8);
  });

  it("says why a file is none", () => {
    expect(() => parseEds("hello\nworld", "letter.txt")).toThrow(
      "letter.txt is no EDS: no section of an object, such as [1000] (line 1: neither [section] nor key=value)",
    );
    expect(() => parseEds("")).toThrow("is no EDS");
  });
});
