import { Refusal } from "../source/refusal";
import { readIni, type IniSection } from "./ini";

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
  /** Keys are 256 times the index, plus the sub-index. */
  entries: ReadonlyMap<number, EdsEntry>;
  /** Lines that were left out, and why. */
  remarks: readonly string[];
  find(index: number, subIndex: number): EdsEntry | undefined;
  /** "Controlword", "Identity Object: Vendor Id"; empty: unknown. */
  nameOf(index: number, subIndex: number): string;
  /** Its default as a number, with @param nodeId in place of $NODEID; undefined: it has none. */
  defaultOf(index: number, subIndex: number, nodeId?: number): number | undefined;
}

/** Object types of CiA 301, 7.4.3 whose values are sub-objects. */
const kDefType = 6;
const kArray = 8;
const kRecord = 9;

const kObject = /^([0-9a-f]{4})$/i;
const kSubObject = /^([0-9a-f]{4})sub([0-9a-f]{1,2})$/i;
const kCompactPart = /^([0-9a-f]{4})(name|value)$/i;

function keyOf(index: number, subIndex: number): number {
  return index * 256 + subIndex;
}

/** A number as an EDS has it: decimal, 0x.., octal with a 0 in front; undefined: none. */
function edsNumber(text: string): number | undefined {
  if (/^0x[0-9a-f]+$/i.test(text) || /^-?([1-9]\d*|0)$/.test(text)) return Number(text);
  return /^0[0-7]+$/.test(text) ? parseInt(text, 8) : undefined;
}

/** The sum of numbers and $NODEID in @param text. */
function sumOf(text: string, nodeId: number | undefined): number | undefined {
  if (text === "") return undefined;
  let sum = 0;
  for (const part of text.split("+")) {
    const word = part.trim();
    const value = /^\$nodeid$/i.test(word) ? nodeId : edsNumber(word);
    if (value === undefined) return undefined;
    sum += value;
  }
  return sum;
}

/** The dictionary, as it is filled from the sections. */
class Device implements Eds {
  readonly entries = new Map<number, EdsEntry>();
  private readonly names = new Map<number, string>();
  productName = "";

  constructor(
    readonly fileName: string,
    readonly remarks: string[],
  ) {}

  find(index: number, subIndex: number): EdsEntry | undefined {
    return this.entries.get(keyOf(index, subIndex));
  }

  nameOf(index: number, subIndex: number): string {
    const entry = this.find(index, subIndex);
    if (entry === undefined) return this.names.get(index) ?? "";
    return entry.objectName === "" ? entry.name : `${entry.objectName}: ${entry.name}`;
  }

  defaultOf(index: number, subIndex: number, nodeId?: number): number | undefined {
    return sumOf(this.find(index, subIndex)?.defaultText ?? "", nodeId);
  }

  addObject(index: number, section: IniSection): void {
    const name = section.get("parametername") ?? "";
    this.names.set(index, name);
    const kind = edsNumber(section.get("objecttype") ?? "7");
    const compact = edsNumber(section.get("compactsubobj") ?? "0") ?? 0;
    if (compact > 0) this.addCompact(index, name, section, compact);
    else if (kind !== kArray && kind !== kRecord && kind !== kDefType) this.addEntry(index, 0, "", section);
  }

  addSubObject(index: number, subIndex: number, section: IniSection): void {
    this.addEntry(index, subIndex, this.names.get(index) ?? "", section);
  }

  /** Names and values that a compact object has beside its common ones. */
  addCompactPart(index: number, isName: boolean, section: IniSection): void {
    for (const [key, text] of section) {
      const entry = this.find(index, edsNumber(key) ?? -1);
      if (entry === undefined) continue;
      if (isName) entry.name = text;
      else entry.defaultText = text;
    }
  }

  private addEntry(index: number, subIndex: number, objectName: string, section: IniSection): void {
    this.entries.set(keyOf(index, subIndex), {
      index,
      subIndex,
      name: section.get("parametername") ?? "",
      objectName,
      dataType: edsNumber(section.get("datatype") ?? "") ?? 0,
      access: (section.get("accesstype") ?? "").toLowerCase(),
      isMappable: section.get("pdomapping") === "1",
      defaultText: section.get("defaultvalue") ?? "",
      lowText: section.get("lowlimit") ?? "",
      highText: section.get("highlimit") ?? "",
    });
  }

  private addCompact(index: number, name: string, section: IniSection, count: number): void {
    const number = new Map([["parametername", "Number of entries"], ["datatype", "5"], ["accesstype", "ro"]]);
    this.addEntry(index, 0, name, number.set("defaultvalue", String(count)));
    for (let subIndex = 1; subIndex <= Math.min(count, 254); ++subIndex) {
      this.addEntry(index, subIndex, name, new Map(section).set("parametername", `${name}${subIndex}`));
    }
  }
}

/** The EDS in @param text; a Refusal with line and reason if it is none. */
export function parseEds(text: string, fileName = ""): Eds {
  const { sections, remarks } = readIni(text);
  const device = new Device(fileName === "" ? (sections.get("fileinfo")?.get("filename") ?? "") : fileName, remarks);
  device.productName = sections.get("deviceinfo")?.get("productname") ?? "";
  const each = (pattern: RegExp, add: (match: RegExpExecArray, section: IniSection) => void): void => {
    for (const [name, section] of sections) {
      const match = pattern.exec(name);
      if (match !== null) add(match, section);
    }
  };
  const hex = (digits: string | undefined): number => parseInt(digits ?? "", 16);
  each(kObject, (match, section) => device.addObject(hex(match[1]), section));
  each(kSubObject, (match, section) => device.addSubObject(hex(match[1]), hex(match[2]), section));
  each(kCompactPart, (match, section) => device.addCompactPart(hex(match[1]), match[2]?.toLowerCase() === "name", section));
  if (device.entries.size === 0) {
    const first = remarks[0] === undefined ? "" : ` (${remarks[0]})`;
    throw new Refusal("damaged", `${fileName === "" ? "the file" : fileName} is no EDS: no section of an object, such as [1000]${first}`);
  }
  return device;
}
