import type { ParameterEntry } from "../../../src/source/types";

/** A parameter of axis 1, with what @param over says otherwise. */
export function entry(over: Partial<ParameterEntry>): ParameterEntry {
  return {
    axis: 1,
    drive_object: 2,
    parameter: "p1120",
    number: 1120,
    index: 0,
    indices: 1,
    name: "RFG ramp-up time",
    effect: "ramp from zero to p1082",
    value: 10,
    unit: "s",
    type: "F32",
    access: "read-write",
    writable: true,
    ...over,
  };
}

/** A status word that p2549 takes bit 2 of. */
export const kWord = entry({
  parameter: "r0899",
  number: 899,
  name: "Status word sequence control",
  effect: "true value",
  unit: "",
  type: "U16",
  value: 0x2c4,
  access: "read-only",
  writable: false,
  uses: 2,
  used_by: [
    { axis: 1, parameter: "p2549", position: 2 },
    { axis: 2, parameter: "p0840", position: 2 },
  ],
});

/** An input that takes it. */
export const kInput = entry({
  parameter: "p2549",
  number: 2549,
  name: "BI: LR enable 1",
  effect: "wiring stored",
  unit: "",
  type: "BI",
  value: "r0899.2",
  source: { axis: 1, parameter: "r0899.2", position: 2, name: "Status word sequence control", value: 1 },
});
