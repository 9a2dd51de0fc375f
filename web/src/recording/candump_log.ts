import type { CanFrame } from "../canopen/frame";
import { frameText } from "../canopen/frame";
import { isOfSlave } from "../canopen/services";
import { Refusal } from "../source/refusal";

/** A line of candump -l: "(1700000000.123456) can0 605#40...", a direction may stand behind it. */
const kLine = /^\((\d+\.\d+)\)\s+(\S+)\s+([0-9A-F]+)#(\S*)(?:\s+([RT]))?$/i;
/** A remote frame: R, its length, and with candump -8 a raw DLC behind an underscore. */
const kRemote = /^R(\d?)(?:_[0-9A-F])?$/i;
const kData = /^((?:[0-9A-F]{2})*)(?:_[0-9A-F])?$/i;
/** Identifiers above are error frames of SocketCAN. */
const kErrorFlag = 0x20000000;
const kLongestData = 16;
const kMostRemarks = 5;

/** What stands in a log. */
export interface CandumpLog {
  frames: CanFrame[];
  /** Time of the first line (seconds since 1970), from which the frames count. */
  startedAt: number;
  /** Interface of the first frame. */
  bus: string;
  remark: string;
}

/** Whether @param text begins with a line of such a log. */
export function isCandumpLog(text: string): boolean {
  const first = text.slice(0, 4096).split(/\r?\n/).find((line) => line.trim() !== "" && !line.startsWith("#"));
  return first !== undefined && /^\(\d+\.\d+\)\s+\S+\s+\S+#/.test(first.trim());
}

function bytesOf(digits: string): Uint8Array {
  return Uint8Array.from({ length: digits.length / 2 }, (_, i) => parseInt(digits.slice(2 * i, 2 * i + 2), 16));
}

/** The frame in @param line, or what is wrong with it. */
function frameIn(line: string): { frame: CanFrame; bus: string } | string {
  const match = kLine.exec(line);
  if (match === null) return "(seconds) interface id#data was expected";
  const [, time = "", bus = "", digits = "", content = "", direction] = match;
  if (content.startsWith("#")) return "a frame of CAN FD; CANopen and this page know classical CAN only";
  if (digits.length !== 3 && digits.length !== 8) return `an identifier has 3 or 8 hexadecimal digits, not ${digits.length}`;
  const id = parseInt(digits, 16);
  if (digits.length === 8 && id >= kErrorFlag) return "";
  const base = { t: Number(time), isExtended: digits.length === 8, id };
  const sent = direction === undefined ? !base.isExtended && isOfSlave(id) : direction.toUpperCase() === "R";
  const remote = kRemote.exec(content);
  if (remote !== null)
    return { bus, frame: { ...base, sent, isRemote: true, length: Number(remote[1] ?? 0), data: new Uint8Array(0) } };
  const data = kData.exec(content)?.[1];
  if (data === undefined) return `"${content}" is no data: pairs of hexadecimal digits`;
  if (data.length > kLongestData) return `${data.length / 2} bytes of data; a CAN frame has at most 8`;
  return { bus, frame: { ...base, sent, isRemote: false, length: data.length / 2, data: bytesOf(data) } };
}

/** Reads a log of candump -l. Lines that cannot be read are left out and named; a Refusal if there is no frame, or one of CAN FD. */
export function readCandumpLog(name: string, text: string): CandumpLog {
  const log: CandumpLog = { frames: [], startedAt: 0, bus: "", remark: "" };
  const bad: string[] = [];
  let errors = 0;
  text.split(/\r?\n/).forEach((raw, index) => {
    const line = raw.trim();
    if (line === "" || line.startsWith("#")) return;
    const found = frameIn(line);
    if (typeof found !== "string") {
      if (log.frames.length === 0) Object.assign(log, { startedAt: found.frame.t, bus: found.bus });
      found.frame.t = Math.round((found.frame.t - log.startedAt) * 1e6) / 1e6;
      log.frames.push(found.frame);
    } else if (found.includes("CAN FD")) {
      throw new Refusal("unknown-format", `${name}, line ${index + 1}: ${found}`);
    } else if (found === "") {
      ++errors;
    } else {
      bad.push(`line ${index + 1}: ${found}`);
    }
  });
  if (log.frames.length === 0) throw new Refusal("damaged", `${name}: no frame in it; ${bad[0] ?? "it is empty"}`);
  log.frames.sort((a, b) => a.t - b.t);
  log.remark = remarkOf(bad, errors);
  return log;
}

function remarkOf(bad: string[], errors: number): string {
  const parts = bad.slice(0, kMostRemarks);
  if (bad.length > kMostRemarks) parts.push(`${bad.length - kMostRemarks} more lines`);
  const remark = parts.length === 0 ? "" : `left out: ${parts.join("; ")}`;
  if (errors === 0) return remark;
  return `${remark}${remark === "" ? "" : "; "}${errors} error frames were left out`;
}

/** A line of such a log; @param startedAt: time zero (seconds since 1970). */
export function candumpLine(frame: CanFrame, bus: string, startedAt: number): string {
  const whole = Math.floor(startedAt);
  const microseconds = Math.round((frame.t + (startedAt - whole)) * 1e6);
  const seconds = whole + Math.floor(microseconds / 1e6);
  const rest = String(microseconds - Math.floor(microseconds / 1e6) * 1e6);
  return `(${String(seconds).padStart(10, "0")}.${rest.padStart(6, "0")}) ${bus} ${frameText(frame)}\n`;
}
