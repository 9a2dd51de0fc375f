import { describe, expect, it } from "vitest";

import { everything, PagedList, type Part } from "../../../src/parameters/shared/paged_list";

interface Row {
  key: string;
  value: number;
}

/** Rows 0 to 99 in parts of 30; each wanted number is the value of all rows. */
class Rows {
  asked: number[] = [];
  failure?: Error;
  part(wanted: number, from: number): Promise<Part<Row>> {
    this.asked.push(from);
    if (this.failure !== undefined) return Promise.reject(this.failure);
    const end = Math.min(from + 30, 100);
    const entries = Array.from({ length: end - from }, (_, at) => ({ key: String(from + at), value: wanted }));
    return Promise.resolve(end === 100 ? { entries, total: 100 } : { entries, total: 100, next: end });
  }
  again(wanted: number, rows: readonly Row[]): Promise<Row[]> {
    if (this.failure !== undefined) return Promise.reject(this.failure);
    return Promise.resolve(rows.map(({ key }) => ({ key, value: wanted + 1 })));
  }
  key(row: Row): string {
    return row.key;
  }
}

describe("a list in pages", () => {
  it("asks for no more than is shown, and for the rest when that is wanted", async () => {
    const rows = new Rows();
    const list = new PagedList(rows);
    await list.ask(1);
    expect([list.rows.value.length, list.progress.value]).toEqual([90, "partial"]);
    await list.more();
    expect([list.rows.value.length, list.progress.value]).toEqual([100, "whole"]);
    expect(rows.asked).toEqual([0, 30, 60, 90]);
  });

  it("reads rows again without moving them", async () => {
    const list = new PagedList(new Rows());
    await list.ask(1);
    await list.refresh(["3", "unknown"]);
    expect(list.rows.value.slice(2, 5).map((row) => [row.key, row.value])).toEqual([["2", 1], ["3", 2], ["4", 1]]);
  });

  it("drops answers to what is no longer wanted", async () => {
    const list = new PagedList(new Rows());
    const first = list.ask(1);
    await Promise.all([first, list.ask(7)]);
    expect(list.rows.value.every((row) => row.value === 7)).toBe(true);
    expect(list.rows.value).toHaveLength(90);
  });

  it("keeps its rows when nobody answers, says why, and goes on later", async () => {
    const rows = new Rows();
    const list = new PagedList(rows);
    await list.ask(1);
    rows.failure = new Error("gone");
    await list.refresh(["1"]);
    expect([list.rows.value.length, list.error.value]).toEqual([90, "gone"]);
    await list.more();
    expect(list.rows.value).toHaveLength(90);
    delete rows.failure;
    await list.more();
    expect([list.rows.value.length, list.error.value]).toEqual([100, ""]);
  });

  it("is fetched as a whole for a file, and tells how far it is", async () => {
    const rows = new Rows();
    const told: number[] = [];
    const all = await everything((from) => rows.part(1, from), (share) => told.push(share));
    expect(all).toHaveLength(100);
    expect(told).toEqual([0.3, 0.6, 0.9, 1]);
  });
});
