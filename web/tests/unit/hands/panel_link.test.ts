import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import { kTimeout, PanelLink, type PanelPort } from "../../../src/hands/panel/panel_link";
import { Refusal } from "../../../src/source/refusal";
import type { Panel } from "../../../src/source/types";

const kPanel: Panel = { axis: 1, active: true, on: false, speed_rpm: 0, timeout_ms: kTimeout, remaining_ms: kTimeout, state: "Ready to switch on" };

/** A panel that takes everything, and tells what it was sent. */
class Unit implements PanelPort {
  sent: [boolean, number][] = [];
  released = 0;
  answer: () => Promise<Panel> = () => Promise.resolve(kPanel);
  take = (): Promise<Panel> => Promise.resolve(kPanel);
  release = (): Promise<Panel> => {
    this.released++;
    return Promise.resolve({ ...kPanel, active: false });
  };
  set = (on: boolean, speed: number): Promise<Panel> => {
    this.sent.push([on, speed]);
    return this.answer();
  };
}

let unit: Unit;
let link: PanelLink;

beforeEach(async () => {
  vi.useFakeTimers();
  unit = new Unit();
  link = new PanelLink(unit);
  await link.take();
});
afterEach(async () => {
  await link.release();
  vi.useRealTimers();
});

describe("a panel that holds the control", () => {
  it("says what it commands often enough for the unit to keep it", async () => {
    await link.order({ on: true, speedRpm: 300 });
    await vi.advanceTimersByTimeAsync(kTimeout * 4);
    expect(unit.sent.length).toBeGreaterThan(8);
    expect(unit.sent.at(-1)).toEqual([true, 300]);
  });
  it("has one renewal under way at a time, and the newest setpoint in the next", async () => {
    let answer: (panel: Panel) => void = () => undefined;
    unit.answer = () => new Promise((resolve) => (answer = resolve));
    await vi.advanceTimersByTimeAsync(160);
    for (const speedRpm of [10, 20, 30]) link.follow({ on: true, speedRpm });
    await vi.advanceTimersByTimeAsync(200);
    expect(unit.sent).toEqual([[false, 0]]);
    answer(kPanel);
    await vi.advanceTimersByTimeAsync(1);
    expect(unit.sent).toEqual([[false, 0], [true, 30]]);
  });
  it("stops without waiting for what is under way", async () => {
    await link.order({ on: true, speedRpm: 300 });
    unit.answer = () => new Promise(() => undefined);
    await vi.advanceTimersByTimeAsync(160);
    unit.answer = () => Promise.resolve(kPanel);
    await link.stop();
    expect(unit.sent.at(-1)).toEqual([false, 0]);
  });
  it("gives the control back once, and is silent then", async () => {
    await link.release();
    const sent = unit.sent.length;
    await vi.advanceTimersByTimeAsync(1000);
    expect([unit.released, unit.sent.length]).toEqual([1, sent]);
    expect(link.isHeld.value).toBe(false);
  });
});

describe("a panel that is not heard", () => {
  it("does not switch on again by itself after a silence", async () => {
    await link.order({ on: true, speedRpm: 300 });
    unit.answer = () => Promise.reject(new Refusal("no-gateway", "axisd-http: cannot be reached"));
    await vi.advanceTimersByTimeAsync(kTimeout + 200);
    expect(link.trouble.value).not.toBe("");
    expect(link.command.value.on).toBe(false);
    unit.answer = () => Promise.resolve(kPanel);
    await vi.advanceTimersByTimeAsync(400);
    expect(unit.sent.at(-1)).toEqual([false, 0]);
    expect(link.trouble.value).toBe("");
  });
  it("says how long nobody has answered", async () => {
    unit.answer = () => new Promise(() => undefined);
    await vi.advanceTimersByTimeAsync(1000);
    expect(link.trouble.value).toContain("No answer for");
  });
  it("knows that the control is lost when the unit refuses", async () => {
    unit.answer = () => Promise.reject(new Refusal("refused", "no operator panel has the control", 409));
    await vi.advanceTimersByTimeAsync(200);
    expect(link.isHeld.value).toBe(false);
    expect(link.trouble.value).toContain("no operator panel has the control");
    await expect(link.order({ on: true, speedRpm: 1 })).rejects.toThrow("not taken");
  });
  it("knows that the control has gone back", async () => {
    unit.answer = () => Promise.resolve({ ...kPanel, active: false });
    await vi.advanceTimersByTimeAsync(200);
    expect(link.isHeld.value).toBe(false);
  });
});
