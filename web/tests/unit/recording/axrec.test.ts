import { describe, expect, it } from "vitest";

import { crc32 } from "../../../src/recording/crc32";
import { openFile } from "../../../src/recording/open_file";
import { dataFile } from "../data/files";

const kFile = dataFile("run.axrec");

/** A record as docs/reference/recording.md has it. */
function record(type: number, t: number, content: number[]): number[] {
  const bytes = new Uint8Array(12 + content.length + 4);
  const view = new DataView(bytes.buffer);
  view.setUint16(0, type, true);
  view.setUint16(2, content.length, true);
  view.setBigInt64(4, BigInt(Math.round(t * 1e9)), true);
  bytes.set(content, 12);
  view.setUint32(12 + content.length, crc32(bytes, 0, 12 + content.length), true);
  return [...bytes];
}
function fileOf(head: object, ...records: number[][]): Uint8Array {
  const text = new TextEncoder().encode(JSON.stringify(head));
  const bytes = new Uint8Array(16 + text.length + 4);
  bytes.set(new TextEncoder().encode("AXISREC\n"));
  bytes.set(text, 16);
  const view = new DataView(bytes.buffer);
  view.setUint16(8, 1, true);
  view.setUint32(12, text.length, true);
  view.setUint32(16 + text.length, crc32(text), true);
  return Uint8Array.from([...bytes, ...records.flat()]);
}
function eventBytes(kind: number, text: string, before: string, more: Record<number, number> = {}): number[] {
  const fixed = Array.from({ length: 38 }, (_, i) => more[i] ?? 0);
  fixed[0] = kind;
  const encode = (word: string) => [word.length, ...new TextEncoder().encode(word)];
  return [...fixed, ...encode(text), ...encode(before)];
}

