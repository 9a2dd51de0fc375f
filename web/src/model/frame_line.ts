import { kExtended, kRemote, kSent } from "../canopen/frame";

/** What stands in a line of frames.subscribe. */
export interface LineFields {
  t: number;
  flags: number;
  id: number;
  length: number;
  /** Always 8 bytes; those behind the length are 0. */
  data: Uint8Array;
}

const kZero = 48;
const kNine = 57;
const kPoint = 46;
const kSpace = 32;
const kReceived = 82;
const kSentLetter = 83;
const kHash = 35;
const kRemoteLetter = 82;

/** Value of a hexadecimal digit by its code; 255: it is none. */
const kDigits = new Uint8Array(128).fill(255);
for (let value = 0; value < 16; ++value) {
  kDigits[value.toString(16).charCodeAt(0)] = value;
  kDigits[value.toString(16).toUpperCase().charCodeAt(0)] = value;
}

function digitAt(line: string, at: number): number {
  const code = line.charCodeAt(at);
  return code < 128 ? (kDigits[code] ?? 255) : 255;
}

/** Place behind the time in front of @param line, which goes to @param into; -1: there is none. */
function parseTime(line: string, into: LineFields): number {
  let at = 0;
  let value = 0;
  let unit = 1;
  let isFraction = false;
  for (; at < line.length; ++at) {
    const code = line.charCodeAt(at);
    if (code >= kZero && code <= kNine) {
      value = value * 10 + (code - kZero);
      if (isFraction) unit *= 10;
    } else if (code === kPoint && !isFraction) {
      isFraction = true;
    } else {
      break;
    }
  }
  into.t = value / unit;
  return at > 0 && line.charCodeAt(at) === kSpace ? at + 1 : -1;
}

/** The same for the identifier and the `#` behind it. */
function parseIdentifier(line: string, begin: number, into: LineFields): number {
  let id = 0;
  let at = begin;
  for (let digit = digitAt(line, at); digit < 16; digit = digitAt(line, at)) {
    id = id * 16 + digit;
    ++at;
  }
  if (line.charCodeAt(at) !== kHash || (at - begin !== 3 && at - begin !== 8)) return -1;
  into.id = id;
  if (at - begin === 8) into.flags |= kExtended;
  return at + 1;
}

function parseRemote(line: string, at: number, into: LineFields): boolean {
  into.flags |= kRemote;
  const digit = at < line.length ? digitAt(line, at) : 0;
  into.length = digit;
  return digit <= 8 && at + 1 >= line.length;
}

function parseData(line: string, begin: number, into: LineFields): boolean {
  const length = (line.length - begin) / 2;
  if (length > 8 || (line.length - begin) % 2 !== 0) return false;
  for (let i = 0; i < length; ++i) {
    const high = digitAt(line, begin + 2 * i);
    const low = digitAt(line, begin + 2 * i + 1);
    if (high > 15 || low > 15) return false;
    into.data[i] = high * 16 + low;
  }
  into.length = length;
  return true;
}

/** Reads "12.345678 R 205#0F00" into @param into. False: it is something else, and @param into has rests of it. */
export function parseLine(line: string, into: LineFields): boolean {
  into.flags = 0;
  into.data.fill(0);
  const direction = parseTime(line, into);
  if (direction < 0 || line.charCodeAt(direction + 1) !== kSpace) return false;
  const letter = line.charCodeAt(direction);
  if (letter === kSentLetter) into.flags = kSent;
  else if (letter !== kReceived) return false;
  const content = parseIdentifier(line, direction + 2, into);
  if (content < 0) return false;
  if (line.charCodeAt(content) === kRemoteLetter) return parseRemote(line, content + 1, into);
  return parseData(line, content, into);
}
