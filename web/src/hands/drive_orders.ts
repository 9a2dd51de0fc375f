/** What the controlword of an axis can command (CiA 402, 8.4.1). */
export const kOrders = [
  { value: 0x0006, title: "Shutdown" },
  { value: 0x0007, title: "Switch on" },
  { value: 0x000f, title: "Enable operation" },
  { value: 0x0002, title: "Quick stop" },
  { value: 0x0000, title: "Disable voltage" },
  { value: 0x0080, title: "Fault reset" },
] as const;

/** Modes of operation (CiA 402, 10.3.2). */
export const kModes = [
  { value: 0, title: "no mode" },
  { value: 1, title: "profile position" },
  { value: 2, title: "velocity" },
  { value: 3, title: "profile velocity" },
  { value: 4, title: "profile torque" },
  { value: 6, title: "homing" },
  { value: 7, title: "interpolated position" },
  { value: 8, title: "cyclic synchronous position" },
  { value: 9, title: "cyclic synchronous velocity" },
  { value: 10, title: "cyclic synchronous torque" },
] as const;

/** The controlwords that give the order @param value in @param state: only a rising bit 7 resets a fault. */
export function wordsFor(value: number, state: string | undefined): readonly number[] {
  return (value & 0x80) !== 0 && state === "Fault" ? [0, value] : [value];
}

/** Distance of the objects of two axes. */
const kOfAnAxis = 0x800;

/** The index that @param index of the first axis has for @param axis, as an address has it: "6840". */
export function indexFor(index: number, axis: number): string {
  return (index + (axis - 1) * kOfAnAxis).toString(16).toUpperCase().padStart(4, "0");
}
