import { describe, expect, it } from "vitest";

import { Decoder } from "../../../src/canopen/decode";
import { parseEds } from "../../../src/canopen/eds";
import { ServiceMap } from "../../../src/canopen/services";
import type { UnitEvent } from "../../../src/source/types";
import { frameOf, projectText } from "../data/files";

const kEvents: UnitEvent[] = [
  { t: 1, kind: "fault", number: 7860, drive_object: 2, axis: 1, name: "F07860", text: "External fault 1", value: 3, active: true },
];
const kEds = parseEds(projectText("eds/axisd.eds"));
const kDecoder = new Decoder({ services: new ServiceMap({ nodeId: 5, eds: kEds }), eds: kEds, events: () => kEvents });

function decoded(text: string) {
  return kDecoder.decode(frameOf(text));
}

describe("a frame in words", () => {
  it.each([
    ["000#0105", "NMT command: Start remote node, node 5"],
    ["000#8200", "NMT command: Reset communication, all nodes"],
    ["080#", "SYNC: without a counter"],
    ["080#07", "SYNC: counter 7"],
    ["100#00000000E638", "TIME: 2023-11-18T00:00:00.000Z"],
    ["705#00", "heartbeat: boot-up"],
    ["705#05", "heartbeat: Operational"],
    ["705#FF", "heartbeat: Pre-operational, guarding response with toggle bit 1"],
    ["705#R1", "heartbeat: node guarding request"],
    ["707#04", "heartbeat of node 7: Stopped"],
    ["205#0F00", "RPDO 1: Controlword 0x000F: Enable operation"],
    ["305#0F0000008002", "RPDO 2: Controlword 0x000F: Enable operation, Target Velocity 600\u2009rpm (41943040 inc/s)"],
    ["385#3706CF02", "TPDO 3: Statusword 0x0637: Operation enabled, Torque Actual Value 719\u2009‰ of the rated value"],
    ["085#0010810000000000", "EMCY: 0x1000 generic error: F/A00000"],
    ["085#001080B41E020000", "EMCY: 0x1000 generic error: F07860 External fault 1"],
    ["085#0000000000000000", "EMCY: no error is left"],
    ["7E5#04", "frame: 04"],
  ])("%s", (text, headline) => {
    expect(decoded(text).headline).toBe(headline);
  });

  it("spells words out bit by bit, with object and raw value", () => {
    const [row] = decoded("185#3116").rows;
    expect(row).toMatchObject({ name: "Statusword", object: "6041h:00", raw: "0x1631" });
    expect(row?.bits?.find((bit) => bit.bit === "0")).toEqual({ bit: "0", name: "Ready to switch on", value: 1 });
  });

  it("says when a PDO is too short, and what is there nevertheless", () => {
    const { rows, remark } = decoded("305#0F0000");
    expect(rows.map((row) => row.name)).toEqual(["Controlword"]);
    expect(remark).toBe("3 bytes are fewer than the mapping has (6)");
  });

  it("shows the error register by its bits", () => {
    const row = decoded("085#001081B41E020000").rows.find(({ name }) => name === "Error register");
    expect(row?.value).toBe("generic error, manufacturer specific");
  });

  it.each([
    ["605#4000100000000000", "SDO request: upload request 1000h:00 Device Type"],
    ["585#430010009201FFFF", "SDO response: upload response 1000h:00 Device Type = 4294902162 (0xFFFF0192)"],
    ["605#2B171000C8000000", "SDO request: download request 1017h:00 Producer Heartbeat Time = 200\u2009ms"],
    ["585#6017100000000000", "SDO response: download response 1017h:00 Producer Heartbeat Time"],
    ["585#8000100002000106", "SDO response: abort 0x06010002: read only 1000h:00 Device Type"],
    ["605#2B40600006000000", "SDO request: download request 6040h:00 Controlword = 0x0006: Shutdown (OFF1)"],
    ["605#23001A0110004160", "SDO request: download request 1A00h:01 Transmit PDO Mapping Parameter: PDO Mapping Entry = 6041h:00, 16 bits"],
    ["605#2301140105020080", "SDO request: download request 1401h:01 Receive PDO Communication Parameter: COB-ID = 0x205, not valid (0x80000205)"],
  ])("SDO %s", (text, headline) => {
    expect(decoded(text).headline).toBe(headline);
  });

  it("says what is wrong with SDO frames", () => {
    expect(decoded("605#40").remark).toBe("SDO frames have 8 bytes");
    expect(decoded("605#E000000000000000").remark).toBe("command specifier 7 is none of CiA 301");
  });
});
