import { readFileSync } from "node:fs";

/** A file beside this one. */
export function dataFile(name: string): Uint8Array {
  return new Uint8Array(readFileSync(new URL(name, import.meta.url)));
}

/** Text of a file of the project, by its path from the root. */
export function projectText(path: string): string {
  return readFileSync(new URL(`../../../../${path}`, import.meta.url), "utf8");
}

/** A frame out of "205#0F00". */
export function frameOf(text: string, t = 0, sent = false) {
  const [digits = "", content = ""] = text.split("#");
  const isRemote = content.startsWith("R");
  const data = Uint8Array.from((isRemote ? "" : content).match(/../g) ?? [], (byte) => parseInt(byte, 16));
  const length = isRemote ? Number(content.slice(1)) : data.length;
  return { t, sent, isRemote, isExtended: digits.length === 8, id: parseInt(digits, 16), length, data };
}
