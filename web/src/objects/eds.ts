/** What an EDS says of an object or sub-index. */
export interface EdsEntry {
  name: string;
  /** As it stands there; absent: the EDS gives none. */
  defaultValue?: string;
}

/** The entries of an EDS, by the lower-case name of their section: `1018`, `1018sub1`. */
export type Eds = ReadonlyMap<string, EdsEntry>;

const kSection = /^\[([0-9a-f]{4}(?:sub[0-9a-f]{1,2})?)\]$/i;

/** The objects of @param text, an EDS (CiA 306). */
export function parsedEds(text: string): Eds {
  const entries = new Map<string, EdsEntry>();
  let present: EdsEntry | undefined;
  for (const line of text.split(/\r?\n/)) {
    if (line.startsWith("[")) {
      const section = kSection.exec(line.trim())?.[1];
      present = section === undefined ? undefined : { name: "" };
      if (section !== undefined && present !== undefined) entries.set(section.toLowerCase(), present);
      continue;
    }
    const equals = line.indexOf("=");
    if (present === undefined || equals < 0) continue;
    const key = line.slice(0, equals).trim().toLowerCase();
    const value = line.slice(equals + 1).trim();
    if (key === "parametername") present.name = value;
    if (key === "defaultvalue") present.defaultValue = value;
  }
  return entries;
}

/** What the EDS says of @param sub of @param index; an object without sub-indices has its default itself. */
export function edsEntry(eds: Eds, index: number, sub: number): EdsEntry | undefined {
  const object = index.toString(16).padStart(4, "0");
  return eds.get(`${object}sub${sub.toString(16)}`) ?? (sub === 0 ? eds.get(object) : undefined);
}

/** The name of the object that sub-indices belong to; empty: the EDS has none, or it has no sub-indices. */
export function parentName(eds: Eds, index: number): string {
  const object = index.toString(16).padStart(4, "0");
  return eds.has(`${object}sub0`) ? (eds.get(object)?.name ?? "") : "";
}
