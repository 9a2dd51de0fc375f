/** A value of the dictionary: an object without sub-objects, or one of them. */
export interface EdsEntry {
  index: number;
  subIndex: number;
  name: string;
  /** Of the object that it is a part of; empty: it is the object. */
  objectName: string;
  /** CiA 301, 7.4.7.1: 5 = UNSIGNED8, ... */
  dataType: number;
  /** ro, wo, rw, rww, rwr, const. */
  access: string;
  isMappable: boolean;
  /** As it stands in the file: "$NODEID+0x200". */
  defaultText: string;
  lowText: string;
  highText: string;
}

/** What an EDS says of a device, as far as decoding needs it (CiA 306). */
export interface Eds {
  fileName: string;
  productName: string;
  entries: ReadonlyMap<number, EdsEntry>;
  /** Lines that were left out, and why. */
  remarks: readonly string[];
  find(index: number, subIndex: number): EdsEntry | undefined;
  /** "Controlword", "Identity Object: Vendor Id"; empty: unknown. */
  nameOf(index: number, subIndex: number): string;
  /** Its default as a number, with @param nodeId in place of $NODEID; undefined: it has none. */
  defaultOf(index: number, subIndex: number, nodeId?: number): number | undefined;
}

/** The EDS in @param text; a Refusal with line and reason if it is none. */
export function parseEds(text: string, fileName = ""): Eds {
  throw new Error(`not yet: ${fileName} ${text.length}`);
}
