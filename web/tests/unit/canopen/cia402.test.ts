import { describe, expect, it } from "vitest";

import { Decoder } from "../../../src/canopen/decode";
import { parseEds } from "../../../src/canopen/eds";
import { ServiceMap } from "../../../src/canopen/services";
import { commandOf, controlwordBits, statuswordBits } from "../../../src/canopen/words";
import { frameOf, projectText } from "../data/files";

const kEds = parseEds(projectText("eds/axisd-cia402.eds"));
const kDecoder = new Decoder({ services: new ServiceMap({ nodeId: 5, eds: kEds }), eds: kEds, profile: "cia402" });

describe("frames of a CiA 402 axis in words", () => {
  it.each([
    ["605#2B40600006000000", "SDO request: download request 6040h:00 Controlword = 0x0006: Shutdown"],
    ["605#2B40600000000000", "SDO request: download request 6040h:00 Controlword = 0x0000: Disable voltage"],
    ["605#237A6000FEFFFFFF", "SDO request: download request 607Ah:00 Target position = -2\u2009units"],
    ["605#2381600040420F00", "SDO request: download request 6081h:00 Profile velocity = 1000000\u2009units/s"],
    ["605#23836000FFFFFFFF", "SDO request: download request 6083h:00 Profile acceleration = 4294967295\u2009units/s²"],
    ["605#23656000FFFFFFFF", "SDO request: download request 6065h:00 Following error window = off"],
    ["605#2F98600023000000", "SDO request: download request 6098h:00 Homing method = method 35"],
    ["605#2F60600008000000", "SDO request: download request 6060h:00 Modes of operation = 8: cyclic synchronous position"],
    ["085#1186210200000000", "EMCY: 0x8611 following error: axis 2"],
    ["085#3081110000000000", "EMCY: 0x8130 life guard error or heartbeat error"],
    ["085#0000000100000000", "EMCY: no error is left"],
    ["085#0000010100000000", "EMCY: an error has gone, others are left"],
  ])("%s", (text, headline) => {
    expect(kDecoder.decode(frameOf(text)).headline).toBe(headline);
  });

  it("say nothing of OFF1 to OFF3, nor of parameters", () => {
    const names = [...controlwordBits(0, "cia402"), ...statuswordBits(0, "cia402")].map((row) => row.name);
    expect(names.filter((name) => /OFF\d|[pr]\d{4}/.test(name))).toEqual([]);
    expect(commandOf(0x0002, "cia402")).toBe("Quick stop");
    expect(statuswordBits(0x8000, "cia402")[15]).toEqual({ bit: "15", name: "Homed", value: 1 });
  });

  it("leave those of the drive unit as they are", () => {
    expect(commandOf(0x0002)).toBe("Quick stop (OFF3)");
    expect(statuswordBits(0)[15]?.name).toBe("of the manufacturer (p8787)");
  });
});
