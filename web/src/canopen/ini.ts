/** Keys in small letters, with what stands behind the `=`. */
export type IniSection = Map<string, string>;

/** Sections by their names in small letters, and what was left out. */
export interface Ini {
  sections: Map<string, IniSection>;
  remarks: string[];
}

/** Remarks that are kept: a file that is none has one for each line. */
const kMostRemarks = 20;

/** Reads the form of files that CiA 306 takes for an EDS; what is wrong in a line costs that line. */
export function readIni(text: string): Ini {
  const sections = new Map<string, IniSection>();
  const remarks: string[] = [];
  let section: IniSection | undefined;
  const remark = (line: number, what: string): void => {
    if (remarks.length < kMostRemarks) remarks.push(`line ${line}: ${what}`);
  };
  text.split(/\r\n|\r|\n/).forEach((raw, index) => {
    const line = raw.replace(/^\uFEFF/, "").trim();
    if (line === "" || line.startsWith(";") || line.startsWith("#")) return;
    if (line.startsWith("[")) {
      const end = line.indexOf("]");
      if (end < 0) {
        remark(index + 1, "a section without ]");
        return;
      }
      const name = line.slice(1, end).trim().toLowerCase();
      section = sections.get(name) ?? new Map<string, string>();
      sections.set(name, section);
      return;
    }
    const equals = line.indexOf("=");
    if (equals <= 0) remark(index + 1, "neither [section] nor key=value");
    else if (section === undefined) remark(index + 1, "a key before the first section");
    else section.set(line.slice(0, equals).trim().toLowerCase(), line.slice(equals + 1).trim());
  });
  return { sections, remarks };
}
