import type { AxisOverview, UnitOverview } from "../source/types";
import { fixed } from "../ui/number";
import { lookOf } from "../ui/state_words";

/** What the map shows. */
export type MeasureName = "state" | "speed" | "torque" | "load" | "temperature" | "faults";

/** A cell of the map. */
export interface Cell {
  key: string;
  unit: string;
  /** 0: the unit as a whole. */
  axis: number;
  /** In the cell: a letter, or a figure. */
  text: string;
  /** Class of its colour: of a state, or heat-0..heat-4. */
  look: string;
  /** What it says in words. */
  words: string;
  /** By which cells are sorted, the greatest first. */
  value: number;
  /** State of the axis, by which cells are counted. */
  state: string;
  /** Number of its first fault, whose cause can be shown. */
  fault: number | undefined;
}

/** What is shown of an axis, or of a unit. */
interface Shown {
  text: string;
  look: string;
  words: string;
  value: number;
}

interface Measure {
  title: string;
  isOfUnit: boolean;
  /** The largest magnitude there is, for the scale; 0: it is fixed. */
  scaleOf: (unit: UnitOverview, axis?: AxisOverview) => number;
  show: (unit: UnitOverview, axis: AxisOverview | undefined, scale: number) => Shown;
}

/** Levels of the scale of colours. */
export const kLevels = 5;

/** The level of @param share of the whole, 0..1. */
export function levelOf(share: number): number {
  return Math.max(0, Math.min(kLevels - 1, Math.floor(share * kLevels)));
}

function heat(value: number, scale: number, text: string, words: string): Shown {
  return { text, words, value: Math.abs(value), look: `heat-${scale === 0 ? 0 : levelOf(Math.abs(value) / scale)}` };
}

/** States in the order of how much they want to be looked at. */
const kRanks: Record<string, number> = { fault: 5, brake: 4, run: 3, on: 2, ready: 1, off: 0 };

function showState(axis: AxisOverview): Shown {
  const look = lookOf(axis.state);
  return { text: look.letter, look: `tone-${look.tone}`, words: axis.state, value: kRanks[look.tone] ?? 0 };
}

function showFaults(axis: AxisOverview): Shown {
  const names = [...axis.faults, ...axis.alarms].map((message) => `${message.number} ${message.text}`).join(", ");
  const look = axis.faults.length > 0 ? "tone-fault" : axis.alarms.length > 0 ? "tone-brake" : "tone-off";
  const text = axis.faults.length > 0 ? `F${axis.faults.length}` : axis.alarms.length > 0 ? `A${axis.alarms.length}` : "–";
  return { text, look, words: names === "" ? "no fault" : `${text}, ${names}`, value: axis.faults.length * 100 + axis.alarms.length };
}

const kCold = 20;
const kHot = 120;

function showLoad(unit: UnitOverview): Shown {
  const load = unit.bus?.load_percent;
  if (load === undefined) return { text: "–", look: "heat-0", words: "load of the bus unknown", value: -1 };
  return heat(load, 100, fixed(load, 0), `load of the bus ${fixed(load, 0, "%")}`);
}

/** An axis that has no figures is never asked for them. */
function ofAxis(show: (axis: AxisOverview, scale: number) => Shown): Measure["show"] {
  return (_, axis, scale) => (axis === undefined ? { text: "–", look: "tone-off", words: "", value: -1 } : show(axis, scale));
}

/** One row a measure. */
export const kMeasures: Record<MeasureName, Measure> = {
  state: { title: "State", isOfUnit: false, scaleOf: () => 0, show: ofAxis(showState) },
  speed: {
    title: "Speed",
    isOfUnit: false,
    scaleOf: (_, axis) => Math.abs(axis?.speed_rpm ?? 0),
    show: ofAxis((axis, scale) => heat(axis.speed_rpm, scale, fixed(axis.speed_rpm, 0), fixed(axis.speed_rpm, 0, "rpm"))),
  },
  torque: {
    title: "Torque",
    isOfUnit: false,
    scaleOf: (_, axis) => Math.abs(axis?.torque_Nm ?? 0),
    show: ofAxis((axis, scale) => heat(axis.torque_Nm, scale, fixed(axis.torque_Nm, 1), fixed(axis.torque_Nm, 1, "N·m"))),
  },
  load: { title: "Load of the bus", isOfUnit: true, scaleOf: () => 0, show: showLoad },
  temperature: {
    title: "Motor temperature",
    isOfUnit: false,
    scaleOf: () => 0,
    show: ofAxis((axis) => {
      const value = axis.motor_temperature_C;
      return { ...heat(value - kCold, kHot - kCold, fixed(value, 0), fixed(value, 0, "°C")), value };
    }),
  },
  faults: { title: "Faults", isOfUnit: false, scaleOf: () => 0, show: ofAxis(showFaults) },
};

/** The end of the scale of @param name: 1, 2 or 5 times a power of ten, so that it seldom moves. */
export function scaleOf(name: MeasureName, units: readonly UnitOverview[]): number {
  const { scaleOf: of } = kMeasures[name];
  const most = units.reduce((high, unit) => Math.max(high, of(unit), ...(unit.axes ?? []).map((axis) => of(unit, axis))), 0);
  if (most === 0) return 0;
  const power = 10 ** Math.floor(Math.log10(most));
  return power * ([1, 2, 5, 10].find((step) => step * power >= most) ?? 10);
}

function silentCell(unit: UnitOverview): Cell {
  const words = `off${unit.error === undefined ? "" : `, ${unit.error}`}`;
  return { key: unit.unit, unit: unit.unit, axis: 0, text: "off", look: "fleet-silent", words, value: -2, state: "off", fault: undefined };
}

function cellOf(name: MeasureName, unit: UnitOverview, axis: AxisOverview | undefined, scale: number): Cell {
  const shown = kMeasures[name].show(unit, axis, scale);
  return {
    ...shown,
    key: axis === undefined ? unit.unit : `${unit.unit} ${axis.axis}`,
    unit: unit.unit,
    axis: axis?.axis ?? 0,
    state: axis?.state ?? "",
    fault: axis?.faults[0]?.number,
  };
}

/** The cells of all units, in the order of @param units: one an axis, or one a unit. */
export function cellsOf(name: MeasureName, units: readonly UnitOverview[]): Cell[] {
  const scale = scaleOf(name, units);
  return units.flatMap((unit) => {
    if (!unit.on) return [silentCell(unit)];
    if (kMeasures[name].isOfUnit) return [cellOf(name, unit, undefined, scale)];
    return (unit.axes ?? []).map((axis) => cellOf(name, unit, axis, scale));
  });
}