describe("a recording", () => {
  const run = openFile("run.axrec", kFile);

  it("tells whose it is and what is in it", () => {
    expect(run).toMatchObject({ name: "run.axrec", format: "axrec", unit: "vcan0/5", lost: 0, remark: "" });
    expect(run.head).toMatchObject({ node_id: 5, cycle_s: 0.004, axes: [{ axis: 1, name: "X", type: "servo" }] });
    expect(run.samples.signals).toEqual([{ signal: "1/speed", unit: "rpm" }, { signal: "1/torque", unit: "Nm" }]);
    expect(run.from).toBeCloseTo(2.359184, 2);
    expect(run.to).toBeCloseTo(4.918, 2);
    expect(run.startedAt).toBeCloseTo(1795464877.915, 2);
  });

  it("has frames, samples and events as axisctl record show has them", () => {
    expect(run.frames.frame(0)).toMatchObject({ id: 0x605, sent: false, length: 8 });
    expect(run.samples.size).toBeGreaterThan(200);
    expect(Math.max(...[...run.samples.rows(0, 10)].map(({ values }) => values[0] ?? 0))).toBeCloseTo(600, 0);
    const pick = (kind: string) => run.events.filter((event) => event.kind === kind);
    expect(pick("nmt")[0]).toMatchObject({ state: "Operational", before: "Pre-operational" });
    expect(pick("fault")[0]).toEqual({
      t: 3.167950492, unit: "vcan0/5", kind: "fault", active: true, axis: 1, drive_object: 2, name: "F07860", number: 7860,
      text: "External fault 1", value: 3,
    });
    expect(pick("object")[0]).toMatchObject({ object: "1017:00", value: 200, before: 0, by: "sdo", server: 0 });
    expect(pick("refusal")[0]).toMatchObject({ object: "1000:00", abort_code: "0x06010002", text: "read only" });
    expect(pick("emcy").at(-1)).toMatchObject({ code: "0x0000", data: "0000000000000000" });
    expect(pick("drive-state")[0]).toMatchObject({ state: "Ready to switch on", before: "Switch on disabled", axis: 1 });
  });

  it("is read to the last whole record wherever it is cut", () => {
    const first = 16 + new DataView(kFile.buffer, kFile.byteOffset).getUint32(12, true) + 4;
    for (let size = first; size < kFile.length; size += 211) {
      const cut = openFile("cut.axrec", kFile.subarray(0, size));
      expect(cut.frames.size).toBeLessThanOrEqual(run.frames.size);
      expect(cut.remark).toMatch(/^cut at byte \d+ of \d+: what is behind it was left out|^it has no end/);
    }
  });

  it("is read up to a byte that is wrong", () => {
    const damaged = kFile.slice();
    const at = kFile.length >> 1;
    damaged[at] = (damaged[at] ?? 0) ^ 1;
    const found = openFile("damaged.axrec", damaged);
    expect(found.remark).toMatch(/^(damaged|cut) at byte \d+ of \d+: what is behind it was left out; the last record is at 3\.\d+ s$/);
    expect(found.frames.size).toBeGreaterThan(100);
    expect(found.frames.size).toBeLessThan(run.frames.size);
  });

  it("is refused without a whole head, with what is wrong and where", () => {
    expect(() => openFile("a.axrec", kFile.subarray(0, 12))).toThrow("a.axrec: cut within its head, after 12 bytes");
    expect(() => openFile("a.axrec", kFile.subarray(0, 100))).toThrow("cut within its head");
    const wrong = kFile.slice();
    wrong[20] = 0;
    expect(() => openFile("a.axrec", wrong)).toThrow(/its head is damaged: the checksum at byte \d+ is wrong/);
    wrong[8] = 2;
    expect(() => openFile("a.axrec", wrong)).toThrow("version 2 of the format, this page reads 1");
  });

  it("leaves out what it does not know, and counts what had no room", () => {
    const file = fileOf(
      { unit: "vcan0/5", name: "x" },
      record(99, 1, [1, 2, 3]),
      record(2, 1, eventBytes(77, "", "")),
      record(2, 1.5, eventBytes(14, "load.set", "axis=1 torque_Nm=8", { 1: 2, 3: 2, 4: 1 })),
      record(2, 1.6, eventBytes(9, "", "", { 1: 2, 3: 2, 4: 1, 5: 2, 6: 0x60, 7: 4 })),
      record(2, 1.7, eventBytes(5, "Fault", "Switched on", { 3: 3 })),
      record(4, 2, [5, 0, 0, 0, 0, 0, 0, 0]),
      record(1, 3, [2, 1, 5, 7, 0, 0]),
      record(5, 4, [0, 0, 0]),
    );
    const found = openFile("x.axrec", file);
    expect(found.events).toEqual([
      { t: 1.5, unit: "vcan0/5", kind: "control", drive_object: 2, axis: 1, method: "load.set", text: "axis=1 torque_Nm=8", by: "control" },
      { t: 1.6, unit: "vcan0/5", kind: "parameter", drive_object: 2, axis: 1, parameter: "p1120[0]", by: "control", value: 0 },
      { t: 1.7, unit: "vcan0/5", kind: "drive-state", drive_object: 3, axis: "infeed", state: "Fault", before: "Switched on" },
    ]);
    expect(found).toMatchObject({ lost: 5, remark: "", from: 1, to: 4 });
    expect(found.frames.frame(0)).toMatchObject({ id: 0x705, isRemote: true, length: 1 });
  });

  it("without an end was still being written", () => {
    expect(openFile("x.axrec", fileOf({ unit: "u/1" }, record(1, 2, [0, 0, 0x80, 0, 0, 0]))).remark).toBe(
      "it has no end: the unit was still writing, or was ended; the last record is at 2.000000 s",
    );
    expect(openFile("x.axrec", fileOf({ unit: "u/1" }))).toMatchObject({ from: 0, to: 0 });
  });
});

it("has the CRC-32 of zlib", () => {
  expect(crc32(new TextEncoder().encode("123456789"))).toBe(0xcbf43926);
});
