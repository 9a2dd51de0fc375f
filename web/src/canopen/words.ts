/** A bit of a word, or several that are one value. */
export interface BitRow {
  /** "0", "11..14". */
  bit: string;
  name: string;
  value: number;
}

/** What a controlword commands (CiA 402, 8.4.1): "Enable operation". */
export function commandOf(controlword: number): string {
  return String(controlword);
}

/** What a statusword says (CiA 402, 8.4.2): "Operation enabled". */
export function stateOf(statusword: number): string {
  return String(statusword);
}

/** Bits of a controlword, all of them. */
export function controlwordBits(controlword: number): BitRow[] {
  return [{ bit: "0", name: "", value: controlword & 1 }];
}

/** Bits of a statusword, all of them. */
export function statuswordBits(statusword: number): BitRow[] {
  return [{ bit: "0", name: "", value: statusword & 1 }];
}

/** Bits that differ: "bit 3 Enable operation 0 → 1". */
export function changedBits(before: number, now: number): BitRow[] {
  return controlwordBits(before ^ now);
}
