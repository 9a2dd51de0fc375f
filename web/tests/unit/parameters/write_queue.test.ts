import { expect, test } from "vitest";

import { WriteQueue } from "../../../src/parameters/shared/write_queue";

/** Writes that end when the test says so. */
class Unit {
  readonly written: string[] = [];
  private end: (taken: boolean) => void = () => undefined;

  write = (text: string): Promise<boolean> => {
    this.written.push(text);
    return new Promise((done) => (this.end = done));
  };

  /** Ends the write under way, and lets the next one begin. */
  async answer(taken = true): Promise<void> {
    this.end(taken);
    await new Promise((done) => setTimeout(done));
  }
}

test("texts are written one after the other, of those that wait the newest", async () => {
  const unit = new Unit();
  const queue = new WriteQueue();
  for (const text of ["1", "2", "3"]) void queue.add(text, unit.write);
  expect(unit.written).toEqual(["1"]);
  await unit.answer();
  expect(unit.written).toEqual(["1", "3"]);
  await unit.answer();
  void queue.add("4", unit.write);
  expect(unit.written).toEqual(["1", "3", "4"]);
});

test("a key that is held down writes once", async () => {
  const unit = new Unit();
  const queue = new WriteQueue();
  for (let times = 0; times < 30; ++times) void queue.add("1", unit.write);
  await unit.answer();
  expect(unit.written).toEqual(["1"]);
});

test("who goes back to what is being written writes nothing more", async () => {
  const unit = new Unit();
  const queue = new WriteQueue();
  for (const text of ["1", "2", "1"]) void queue.add(text, unit.write);
  await unit.answer();
  expect(unit.written).toEqual(["1"]);
});

test("nothing is written behind a refusal", async () => {
  const unit = new Unit();
  const queue = new WriteQueue();
  for (const text of ["1", "2"]) void queue.add(text, unit.write);
  await unit.answer(false);
  expect(unit.written).toEqual(["1"]);
  void queue.add("3", unit.write);
  expect(unit.written).toEqual(["1", "3"]);
});
