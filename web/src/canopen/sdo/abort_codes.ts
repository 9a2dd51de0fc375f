import { wordText } from "../words";

/** SDO abort codes (CiA 301, 7.2.4.3.17) in the words of the unit. */
const kTexts: readonly (readonly [number, string])[] = [
  [0x05030000, "toggle bit not alternated"],
  [0x05040000, "protocol timed out"],
  [0x05040001, "command specifier invalid"],
  [0x05040002, "invalid block size"],
  [0x05040003, "invalid sequence number"],
  [0x05040004, "CRC error"],
  [0x05040005, "out of memory"],
  [0x06010000, "unsupported access"],
  [0x06010001, "write only"],
  [0x06010002, "read only"],
  [0x06020000, "no such object"],
  [0x06040041, "cannot be mapped"],
  [0x06040042, "PDO length exceeded"],
  [0x06040043, "parameter incompatible"],
  [0x06040047, "internal incompatibility"],
  [0x06060000, "hardware error"],
  [0x06070010, "length does not match"],
  [0x06070012, "too long"],
  [0x06070013, "too short"],
  [0x06090011, "no such sub-index"],
  [0x06090030, "invalid value"],
  [0x06090031, "value too high"],
  [0x06090032, "value too low"],
  [0x06090036, "maximum below minimum"],
  [0x060a0023, "resource not available"],
  [0x08000000, "general error"],
  [0x08000020, "cannot be transferred or stored"],
  [0x08000021, "local control"],
  [0x08000022, "not in this device state"],
  [0x08000023, "no object dictionary"],
  [0x08000024, "no data"],
];

/** Code and text of every abort code of CiA 301. */
export const kAbortTexts: ReadonlyMap<number, string> = new Map(kTexts);

/** "0x06010002: read only". */
export function abortText(code: number): string {
  return `${wordText(code, 8)}: ${kAbortTexts.get(code) ?? "no abort code of CiA 301"}`;
}
