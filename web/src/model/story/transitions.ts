import type { Command } from "../../canopen/words";
import type { Profile } from "../profile";

/** What moves the sequence control beside the controlword (docs/reference/sequence-control.md). */
export type Happening = "initialised" | "standstill" | "fault" | "acknowledged" | "measurement" | "voltage-lost";
export type Mover = Command | Happening;

type Table = Readonly<Record<string, Readonly<Record<string, readonly Mover[]>>>>;

/** What can lead from a state of the drive unit to another. */
const kMovers: Table = {
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

/** The same of an axis of CiA 402. */
const kMoversCia402: Table = {
  "Not ready to switch on": { "Switch on disabled": ["initialised"], Fault: ["fault"] },
  "Switch on disabled": { "Ready to switch on": ["shutdown"], Fault: ["fault"] },
  "Ready to switch on": {
    "Switched on": ["switch-on"],
    "Operation enabled": ["enable-operation"],
    "Switch on disabled": ["disable-voltage", "quick-stop"],
    Fault: ["fault"],
  },
  "Switched on": {
    "Ready to switch on": ["shutdown"],
    "Operation enabled": ["enable-operation"],
    "Switch on disabled": ["disable-voltage", "quick-stop", "voltage-lost"],
    Fault: ["fault"],
  },
  "Operation enabled": {
    "Ready to switch on": ["shutdown"],
    "Switched on": ["switch-on"],
    "Switch on disabled": ["disable-voltage", "voltage-lost"],
    "Quick stop active": ["quick-stop"],
    "Fault reaction active": ["fault"],
    Fault: ["fault"],
  },
  "Quick stop active": {
    "Operation enabled": ["enable-operation"],
    "Switch on disabled": ["standstill", "disable-voltage", "voltage-lost"],
    "Fault reaction active": ["fault"],
    Fault: ["fault"],
  },
  "Fault reaction active": { Fault: ["standstill", "voltage-lost"] },
  Fault: { "Switch on disabled": ["acknowledged"] },
};

/** What can have led from @param before to @param now; empty: the machine of @param profile has no such transition. */
export function moversOf(before: string, now: string, profile: Profile = "s120"): readonly Mover[] {
  return (profile === "cia402" ? kMoversCia402 : kMovers)[before]?.[now] ?? [];
}

/** Sentences of what happens by itself. */
export const kHappenings: Readonly<Record<Happening, string>> = {
  initialised: "The run-up of the drive is over.",
  standstill: "The drive has come to a standstill.",
  fault: "A fault has come.",
  acknowledged: "The fault was acknowledged.",
  measurement: "The measurement of the motor has ended.",
  "voltage-lost": "The DC link has lost its voltage.",
};
