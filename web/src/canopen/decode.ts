import type { FrameStore } from "../model/frame_store";
import type { Pdo, UnitEvent } from "../source/types";
import type { BitRow } from "./words";
import type { Eds } from "./eds";
import type { CanFrame } from "./frame";
import type { Service, ServiceMap } from "./services";

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

/** What a frame says. */
export interface Decoded {
  service: Service;
  /** One line: "RPDO 1: controlword 0x000F: Enable operation". */
  headline: string;
  rows: DecodedRow[];
  /** What is wrong with it. */
  remark?: string;
  /** Request of a response, and response of a request: its serial number in the store. */
  partner?: number;
  /** All frames of the SDO transfer, this one too, in their order. */
  transfer?: number[];
}

/** What is known of the unit whose frames are decoded. */
export interface DecoderSettings {
  services: ServiceMap;
  eds?: Eds | undefined;
  pdos?: readonly Pdo[] | undefined;
  /** Those of the unit, for the texts of faults. */
  events?: () => readonly UnitEvent[];
  /** Increments a revolution of velocities and positions; 4 194 304 if not given. */
  increments?: number;
}

/** Says what frames mean. */
export class Decoder {
  constructor(readonly settings: DecoderSettings) {}

  /** What @param frame says by itself. */
  decode(frame: CanFrame): Decoded {
    const service = this.settings.services.of(frame.id, frame.isExtended);
    return { service, headline: service.name, rows: [] };
  }

  /** What the frame @param serial of @param store says, with the SDO transfer that it belongs to. */
  decodeAt(store: FrameStore, serial: number): Decoded | undefined {
    const frame = store.frame(serial);
    return frame === undefined ? undefined : this.decode(frame);
  }
}
