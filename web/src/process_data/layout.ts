import type { Pdo } from "../source/types";

/** What is mapped into a PDO, and which of its bits it has; bit 0 is the lowest of byte 0. */
export interface Field {
  /** 1.., in the order of the mapping. */
  number: number;
  object: string;
  name: string;
  firstBit: number;
  bits: number;
  /** The value of the object now; absent: it has none (a dummy). */
  value?: number;
}

/** The fields of @param pdo, in the order of its mapping. */
export function fieldsOf(pdo: Pdo): Field[] {
  let firstBit = 0;
  return pdo.mapping.map(({ object, bits, name, value }, at) => {
    const field: Field = { number: at + 1, object, name: name ?? "", firstBit, bits };
    if (value !== undefined) field.value = value;
    firstBit += bits;
    return field;
  });
}

/** The bytes of data as two hexadecimal digits each. */
export function bytesOf(data: string | undefined): number[] {
  return ((data ?? "").match(/[0-9a-f]{2}/gi) ?? []).map((digits) => parseInt(digits, 16));
}

/** The bits of @param field in @param bytes as a number without sign; undefined: the frame was too short. */
export function rawOf(field: Field, bytes: readonly number[]): bigint | undefined {
  const end = field.firstBit + field.bits;
  if (end > bytes.length * 8) return undefined;
  let all = 0n;
  bytes.forEach((byte, at) => (all |= BigInt(byte) << BigInt(8 * at)));
  return (all >> BigInt(field.firstBit)) & ((1n << BigInt(field.bits)) - 1n);
}

/** @param raw as `0F00h` with all digits of so many bits. */
export function hexOf(raw: bigint, bits: number): string {
  return `${raw.toString(16).toUpperCase().padStart(Math.ceil(bits / 4), "0")}h`;
}

/** Where a field is: `byte 0 to 1`, `byte 2`, `byte 3, bit 1 to 2`. */
export function positionText({ firstBit, bits }: Field): string {
  const lastBit = firstBit + bits - 1;
  const [first, last] = [firstBit >> 3, lastBit >> 3];
  if (firstBit % 8 === 0 && bits % 8 === 0) return first === last ? `byte ${first}` : `byte ${first} to ${last}`;
  const from = `byte ${first}, bit ${firstBit % 8}`;
  if (bits === 1) return from;
  return first === last ? `${from} to ${lastBit % 8}` : `${from} to byte ${last}, bit ${lastBit % 8}`;
}
