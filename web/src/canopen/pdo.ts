import type { Pdo } from "../source/types";
import type { Content, DecodedRow } from "./decoded";
import type { Eds } from "./eds";
import { hexOf, objectText, type CanFrame } from "./frame";
import { objectWords, type Scaling } from "./object_words";
import { identifierOf } from "./services";
import { rawText } from "./value";

/** A value in a PDO. */
export interface MappedValue {
  index: number;
  subIndex: number;
  name: string;
  bits: number;
  /** Place of its first bit in the data. */
  from: number;
}

const kObject = /^([0-9a-f]{4})h:([0-9a-f]{1,2})$/i;

/** Index and sub-index of "6040h:00"; undefined: it is none. */
export function parseObject(text: string): { index: number; subIndex: number } | undefined {
  const match = kObject.exec(text);
  if (match === null) return undefined;
  return { index: parseInt(match[1] ?? "", 16), subIndex: parseInt(match[2] ?? "", 16) };
}

/** What is mapped into @param pdo, where. */
export function mappingOf(pdo: Pdo): MappedValue[] {
  let from = 0;
  return pdo.mapping.map(({ object, bits, name }) => {
    const value = { index: 0, subIndex: 0, ...parseObject(object), name: name ?? "", bits, from };
    from += bits;
    return value;
  });
}

/** The bits of a mapped value as bytes, the least significant first. */
export function bytesAt(data: Uint8Array, from: number, bits: number): Uint8Array {
  if (from % 8 === 0 && bits % 8 === 0) return data.slice(from / 8, (from + bits) / 8);
  const bytes = new Uint8Array(Math.ceil(bits / 8));
  for (let i = 0; i < bits; ++i) {
    const bit = ((data[(from + i) >> 3] ?? 0) >> ((from + i) & 7)) & 1;
    bytes[i >> 3] = (bytes[i >> 3] ?? 0) | (bit << (i & 7));
  }
  return bytes;
}

/** A PDO with its values; @param eds for their names and types. */
export function decodePdo(frame: CanFrame, pdo: Pdo, eds: Eds | undefined, scaling: Scaling): Content {
  if (frame.isRemote) return { text: "remote request", rows: [] };
  const mapping = mappingOf(pdo);
  const bits = mapping.reduce((sum, value) => sum + value.bits, 0);
  const isShort = 8 * frame.data.length < bits;
  const rows = mapping
    .filter((value) => value.from + value.bits <= 8 * frame.data.length)
    .map((value) => rowOf(frame.data, value, eds, scaling));
  const text = rows.map((row) => `${row.name} ${row.value}`).join(", ");
  const content: Content = { text: text === "" ? "nothing mapped" : text, rows };
  if (!isShort) return content;
  return { ...content, remark: `${frame.data.length} bytes are fewer than the mapping has (${Math.ceil(bits / 8)})` };
}

function rowOf(data: Uint8Array, at: MappedValue, eds: Eds | undefined, scaling: Scaling): DecodedRow {
  const bytes = bytesAt(data, at.from, at.bits);
  const entry = eds?.find(at.index, at.subIndex);
  const words = objectWords(at.index, at.subIndex, bytes, entry?.dataType ?? 0, scaling);
  const name = eds?.nameOf(at.index, at.subIndex) ?? "";
  return {
    name: name === "" ? at.name || objectText(at.index, at.subIndex) : name,
    ...words,
    raw: at.bits <= 32 ? rawText(bytes.reduceRight((sum, byte) => sum * 256 + byte, 0), at.bits) : hexOf(bytes, " "),
    object: objectText(at.index, at.subIndex),
  };
}

/** Communication parameters of PDOs; an axis has 40h of them, the first eight are there. */
const kDirections = [
  { direction: "receive", communication: 0x1400, mapping: 0x1600, name: "RPDO" },
  { direction: "transmit", communication: 0x1800, mapping: 0x1a00, name: "TPDO" },
] as const;
const kOfAnAxis = 0x40;
const kMostAxes = 8;
const kMostMapped = 64;

/** The PDOs as the EDS has them at power-on; @param nodeId in place of $NODEID. */
export function pdosOfEds(eds: Eds, nodeId: number): Pdo[] {
  return kDirections.flatMap((row) =>
    Array.from({ length: kMostAxes * kOfAnAxis }, (_, place) => pdoOfEds(eds, nodeId, row, place)).filter(
      (pdo) => pdo !== undefined,
    ),
  );
}

function pdoOfEds(eds: Eds, nodeId: number, row: (typeof kDirections)[number], place: number): Pdo | undefined {
  const cobId = eds.defaultOf(row.communication + place, 1, nodeId);
  if (cobId === undefined) return undefined;
  const identifier = identifierOf(cobId);
  const count = Math.min(eds.defaultOf(row.mapping + place, 0) ?? 0, kMostMapped);
  const mapping = Array.from({ length: count }, (_, i) => eds.defaultOf(row.mapping + place, i + 1) ?? 0).map(
    (entry) => {
      const [index, subIndex] = [entry >>> 16, (entry >>> 8) & 0xff];
      return { object: objectText(index, subIndex), bits: entry & 0xff, name: eds.nameOf(index, subIndex) };
    },
  );
  return {
    pdo: `${row.name} ${(place % kOfAnAxis) + 1}`,
    axis: Math.floor(place / kOfAnAxis) + 1,
    direction: row.direction,
    object: `${(row.communication + place).toString(16).toUpperCase()}h`,
    cob_id: cobId,
    ...(identifier === undefined ? {} : { identifier: identifier.id }),
    is_valid: identifier !== undefined,
    is_active: identifier !== undefined,
    transmission_type: eds.defaultOf(row.communication + place, 2) ?? 254,
    length: Math.ceil(mapping.reduce((sum, value) => sum + value.bits, 0) / 8),
    mapping,
  };
}
