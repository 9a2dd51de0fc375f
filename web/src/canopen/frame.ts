/** A CAN frame as a unit has received or sent it. */
export interface CanFrame {
  /** Seconds since the start of the unit. */
  t: number;
  /** By the unit; of a log that does not know it, by the predefined connection set. */
  sent: boolean;
  isRemote: boolean;
  /** Whether the identifier has 29 bits. */
  isExtended: boolean;
  id: number;
  /** Data length code; a remote frame has one, too. */
  length: number;
  /** As many bytes as the length says; none of a remote frame. */
  data: Uint8Array;
}

/** Flags of a frame in stores and recordings (docs/reference/recording.md). */
export const kSent = 1;
/** It asks for a frame. */
export const kRemote = 2;
/** Identifier of 29 bits. */
export const kExtended = 4;

/** Identifier as candump has it: 3 or 8 hexadecimal digits. */
export function identifierText(id: number, isExtended = false): string {
  return id.toString(16).toUpperCase().padStart(isExtended ? 8 : 3, "0");
}

/** Bytes as hexadecimal digits, @param between two of them. */
export function hexOf(data: Uint8Array, between = ""): string {
  return Array.from(data, (byte) => byte.toString(16).toUpperCase().padStart(2, "0")).join(between);
}

/** id#data as candump has it: 205#0F00, 705#R1. */
export function frameText(frame: CanFrame): string {
  const content = frame.isRemote ? `R${frame.length}` : hexOf(frame.data);
  return `${identifierText(frame.id, frame.isExtended)}#${content}`;
}

/** A number as 6040h. */
export function hexText(value: number, digits: number): string {
  return `${(value >>> 0).toString(16).toUpperCase().padStart(digits, "0")}h`;
}

/** An object of the dictionary as 6040h:00. */
export function objectText(index: number, subIndex: number): string {
  return `${hexText(index, 4)}:${subIndex.toString(16).toUpperCase().padStart(2, "0")}`;
}

/** @param size bytes from @param at on, the least significant first. Sizes above 6 lose digits: take bigOf() for them. */
export function unsignedOf(data: Uint8Array, at = 0, size = data.length - at): number {
  let value = 0;
  for (let i = size - 1; i >= 0; --i) value = value * 256 + (data[at + i] ?? 0);
  return value;
}

/** The same as a signed number of so many bytes. */
export function signedOf(data: Uint8Array, at = 0, size = data.length - at): number {
  const value = unsignedOf(data, at, size);
  return value >= 2 ** (8 * size - 1) ? value - 2 ** (8 * size) : value;
}

/** The same without loss. */
export function bigOf(data: Uint8Array, at = 0, size = data.length - at): bigint {
  let value = 0n;
  for (let i = size - 1; i >= 0; --i) value = (value << 8n) | BigInt(data[at + i] ?? 0);
  return value;
}
