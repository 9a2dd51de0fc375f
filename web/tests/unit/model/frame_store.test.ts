import { describe, expect, it } from "vitest";

import { kLaneCount, laneNumber, ServiceMap } from "../../../src/canopen/services";
import { FrameStore } from "../../../src/model/frame_store";
import { frameOf } from "../data/files";

const kServices = new ServiceMap({ nodeId: 5 });
const kRpdo = laneNumber("rpdo");
const kTpdo = laneNumber("tpdo");

/** A frame each 100 µs, RPDO and TPDO in turn. */
function line(i: number): string {
  return `${(i / 10_000).toFixed(6)} ${i % 2 === 0 ? "R 205#0F00" : "S 185#3716"}`;
}
function filled(count: number, capacity = 1_000_000): FrameStore {
  const store = new FrameStore(kServices.laneOf, capacity);
  store.appendLines(Array.from({ length: count }, (_, i) => line(i)));
  return store;
}
/** Density as it is by counting frame by frame. */
function counted(store: FrameStore, from: number, to: number, bins: number): Uint32Array {
  const counts = new Uint32Array(kLaneCount * bins);
  const [begin, end] = store.range(from, to);
  for (let serial = begin; serial < end; ++serial) {
    let bin = 0;
    while (bin < bins - 1 && store.timeOf(serial) >= from + (bin + 1) * ((to - from) / bins)) ++bin;
    const place = store.laneAt(serial) * bins + bin;
    counts[place] = (counts[place] ?? 0) + 1;
  }
  return counts;
}

describe("lines of frames", () => {
  it.each([
    ["12.345678 R 205#0F00", { t: 12.345678, sent: false, isRemote: false, isExtended: false, id: 0x205, length: 2 }],
    ["0.000001 S 18FF0A05#0102030405060708", { t: 1e-6, sent: true, isExtended: true, id: 0x18ff0a05, length: 8 }],
    ["3 R 705#R", { isRemote: true, length: 0 }],
    ["3 R 705#R1", { isRemote: true, length: 1 }],
    ["4.5 S 080#", { length: 0, id: 0x80 }],
  ])("%s", (text, expected) => {
    const store = new FrameStore(kServices.laneOf);
    expect(store.appendLines([text])).toBe(0);
    expect(store.frame(0)).toMatchObject(expected);
  });

  it.each(["", "x", "1.0 R", "1.0 X 205#00", "1.0 R 20#00", "1.0 R 205#0", "1.0 R 205#0G", "1.0 R 205#000102030405060708", "1.0 R 705#R9", "1.0 R 705#R12", "1.0R 205#00"])(
    "leaves %j out",
    (text) => {
      const store = new FrameStore(kServices.laneOf);
      expect(store.appendLines([text])).toBe(1);
      expect(store.size).toBe(0);
    },
  );
});

describe("a store of frames", () => {
  it("keeps the newest under their serial numbers", () => {
    const store = filled(1000, 256);
    expect(store.next).toBe(1000);
    expect(store.size).toBeLessThanOrEqual(256);
    expect(store.size).toBeGreaterThan(190);
    expect(store.frame(store.first - 1)).toBeUndefined();
    expect(store.frame(999)?.t).toBeCloseTo(0.0999, 9);
    expect(store.from).toBeCloseTo(store.first / 10_000, 9);
  });

  it("finds ranges by time", () => {
    const store = filled(20_000);
    expect(store.range(0.5, 0.6)).toEqual([5000, 6000]);
    expect(store.range(-1, 0)).toEqual([0, 0]);
    expect(store.range(9, 10)).toEqual([20_000, 20_000]);
  });

  it.each([[20_000, 1_000_000], [20_000, 4096]])("counts %i frames (room for %i) as one by one", (count, capacity) => {
    const store = filled(count, capacity);
    for (const [from, to, bins] of [[0, 2, 7], [1.61, 1.93, 300], [1.7, 1.9, 1], [1.99, 3, 10]] as const)
      expect(store.density(from, to, bins)).toEqual(counted(store, from, to, bins));
  });

  it("finds the nearest frame of a lane", () => {
    const store = filled(1000);
    expect(store.nearest(0.05001, kRpdo, 1)).toBe(500);
    expect(store.nearest(0.05001, kTpdo, 1)).toBe(501);
    expect(store.nearest(0.05001, laneNumber("emcy"), 1)).toBeUndefined();
    expect(store.nearest(5, kRpdo, 0.1)).toBeUndefined();
  });

  it("sorts into other lanes when identifiers become others", () => {
    const store = filled(500);
    store.relane(() => kTpdo);
    const counts = store.density(0, 1, 1);
    expect([counts[kRpdo], counts[kTpdo]]).toEqual([0, 500]);
  });

  it("begins anew with the time of the unit", () => {
    const store = filled(30_000);
    store.append(frameOf("705#00", 0.1));
    expect(store.size).toBe(1);
    expect(store.from).toBe(0.1);
    store.append(frameOf("705#7F", 0.05));
    expect(store.to).toBe(0.1);
  });

  it("is without times when it is empty", () => {
    const store = new FrameStore(kServices.laneOf);
    expect([store.from, store.to, store.size]).toEqual([NaN, NaN, 0]);
    expect(store.density(0, 1, 2)).toEqual(new Uint32Array(2 * kLaneCount));
    expect(store.nearest(0, kRpdo, 1)).toBeUndefined();
  });
});
