import { describe, expect, it } from "vitest";

import { FrameRates } from "../../../src/overview/frame_rates";
import { stepsOf, summaryOf } from "../../../src/overview/report";
import { stateKey } from "../../../src/overview/state_key";
import type { AxisOverview, UnitOverview } from "../../../src/source/types";

function unit(uptime: number, frames: number): UnitOverview {
  return { unit: "vcan0/5", on: true, uptime_s: uptime, bus: { state: "error-active", link: "up", received: frames, sent: frames } };
}

const axis: AxisOverview = {
  axis: 1, name: "X", type: "servo", state: "Switched on", speed_rpm: 0, setpoint_rpm: 0, torque_Nm: 0, current_A: 0,
  position: 0, motor_temperature_C: 20, faults: [], alarms: [],
};

describe("frames a second", () => {
  it("is the difference of both counters over the unit's own time", () => {
    const rates = new FrameRates();
    expect(rates.update([unit(10, 100)]).get("vcan0/5")).toBeUndefined();
    expect(rates.update([unit(12, 200)]).get("vcan0/5")).toBe(100);
  });
  it("stays while the answer is the same, and begins anew with the unit", () => {
    const rates = new FrameRates();
    rates.update([unit(10, 100)]);
    rates.update([unit(12, 200)]);
    expect(rates.update([unit(12, 200)]).get("vcan0/5")).toBe(100);
    expect(rates.update([unit(1, 3)]).get("vcan0/5")).toBeUndefined();
    expect(rates.update([unit(2, 4)]).get("vcan0/5")).toBe(2);
  });
});

describe("what reasons depend on", () => {
  it("is the same while only figures move", () => {
    const at = (speed: number) => stateKey({ ...unit(1, 1), axes: [{ ...axis, speed_rpm: speed, torque_Nm: speed }] });
    expect(at(100)).toBe(at(101));
    expect(at(0)).not.toBe(at(100));
  });
  it("changes with states, faults and the bus", () => {
    const key = stateKey({ ...unit(1, 1), axes: [axis] });
    expect(stateKey({ ...unit(1, 1), axes: [{ ...axis, state: "Fault" }] })).not.toBe(key);
    expect(stateKey({ ...unit(1, 1), axes: [{ ...axis, faults: [{ number: 7860, text: "" }] }] })).not.toBe(key);
    expect(stateKey({ ...unit(1, 1), nmt_state: "Stopped", axes: [axis] })).not.toBe(key);
  });
});

describe("report of a scenario", () => {
  it("has its steps, as axisctl prints them", () => {
    const report = { seed: 1, seconds: 0.052, problem: "", steps: [{ step: 2, what: "expect frame", outcome: "failed", t: 0.001, text: "not within 50 ms" }] };
    expect(stepsOf(report)).toEqual([{ number: 2, text: "expect frame", t: 0.001, outcome: "failed", remark: "not within 50 ms" }]);
    expect(summaryOf(report)).toBe("seed 1, 0.052\u2009s");
  });
  it("has its steps, as a session holds them", () => {
    const report = { steps: [{ number: 1, text: "nmt start", t_s: 0.5, passed: true, remark: "" }] };
    expect(stepsOf(report)).toEqual([{ number: 1, text: "nmt start", t: 0.5, outcome: "passed", remark: "" }]);
  });
  it("may be missing", () => {
    expect(stepsOf(undefined)).toEqual([]);
    expect(stepsOf({ steps: "none" })).toEqual([]);
    expect(summaryOf(null)).toBe("");
  });
});
