import type { Command } from "../../canopen/words";

/** What moves the sequence control beside the controlword (docs/reference/sequence-control.md). */
export type Happening = "initialised" | "standstill" | "fault" | "acknowledged" | "measurement";
export type Mover = Command | Happening;

/** What can lead from a state to another. */
const kMovers: Readonly<Record<string, Readonly<Record<string, readonly Mover[]>>>> = {
  "Not ready to switch on": { "Switch on disabled": ["initialised"], Fault: ["fault"] },
  "Switch on disabled": { "Ready to switch on": ["shutdown"], Fault: ["fault"] },
  "Ready to switch on": {
    "Switched on": ["switch-on", "enable-operation"],
    "Operation enabled": ["enable-operation"],
    "Switch on disabled": ["disable-voltage", "quick-stop"],
    Fault: ["fault"],
  },
  "Switched on": {
    "Ready to switch on": ["shutdown"],
    "Operation enabled": ["enable-operation"],
    "Switch on disabled": ["disable-voltage", "quick-stop"],
    Fault: ["fault"],
  },
  "Operation enabled": {
    "OFF1 braking": ["shutdown"],
    "Ready to switch on": ["shutdown"],
    "Switched on": ["switch-on"],
    "Switch on disabled": ["disable-voltage", "measurement"],
    "Quick stop active": ["quick-stop"],
    "Fault reaction active": ["fault"],
    STOP2: ["fault"],
    Fault: ["fault"],
  },
  "OFF1 braking": {
    "Switched on": ["switch-on"],
    "Operation enabled": ["enable-operation"],
    "Switch on disabled": ["disable-voltage"],
    "Quick stop active": ["quick-stop"],
    "Ready to switch on": ["standstill"],
    "Fault reaction active": ["fault"],
    Fault: ["fault"],
  },
  "Quick stop active": {
    "Switch on disabled": ["standstill", "disable-voltage"],
    "Fault reaction active": ["fault"],
    Fault: ["fault"],
  },
  "Fault reaction active": { Fault: ["standstill", "disable-voltage", "fault"] },
  STOP2: {
    "Fault reaction active": ["shutdown", "quick-stop", "fault"],
    Fault: ["disable-voltage", "fault"],
    "Switch on disabled": ["acknowledged"],
  },
  Fault: { "Switch on disabled": ["acknowledged"] },
};

/** What can have led from @param before to @param now; empty: the machine has no such transition. */
export function moversOf(before: string, now: string): readonly Mover[] {
  return kMovers[before]?.[now] ?? [];
}

/** Sentences of what happens by itself. */
export const kHappenings: Readonly<Record<Happening, string>> = {
  initialised: "The run-up of the drive is over.",
  standstill: "The drive has come to a standstill.",
  fault: "A fault has come.",
  acknowledged: "The fault was acknowledged.",
  measurement: "The measurement of the motor has ended.",
};
