import { describe, expect, it } from "vitest";

import { cellsOf, kMeasures, levelOf, scaleOf, type MeasureName } from "../../../src/fleet/cells";
import { byName, byValue, countsOf, nextCell, unitsWith } from "../../../src/fleet/order";
import type { AxisOverview, UnitOverview } from "../../../src/source/types";

function axis(members: Partial<AxisOverview>): AxisOverview {
  const still = { speed_rpm: 0, setpoint_rpm: 0, torque_Nm: 0, current_A: 0, position: 0, motor_temperature_C: 20, faults: [], alarms: [] };
  return { axis: 1, name: "X", type: "servo", state: "Switched on", ...still, ...members };
}

function unit(name: string, axes: AxisOverview[], load?: number): UnitOverview {
  const bus = { state: "error-active", link: "up", received: 0, sent: 0 };
  return { unit: name, on: true, bus: load === undefined ? bus : { ...bus, load_percent: load }, axes };
}

const kUnits: UnitOverview[] = [
  unit("vcan0/10", [axis({ speed_rpm: -1400, state: "Operation enabled" }), axis({ axis: 2, name: "Y" })], 55),
  unit("vcan0/5", [axis({ state: "Fault", faults: [{ number: 7900, text: "Motor blocked" }], motor_temperature_C: 95 })]),
  { unit: "vcan1/1", on: false, error: "the daemon cannot be reached" },
];

describe("cells", () => {
  it("are one an axis, and one for a unit that is silent", () => {
    const cells = cellsOf("state", kUnits);
    expect(cells.map((cell) => [cell.unit, cell.axis, cell.text])).toEqual([
      ["vcan0/10", 1, "E"], ["vcan0/10", 2, "S"], ["vcan0/5", 1, "F"], ["vcan1/1", 0, "off"],
    ]);
    expect(cells[3]?.words).toBe("off, the daemon cannot be reached");
  });
  it("have the colour of their share of the scale, whatever the direction", () => {
    expect(scaleOf("speed", kUnits)).toBe(2000);
    expect(cellsOf("speed", kUnits).map((cell) => cell.look)).toEqual(["heat-3", "heat-0", "heat-0", "fleet-silent"]);
  });
  it("are one a unit for the bus", () => {
    expect(cellsOf("load", kUnits).map((cell) => [cell.axis, cell.text])).toEqual([[0, "55"], [0, "–"], [0, "off"]]);
  });
  it("name faults, and lead to the first", () => {
    const cell = cellsOf("faults", kUnits)[2];
    expect([cell?.text, cell?.words, cell?.fault]).toEqual(["F1", "F1, 7900 Motor blocked", 7900]);
  });
  it("have text and words for every measure", () => {
    for (const name of Object.keys(kMeasures) as MeasureName[])
      for (const cell of cellsOf(name, kUnits)) expect([cell.text, cell.words, cell.look].every((word) => word !== "")).toBe(true);
  });
  it("have five levels of heat", () => {
    expect([-1, 0, 0.2, 0.99, 1, 7].map(levelOf)).toEqual([0, 0, 1, 4, 4, 4]);
  });
});

describe("order", () => {
  it("is by bus and number of the node", () => {
    expect(["vcan1/1", "vcan0/10", "vcan0/5", "vcan10/1", "vcan2/1"].sort(byName)).toEqual(["vcan0/5", "vcan0/10", "vcan1/1", "vcan2/1", "vcan10/1"]);
  });
  it("is by value, the greatest first", () => {
    expect(byValue(cellsOf("temperature", kUnits)).map((cell) => cell.text)).toEqual(["95", "20", "20", "off"]);
  });
  it("finds units by all words", () => {
    expect(unitsWith("vcan0 fault", kUnits).map((each) => each.unit)).toEqual(["vcan0/5"]);
    expect(unitsWith("reached", kUnits).map((each) => each.unit)).toEqual(["vcan1/1"]);
    expect(unitsWith(" ", kUnits).map((each) => each.unit)).toEqual(["vcan0/5", "vcan0/10", "vcan1/1"]);
  });
  it("counts states in the order that never changes", () => {
    expect(countsOf(cellsOf("state", kUnits))).toEqual([["Switched on", 1], ["Operation enabled", 1], ["Fault", 1], ["off", 1]]);
  });
});

describe("arrow keys", () => {
  const spots = [0, 50, 100, 0, 50].map((left, index) => ({ left, top: index < 3 ? 0 : 40 }));
  it("go along the row and to the nearest cell of the next one", () => {
    expect(nextCell(spots, 0, "ArrowRight")).toBe(1);
    expect(nextCell(spots, 1, "ArrowDown")).toBe(4);
    expect(nextCell(spots, 2, "ArrowDown")).toBe(4);
    expect(nextCell(spots, 3, "ArrowUp")).toBe(0);
    expect(nextCell(spots, 2, "ArrowRight")).toBe(3);
  });
  it("stay at the ends, and leave other keys alone", () => {
    expect(nextCell(spots, 0, "ArrowUp")).toBe(0);
    expect(nextCell(spots, 4, "End")).toBe(4);
    expect(nextCell(spots, 4, "Home")).toBe(0);
    expect(nextCell(spots, 4, "a")).toBeUndefined();
  });
});
