import type { Profile } from "../model/profile";
import { objectText, signedOf, unsignedOf } from "./frame";
import { valueText } from "./value";
import { commandOf, controlwordBits, stateOf, statuswordBits, wordText, type BitRow } from "./words";

/** Thin space between a number and its unit. */
const kThin = "\u2009";

/** What is needed to show values in the units of a person. */
export interface Scaling {
  /** Increments a revolution of velocities and positions. */
  increments: number;
  /** "s120" if not given. An axis of CiA 402 has position units, which its objects 608Fh to 6092h make. */
  profile?: Profile | undefined;
}

type Words = (data: Uint8Array, scaling: Scaling) => { value: string; bits?: BitRow[] };

/** A number without more digits than it has. */
function digits(value: number, most = 6): string {
  return String(Number(value.toPrecision(most)));
}

const kVelocity: Words = (data, { increments }) => {
  const value = signedOf(data);
  return { value: `${digits((value * 60) / increments)}${kThin}rpm (${value} inc/s)` };
};
const kAcceleration: Words = (data, { increments }) => {
  const value = unsignedOf(data);
  return { value: `${digits((value * 60) / increments)}${kThin}rpm/s (${value} inc/s²)` };
};
const kPosition: Words = (data, { increments }) => {
  const value = signedOf(data);
  return { value: `${value}${kThin}inc (${digits(value / increments)} revolutions)` };
};
const kPerMille: Words = (data) => ({ value: `${signedOf(data)}${kThin}‰ of the rated value` });
const kRpm: Words = (data) => ({ value: `${signedOf(data)}${kThin}rpm` });
const kRpmUnsigned: Words = (data) => ({ value: `${unsignedOf(data)}${kThin}rpm` });
const kMilliseconds: Words = (data) => ({ value: `${unsignedOf(data)}${kThin}ms` });

/** Modes of operation (CiA 402, 10.3.2). */
const kModes: Readonly<Record<number, string>> = {
  0: "no mode",
  1: "profile position",
  2: "velocity",
  3: "profile velocity",
  4: "profile torque",
  6: "homing",
  7: "interpolated position",
  8: "cyclic synchronous position",
  9: "cyclic synchronous velocity",
  10: "cyclic synchronous torque",
};
const kMode: Words = (data) => {
  const mode = signedOf(data);
  return { value: `${mode}: ${kModes[mode] ?? (mode < 0 ? "of the manufacturer" : "reserved")}` };
};
const kControlword: Words = (data, { profile }) => {
  const word = unsignedOf(data);
  return { value: `${wordText(word)}: ${commandOf(word, profile)}`, bits: controlwordBits(word, profile) };
};
const kStatusword: Words = (data, { profile }) => {
  const word = unsignedOf(data);
  return { value: `${wordText(word)}: ${stateOf(word)}`, bits: statuswordBits(word, profile) };
};
/** A signed number in a unit; in position units nothing more can be said without the objects that make them. */
function signedIn(unit: string): Words {
  return (data) => ({ value: `${signedOf(data)}${kThin}${unit}` });
}
const kUnits = signedIn("units");
const kUnitsPerSecond = signedIn("units/s");
const kUnsignedUnits: Words = (data) => ({ value: `${unsignedOf(data)}${kThin}units` });
const kUnsignedUnitsPerSecond: Words = (data) => ({ value: `${unsignedOf(data)}${kThin}units/s` });
const kUnitsPerSecond2: Words = (data) => ({ value: `${unsignedOf(data)}${kThin}units/s²` });
const kIncrements: Words = signedIn("inc");
const kWindow: Words = (data, scaling) => (unsignedOf(data) === 0xffffffff ? { value: "off" } : kUnsignedUnits(data, scaling));
const kHomingMethod: Words = (data) => {
  const method = signedOf(data);
  return { value: method === 0 ? "0: none" : `method ${method}` };
};
const kMapping: Words = (data) => {
  const entry = unsignedOf(data);
  if (entry === 0) return { value: "nothing" };
  return { value: `${objectText(entry >>> 16, (entry >>> 8) & 0xff)}, ${entry & 0xff} bits` };
};
const kCobId: Words = (data) => {
  const cobId = unsignedOf(data);
  const id = wordText((cobId & 0x20000000) === 0 ? cobId & 0x7ff : cobId & 0x1fffffff, 3);
  return { value: `${id}${(cobId & 0x80000000) === 0 ? "" : ", not valid"} (${wordText(cobId, 8)})` };
};

