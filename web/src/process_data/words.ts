import type { Pdo } from "../source/types";
import { duration, fixed } from "../ui/number";

/** When a PDO is sent or acts, in words, by its transmission type (CiA 301). */
export function transmissionWords(direction: Pdo["direction"], type: number): string {
  return direction === "receive" ? receiveWords(type) : transmitWords(type);
}

function receiveWords(type: number): string {
  if (type <= 240) return "acts at the next SYNC";
  return type >= 254 ? "acts at once" : "reserved";
}

function transmitWords(type: number): string {
  if (type === 0) return "at the next SYNC after a change";
  if (type === 1) return "at every SYNC";
  if (type <= 240) return `at every ${ordinal(type)} SYNC`;
  if (type === 252) return "on remote request, as it was at the last SYNC";
  if (type === 253) return "on remote request";
  return type >= 254 ? "at events: a change, the event time" : "reserved";
}

function ordinal(count: number): string {
  const teens = count % 100 >= 11 && count % 100 <= 13;
  const ending = teens ? undefined : { 1: "st", 2: "nd", 3: "rd" }[count % 10];
  return `${count}${ending ?? "th"}`;
}

/** Whether frames of a PDO have any effect, or are sent. */
export function stateWords(pdo: Pdo): string {
  if (!pdo.is_valid) return "not valid";
  return pdo.is_active ? "active" : "valid, waits for Operational";
}

/** The identifier as `205h`; empty of a PDO that has none. */
export function identifierText(pdo: Pdo): string {
  return pdo.identifier === undefined ? "" : `${pdo.identifier.toString(16).toUpperCase()}h`;
}

/** Frames a second: of the last two frames, and less while the next one does not come. 0: none; undefined: nobody counts. */
export function rateOf(pdo: Pdo): number | undefined {
  if (pdo.frames === undefined) return undefined;
  if (pdo.interval_s === undefined || pdo.interval_s <= 0) return 0;
  return 1 / Math.max(pdo.interval_s, pdo.age_s ?? 0);
}

/** The rate as it is read. */
export function rateText(pdo: Pdo): string {
  const rate = rateOf(pdo);
  return rate === undefined ? "not counted" : fixed(rate, 1, "frames/s");
}

/** How long ago the last frame was. */
export function ageText(pdo: Pdo): string {
  if (pdo.frames === undefined) return "not counted";
  if (pdo.age_s === undefined) return "no frame yet";
  if (pdo.age_s < 1) return `${Math.round(pdo.age_s * 1000)}\u2009ms ago`;
  return `${duration(Math.round(10 * pdo.age_s) / 10)} ago`;
}
