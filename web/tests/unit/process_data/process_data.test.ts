import { describe, expect, it } from "vitest";

import { bytesOf, fieldsOf, hexOf, positionText, rawOf } from "../../../src/process_data/layout";
import { isWanted, pdosOf } from "../../../src/process_data/pdo_source";
import { ageText, identifierText, rateOf, stateWords, transmissionWords } from "../../../src/process_data/words";
import type { Query, Source } from "../../../src/source/source";
import type { Pdo } from "../../../src/source/types";

function pdo(over: Partial<Pdo>): Pdo {
  const usual = { pdo: "RPDO 1", axis: 1, direction: "receive" as const, object: "1400h", cob_id: 0x205, length: 6 };
  return { ...usual, is_valid: true, is_active: true, transmission_type: 254, mapping: [], ...over };
}

describe("the layout of a PDO", () => {
  const fields = fieldsOf(
    pdo({
      mapping: [
        { object: "6040h:00", bits: 16, name: "Controlword", value: 6 },
        { object: "2000h:01", bits: 1 },
        { object: "2000h:02", bits: 11 },
      ],
    }),
  );

  it("follows the mapping bit by bit", () => {
    expect(fields.map(({ firstBit, bits }) => [firstBit, bits])).toEqual([[0, 16], [16, 1], [17, 11]]);
    expect(fields.map(positionText)).toEqual(["byte 0 to 1", "byte 2, bit 0", "byte 2, bit 1 to byte 3, bit 3"]);
  });

  it("takes values out of a frame, the low byte first", () => {
    const bytes = bytesOf("0F00FF03");
    expect(fields.map((field) => rawOf(field, bytes))).toEqual([0x0fn, 1n, 0b1_1111_1111n]);
    expect(hexOf(0x0fn, 16)).toBe("000Fh");
  });

  it("has no value of a frame that is too short", () => {
    expect(fields.map((field) => rawOf(field, bytesOf("0F00")))).toEqual([15n, undefined, undefined]);
    expect(bytesOf(undefined)).toEqual([]);
  });
});

describe("words of a PDO", () => {
  it("say when it is sent", () => {
    expect(transmissionWords("transmit", 0)).toBe("at the next SYNC after a change");
    expect(transmissionWords("transmit", 1)).toBe("at every SYNC");
    expect(transmissionWords("transmit", 22)).toBe("at every 22nd SYNC");
    expect(transmissionWords("transmit", 113)).toBe("at every 113th SYNC");
    expect(transmissionWords("transmit", 253)).toBe("on remote request");
    expect(transmissionWords("transmit", 250)).toBe("reserved");
    expect(transmissionWords("receive", 240)).toBe("acts at the next SYNC");
    expect(transmissionWords("receive", 255)).toBe("acts at once");
  });

  it("say whether it works", () => {
    expect(stateWords(pdo({}))).toBe("active");
    expect(stateWords(pdo({ is_active: false }))).toBe("valid, waits for Operational");
    expect(stateWords(pdo({ is_valid: false, is_active: false }))).toBe("not valid");
    expect(identifierText(pdo({ identifier: 0x305 }))).toBe("305h");
  });

  it("tell a rate that falls while no frame comes", () => {
    expect(rateOf(pdo({}))).toBeUndefined();
    expect(rateOf(pdo({ frames: 1, age_s: 3 }))).toBe(0);
    expect(rateOf(pdo({ frames: 9, interval_s: 0.01, age_s: 0.002 }))).toBeCloseTo(100);
    expect(rateOf(pdo({ frames: 9, interval_s: 0.01, age_s: 2 }))).toBe(0.5);
    expect(ageText(pdo({ frames: 9, age_s: 0.0123 }))).toBe("12\u2009ms ago");
    expect(ageText(pdo({ frames: 0 }))).toBe("no frame yet");
  });
});

describe("the PDOs of a unit", () => {
  const kPages = [
    { pdos: [pdo({}), pdo({ axis: 2 })], total: 3, next: 2, is_watched: true, watched_s: 5 },
    { pdos: [pdo({ is_valid: false })], total: 3, is_watched: true, watched_s: 5 },
  ];

  it("come in pages from one that lives", async () => {
    const requests: Query[] = [];
    const get = (_unit: string, _path: string, query: Query): Promise<unknown> => {
      requests.push(query);
      return Promise.resolve(kPages[requests.length - 1]);
    };
    const found = await pdosOf({ isLive: true, get } as unknown as Source, "vcan0/5", { axis: 1, all: true });
    expect(requests).toEqual([{ all: true, axis: 1, from: 0 }, { all: true, axis: 1, from: 2 }]);
    expect([found.pdos.length, found.isWatched, found.watchedSeconds]).toEqual([2, true, 5]);
  });

  it("are filtered here", () => {
    expect(isWanted(pdo({}), { axis: 0, all: false })).toBe(true);
    expect(isWanted(pdo({ is_valid: false }), { axis: 0, all: false })).toBe(false);
    expect(isWanted(pdo({ axis: 2 }), { axis: 1, all: true })).toBe(false);
  });
});