/** Objects of CiA 402 by their index for axis 1; axis n has them 800h times (n - 1) higher. */
const kOfAxes: Readonly<Record<number, Words>> = {
  0x6040: kControlword,
  0x6041: kStatusword,
  0x6042: kRpm,
  0x6043: kRpm,
  0x6044: kRpm,
  0x6060: kMode,
  0x6061: kMode,
  0x6062: kPosition,
  0x6063: kPosition,
  0x6064: kPosition,
  0x6069: kVelocity,
  0x606b: kVelocity,
  0x606c: kVelocity,
  0x6071: kPerMille,
  0x6072: kPerMille,
  0x6074: kPerMille,
  0x6077: kPerMille,
  0x607a: kPosition,
  0x6080: kVelocity,
  0x6081: kVelocity,
  0x6083: kAcceleration,
  0x6084: kAcceleration,
  0x6085: kAcceleration,
  0x60ff: kVelocity,
};

/** Those that an axis of CiA 402 has in other units, or alone. */
const kOfCia402Axes: Readonly<Record<number, Words>> = {
  0x6062: kUnits,
  0x6063: kIncrements,
  0x6064: kUnits,
  0x6065: kWindow,
  0x6066: kMilliseconds,
  0x6067: kWindow,
  0x6068: kMilliseconds,
  0x6069: kIncrements,
  0x606b: kUnitsPerSecond,
  0x606c: kUnitsPerSecond,
  0x6073: kPerMille,
  0x6078: kPerMille,
  0x607a: kUnits,
  0x607c: kUnits,
  0x607f: kUnsignedUnitsPerSecond,
  0x6080: kRpmUnsigned,
  0x6081: kUnsignedUnitsPerSecond,
  0x6082: kUnsignedUnitsPerSecond,
  0x6083: kUnitsPerSecond2,
  0x6084: kUnitsPerSecond2,
  0x6085: kUnitsPerSecond2,
  0x6098: kHomingMethod,
  0x609a: kUnitsPerSecond2,
  0x60b0: kUnits,
  0x60b1: kUnitsPerSecond,
  0x60b2: kPerMille,
  0x60ba: kUnits,
  0x60bb: kUnits,
  0x60bc: kUnits,
  0x60bd: kUnits,
  0x60c5: kUnitsPerSecond2,
  0x60c6: kUnitsPerSecond2,
  0x60f4: kUnits,
  0x60fc: kIncrements,
  0x60ff: kUnitsPerSecond,
};

/** Objects of CiA 301: from index to index, sub-indices, how they are read. */
const kOfCommunication: readonly { from: number; to: number; sub: readonly [number, number]; words: Words }[] = [
  { from: 0x1005, to: 0x1005, sub: [0, 0], words: kCobId },
  { from: 0x100c, to: 0x100c, sub: [0, 0], words: kMilliseconds },
  { from: 0x1014, to: 0x1014, sub: [0, 0], words: kCobId },
  { from: 0x1017, to: 0x1017, sub: [0, 0], words: kMilliseconds },
  { from: 0x1200, to: 0x127f, sub: [1, 2], words: kCobId },
  { from: 0x1400, to: 0x15ff, sub: [1, 1], words: kCobId },
  { from: 0x1600, to: 0x17ff, sub: [1, 64], words: kMapping },
  { from: 0x1800, to: 0x19ff, sub: [1, 1], words: kCobId },
  { from: 0x1a00, to: 0x1bff, sub: [1, 64], words: kMapping },
];

const kFirstProfile = 0x6000;
const kProfileEnd = 0xa000;
const kOfAnAxis = 0x800;

/** The index that @param index of any axis has for axis 1. */
export function indexOfFirstAxis(index: number): number {
  if (index < kFirstProfile || index >= kProfileEnd) return index;
  return kFirstProfile + ((index - kFirstProfile) % kOfAnAxis);
}

/** The axis of an object of CiA 402, from 1; 0: it is of none. */
export function axisOfIndex(index: number): number {
  return index < kFirstProfile || index >= kProfileEnd ? 0 : 1 + Math.floor((index - kFirstProfile) / kOfAnAxis);
}

function wordsFor(index: number, subIndex: number, profile: Profile | undefined): Words | undefined {
  const first = indexOfFirstAxis(index);
  const own = (profile === "cia402" ? kOfCia402Axes[first] : undefined) ?? kOfAxes[first];
  if (own !== undefined && subIndex === 0) return own;
  const row = kOfCommunication.find((range) => index >= range.from && index <= range.to);
  return row !== undefined && subIndex >= row.sub[0] && subIndex <= row.sub[1] ? row.words : undefined;
}

/** What @param data says as the value of an object; @param dataType by the EDS, 0: unknown. */
export function objectWords(
  index: number,
  subIndex: number,
  data: Uint8Array,
  dataType: number,
  scaling: Scaling,
): { value: string; bits?: BitRow[] } {
  const words = wordsFor(index, subIndex, scaling.profile);
  if (words === undefined || data.length === 0 || data.length > 4) return { value: valueText(data, dataType) };
  return words(data, scaling);
}
