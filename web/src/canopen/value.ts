import { bigOf, hexOf, signedOf, unsignedOf } from "./frame";
import { wordText } from "./words";

/** How a data type of CiA 301, 7.4.7.1 is read. */
interface TypeRow {
  name: string;
  /** Bytes; 0: as many as there are. */
  size: number;
  read: (data: Uint8Array) => string;
}

const kUnsigned = (data: Uint8Array): string => {
  const value = data.length > 6 ? bigOf(data) : unsignedOf(data);
  return `${value} (0x${value.toString(16).toUpperCase()})`;
};
const kSigned = (data: Uint8Array): string =>
  data.length > 6 ? String(BigInt.asIntN(8 * data.length, bigOf(data))) : String(signedOf(data));
const kReal = (data: Uint8Array): string => {
  const view = new DataView(data.buffer, data.byteOffset, data.length);
  return data.length === 8 ? String(view.getFloat64(0, true)) : String(Math.fround(view.getFloat32(0, true)));
};
const kText = (data: Uint8Array): string => `"${new TextDecoder("latin1").decode(data).replace(/\0+$/, "")}"`;
const kBytes = (data: Uint8Array): string => hexOf(data, " ");

const kTypes: Readonly<Record<number, TypeRow>> = {
  0x01: { name: "BOOLEAN", size: 1, read: (data) => (data[0] === 0 ? "false" : "true") },
  0x02: { name: "INTEGER8", size: 1, read: kSigned },
  0x03: { name: "INTEGER16", size: 2, read: kSigned },
  0x04: { name: "INTEGER32", size: 4, read: kSigned },
  0x05: { name: "UNSIGNED8", size: 1, read: kUnsigned },
  0x06: { name: "UNSIGNED16", size: 2, read: kUnsigned },
  0x07: { name: "UNSIGNED32", size: 4, read: kUnsigned },
  0x08: { name: "REAL32", size: 4, read: kReal },
  0x09: { name: "VISIBLE_STRING", size: 0, read: kText },
  0x0a: { name: "OCTET_STRING", size: 0, read: kBytes },
  0x0b: { name: "UNICODE_STRING", size: 0, read: (data) => `"${new TextDecoder("utf-16le").decode(data)}"` },
  0x0c: { name: "TIME_OF_DAY", size: 6, read: kBytes },
  0x0d: { name: "TIME_DIFFERENCE", size: 6, read: kBytes },
  0x0f: { name: "DOMAIN", size: 0, read: kBytes },
  0x10: { name: "INTEGER24", size: 3, read: kSigned },
  0x11: { name: "REAL64", size: 8, read: kReal },
  0x12: { name: "INTEGER40", size: 5, read: kSigned },
  0x13: { name: "INTEGER48", size: 6, read: kSigned },
  0x14: { name: "INTEGER56", size: 7, read: kSigned },
  0x15: { name: "INTEGER64", size: 8, read: kSigned },
  0x16: { name: "UNSIGNED24", size: 3, read: kUnsigned },
  0x18: { name: "UNSIGNED40", size: 5, read: kUnsigned },
  0x19: { name: "UNSIGNED48", size: 6, read: kUnsigned },
  0x1a: { name: "UNSIGNED56", size: 7, read: kUnsigned },
  0x1b: { name: "UNSIGNED64", size: 8, read: kUnsigned },
};

/** "UNSIGNED16"; empty: unknown. */
export function typeName(dataType: number): string {
  return kTypes[dataType]?.name ?? "";
}

/** Whether numbers of @param dataType have a sign. */
export function isSigned(dataType: number): boolean {
  return kTypes[dataType]?.read === kSigned;
}

/** @param data as a value of @param dataType; an unknown type (0) of up to 8 bytes is shown as a number. */
export function valueText(data: Uint8Array, dataType: number): string {
  const type = kTypes[dataType];
  if (data.length === 0) return "no bytes";
  if (type === undefined) return data.length <= 8 ? kUnsigned(data) : kBytes(data);
  if (type.size === 0) return type.read(data);
  if (data.length < type.size) return `${hexOf(data, " ")} (too short for ${type.name})`;
  return type.read(data.subarray(0, type.size));
}

/** The range of a word of so many bits, as 0x000F. */
export function rawText(value: number, bits: number): string {
  return wordText(value, Math.max(Math.ceil(bits / 4), 1));
}
