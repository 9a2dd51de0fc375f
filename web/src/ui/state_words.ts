import type { DriveState } from "../source/types";

/** How a drive state looks: a tone of the palette, and a letter for who does not see colours. */
export interface StateLook {
  tone: "off" | "ready" | "on" | "run" | "brake" | "fault";
  letter: string;
}

/** One row a state. */
export const kStateLooks: Record<DriveState, StateLook> = {
  "Not ready to switch on": { tone: "off", letter: "N" },
  "Switch on disabled": { tone: "off", letter: "D" },
  "Ready to switch on": { tone: "ready", letter: "R" },
  "Switched on": { tone: "on", letter: "S" },
  "Operation enabled": { tone: "run", letter: "E" },
  "OFF1 braking": { tone: "brake", letter: "1" },
  "Quick stop active": { tone: "brake", letter: "Q" },
  "Fault reaction active": { tone: "fault", letter: "A" },
  STOP2: { tone: "fault", letter: "2" },
  Fault: { tone: "fault", letter: "F" },
};

/** The look of @param state, also of one that this page does not know. */
export function lookOf(state: string): StateLook {
  return (kStateLooks as Record<string, StateLook | undefined>)[state] ?? { tone: "off", letter: "?" };
}
