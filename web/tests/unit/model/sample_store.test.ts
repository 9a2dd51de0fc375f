import { describe, expect, it } from "vitest";

import { SampleStore } from "../../../src/model/sample_store";

const kSignals = [{ signal: "1/speed", unit: "rpm" }, { signal: "1/torque", unit: "Nm" }];

/** Each ms a sample: a ramp, and a spike every 1000. */
function filled(count: number, capacity = 600_000, gap = Infinity): SampleStore {
  const store = new SampleStore(kSignals, capacity, gap);
  for (let i = 0; i < count; ++i) store.append(i / 1000, [i, i % 1000 === 500 ? 99 : 0]);
  return store;
}

describe("a store of samples", () => {
  it("gives each sample of a short window, and one on each side", () => {
    const [t, speed, torque] = filled(1000).window(0.1, 0.103, 100);
    expect(t.map((time) => Math.round(time * 1000))).toEqual([99, 100, 101, 102, 103, 104]);
    expect(speed).toEqual([99, 100, 101, 102, 103, 104]);
    expect(torque).toHaveLength(6);
  });

  it("keeps every spike in a long window", () => {
    const [t, , torque = []] = filled(100_000).window(0, 100, 300);
    expect(t.length).toBeLessThan(2 * 302 + 2);
    expect(torque.filter((value) => value === 99)).toHaveLength(100);
    expect(t.every((time, i) => i === 0 || time > (t[i - 1] ?? 0))).toBe(true);
  });

  it("draws the same parts of a window that moves", () => {
    const store = filled(100_000);
    const [first] = store.window(10, 70, 300);
    const [second] = store.window(10.4, 70.4, 300);
    const inside = (times: number[]) => times.filter((t) => t > 11 && t < 69);
    expect(inside(second)).toEqual(inside(first));
  });

  it("keeps the newest, with their extremes", () => {
    const store = filled(10_000, 4096);
    expect(store.size).toBeLessThanOrEqual(4096);
    expect(store.to).toBe(9.999);
    const [, speed = []] = store.window(0, 10, 10);
    expect(Math.max(...speed.map((value) => value ?? 0))).toBe(9999);
    expect(Math.min(...speed.map((value) => value ?? Infinity))).toBe(store.from * 1000);
  });

  it("shows gaps, and values that there are not", () => {
    const store = new SampleStore(kSignals, 100, 0.01);
    store.appendBatch({ unit: "", t: [0, 0.001, 1], values: [[1, null, 3], [4, 5, 6]], lost: 0 });
    expect(store.window(0, 2, 100)).toEqual([[0, 0.001, 0.5005, 1], [1, null, null, 3], [4, 5, null, 6]]);
    expect(store.valuesAt(0.0005)).toEqual([1, 4]);
    expect(store.valuesAt(0.5)).toEqual([null, null]);
    expect(store.valuesAt(-1)).toEqual([null, null]);
  });

  it("takes what comes twice once, and begins anew with the time of the unit", () => {
    const store = filled(3000);
    store.append(2.5, [0, 0]);
    expect(store.size).toBe(3000);
    store.append(0.1, [7, 8]);
    expect([...store.rows(0, 10)]).toEqual([{ t: 0.1, values: [7, 8] }]);
  });

  it("bears an empty window", () => {
    expect(new SampleStore(kSignals).window(0, 1, 100)).toEqual([[], [], []]);
    expect(new SampleStore([]).window(0, 1, 100)).toEqual([[]]);
  });
});
