import type { Profile } from "../model/profile";

/** A bit of a word, or several that are one value. */
export interface BitRow {
  /** "0", "11..14". */
  bit: string;
  name: string;
  value: number;
}

/** Commands of the controlword by its bits 0 to 3 and 7 (CiA 402, 8.4.1; sequence control of a SINAMICS). */
const kCommands = [
  { mask: 0x0002, value: 0x0000, command: "disable-voltage", text: "Disable voltage (OFF2)" },
  { mask: 0x0006, value: 0x0002, command: "quick-stop", text: "Quick stop (OFF3)" },
  { mask: 0x0007, value: 0x0006, command: "shutdown", text: "Shutdown (OFF1)" },
  { mask: 0x000f, value: 0x0007, command: "switch-on", text: "Switch on" },
  { mask: 0x000f, value: 0x000f, command: "enable-operation", text: "Enable operation" },
] as const;

export type Command = (typeof kCommands)[number]["command"];

/** The command in bits 0 to 3 of @param controlword; each has exactly one. */
export function commandKind(controlword: number): Command {
  return kCommands.find((row) => (controlword & row.mask) === row.value)?.command ?? "disable-voltage";
}

/** @param text as a device of @param profile has it: only the drive unit speaks of OFF1 to OFF3 and its parameters. */
function ofProfile(text: string, profile: Profile): string {
  return profile === "s120" ? text : text.replace(/ \([^)]*(OFF\d|r8890\.\d+|p878\d)\)$/, "");
}

/** What a controlword commands (CiA 402, 8.4.1): "Enable operation", "Shutdown (OFF1), fault reset". */
export function commandOf(controlword: number, profile: Profile = "s120"): string {
  const text = ofProfile(kCommands.find((row) => (controlword & row.mask) === row.value)?.text ?? "", profile);
  const more = [(controlword & 0x80) === 0 ? "" : "fault reset", (controlword & 0x100) === 0 ? "" : "halt"];
  return [text, ...more.filter((word) => word !== "")].join(", ");
}

/** States of the statusword (CiA 402, 8.4.2). */
const kStates = [
  { mask: 0x004f, value: 0x0000, state: "Not ready to switch on" },
  { mask: 0x004f, value: 0x0040, state: "Switch on disabled" },
  { mask: 0x006f, value: 0x0021, state: "Ready to switch on" },
  { mask: 0x006f, value: 0x0023, state: "Switched on" },
  { mask: 0x006f, value: 0x0027, state: "Operation enabled" },
  { mask: 0x006f, value: 0x0007, state: "Quick stop active" },
  { mask: 0x000f, value: 0x000f, state: "Fault reaction active" },
  { mask: 0x000f, value: 0x0008, state: "Fault" },
];

/** What a statusword says (CiA 402, 8.4.2): "Operation enabled". Of the state before OFF2 and OFF3 bit 5 is left out. */
export function stateOf(statusword: number): string {
  const exact = kStates.find((row) => (statusword & row.mask) === row.value);
  return exact?.state ?? "no state of CiA 402";
}

/** Bits of 6040h (CiA 402, 8.4.1); 4 to 6 and 9 depend on the mode. */
const kControlword = [
  "Switch on (ON/OFF1)",
  "Enable voltage (no OFF2)",
  "Quick stop (no OFF3)",
  "Enable operation",
  "of the mode: enable ramp, new set-point, homing start",
  "of the mode: unfreeze ramp, change set immediately",
  "of the mode: reference ramp, absolute / relative",
  "Fault reset",
  "Halt",
  "of the mode: change on set-point",
  "reserved",
  "of the manufacturer (r8890.11)",
  "of the manufacturer (r8890.12)",
  "of the manufacturer (r8890.13)",
  "of the manufacturer (r8890.14)",
  "of the manufacturer (r8890.15)",
];

/** Bits of 6041h (CiA 402, 8.4.2); 8, 14 and 15 are those of p8785, p8786 and p8787. */
const kStatusword = [
  "Ready to switch on",
  "Switched on",
  "Operation enabled",
  "Fault",
  "Voltage enabled (no OFF2)",
  "Quick stop (no OFF3)",
  "Switch on disabled",
  "Warning (alarm)",
  "of the manufacturer (p8785)",
  "Remote",
  "Target reached",
  "Internal limit active",
  "of the mode: speed 0, set-point acknowledge, homing attained",
  "of the mode: following error, maximum slippage",
  "of the manufacturer (p8786)",
  "of the manufacturer (p8787)",
];

/** Bits of 6041h that an axis of CiA 402 names otherwise. */
const kStatuswordCia402: Readonly<Record<number, string>> = {
  12: "of the mode: set-point acknowledge, speed 0, homing attained, drive follows the command value",
  13: "of the mode: following error, maximum slippage, homing error",
  14: "reserved",
  15: "Homed",
};

function bitsOf(names: readonly string[], word: number, profile: Profile): BitRow[] {
  return names.map((name, bit) => ({ bit: String(bit), name: ofProfile(name, profile), value: (word >> bit) & 1 }));
}

/** Bits of a controlword, all of them. */
export function controlwordBits(controlword: number, profile: Profile = "s120"): BitRow[] {
  return bitsOf(kControlword, controlword, profile);
}

/** Bits of a statusword, all of them. */
export function statuswordBits(statusword: number, profile: Profile = "s120"): BitRow[] {
  const names = profile === "s120" ? kStatusword : kStatusword.map((name, bit) => kStatuswordCia402[bit] ?? name);
  return bitsOf(names, statusword, profile);
}

/** The bits of two controlwords that differ, with their new values. */
export function changedBits(before: number, now: number, profile: Profile = "s120"): BitRow[] {
  return controlwordBits(now, profile).filter((_, bit) => (((before ^ now) >> bit) & 1) === 1);
}

/** A changed bit in words: "bit 3 Enable operation: 0 → 1". */
export function changeText(row: BitRow): string {
  return `bit ${row.bit} ${row.name}: ${1 - row.value} → ${row.value}`;
}

/** A word as 0x000F. */
export function wordText(value: number, digits = 4): string {
  return `0x${(value >>> 0).toString(16).toUpperCase().padStart(digits, "0")}`;
}
