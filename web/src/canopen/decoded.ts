import type { Service } from "./services";
import type { BitRow } from "./words";

/** A part of a frame. */
export interface DecodedRow {
  name: string;
  /** In words, with its unit. */
  value: string;
  /** As it is on the bus: 0x000F, 40 41 60 00. */
  raw?: string;
  /** 6040h:00. */
  object?: string;
  /** Bits of a word that have a name. */
  bits?: BitRow[];
}

/** What a frame says, without the service that it belongs to. */
export interface Content {
  /** Behind the name of the service: "controlword 0x000F: Enable operation". */
  text: string;
  rows: DecodedRow[];
  /** What is wrong with it. */
  remark?: string;
}

/** What a frame says. */
export interface Decoded {
  service: Service;
  /** One line: "RPDO 1: Controlword 0x000F: Enable operation". */
  headline: string;
  rows: DecodedRow[];
  /** What is wrong with it. */
  remark?: string;
  /** Request of a response, and response of a request: its serial number in the store. */
  partner?: number;
  /** All frames of the SDO transfer, this one too, in their order. */
  transfer?: number[];
}
