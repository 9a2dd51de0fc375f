import type { FrameStore } from "../model/frame_store";
import type { Profile } from "../model/profile";
import type { Pdo, UnitEvent } from "../source/types";
import type { Content, Decoded } from "./decoded";
import type { Eds } from "./eds";
import { hexOf, type CanFrame } from "./frame";
import { decodeAxisEmergency, decodeEmergency, decodeHeartbeat, decodeNmt, decodeSync, decodeTime } from "./network";
import { decodePdo, pdosOfEds } from "./pdo";
import { SdoReader, type SdoStep } from "./sdo/reader";
import { decodeStep, decodeTransfer, type ObjectNames } from "./sdo/words";
import { transferAt } from "./sdo/transfer";
import type { Service, ServiceKind, ServiceMap } from "./services";

export type { Content, Decoded, DecodedRow } from "./decoded";

/** Increments of the encoder a revolution, of velocities and positions on the bus. */
const kIncrements = 4_194_304;

/** What is known of the unit whose frames are decoded. */
export interface DecoderSettings {
  services: ServiceMap;
  eds?: Eds | undefined;
  /** Those of pdo.list; if not given, those of the EDS at power-on. */
  pdos?: readonly Pdo[] | undefined;
  /** Those of the unit, for the texts of faults. */
  events?: (() => readonly UnitEvent[]) | undefined;
  /** Increments a revolution of velocities and positions; 4 194 304 if not given. */
  increments?: number | undefined;
  /** Of the unit; "s120" if not given. */
  profile?: Profile | undefined;
}

/** Says what frames mean. */
export class Decoder {
  private readonly pdos: readonly Pdo[];
  private readonly names: ObjectNames;

  constructor(readonly settings: DecoderSettings) {
    const { eds, services } = settings;
    const ofEds = eds === undefined || services.nodeId === undefined ? [] : pdosOfEds(eds, services.nodeId);
    this.pdos = settings.pdos ?? ofEds;
    this.names = { eds, scaling: { increments: settings.increments ?? kIncrements, profile: settings.profile } };
  }

  /** What @param frame says by itself. */
  decode(frame: CanFrame): Decoded {
    const service = this.serviceOf(frame);
    return this.whole(service, this.contentOf(service, frame));
  }

  /** What the frame @param serial of @param store says, with the SDO transfer that it belongs to. */
  decodeAt(store: FrameStore, serial: number): Decoded | undefined {
    const frame = store.frame(serial);
    if (frame === undefined) return undefined;
    const service = this.serviceOf(frame);
    const place = service.lane === "sdo" && !frame.isRemote ? transferAt(store, this.settings.services, serial) : undefined;
    if (place === undefined) return this.decode(frame);
    const decoded = this.whole(service, decodeTransfer(place, frame, this.names));
    decoded.transfer = place.frames;
    if (place.partner !== undefined) decoded.partner = place.partner;
    return decoded;
  }

  /** The PDO under @param id, from pdo.list or the EDS; undefined: it is none of the unit. */
  pdoOf(id: number, isExtended = false): Pdo | undefined {
    const service = this.settings.services.of(id, isExtended);
    return service.pdo ?? this.pdos.find((pdo) => pdo.is_valid && !isExtended && pdo.identifier === id);
  }

  private serviceOf(frame: CanFrame): Service {
    return this.settings.services.of(frame.id, frame.isExtended);
  }

  private whole(service: Service, { text, rows, remark }: Content): Decoded {
    const decoded: Decoded = { service, headline: `${service.name}: ${text}`, rows };
    if (remark !== undefined) decoded.remark = remark;
    return decoded;
  }

  private contentOf(service: Service, frame: CanFrame): Content {
    const pdo = this.pdoOf(frame.id, frame.isExtended);
    if (pdo !== undefined && isPdo(service.kind)) return decodePdo(frame, pdo, this.names.eds, this.names.scaling);
    return this.table[service.kind](frame);
  }

  private readonly table: Record<ServiceKind, (frame: CanFrame) => Content> = {
    nmt: decodeNmt,
    sync: decodeSync,
    time: decodeTime,
    emcy: (frame) =>
      this.settings.profile === "cia402" ? decodeAxisEmergency(frame) : decodeEmergency(frame, (number, object) => this.messageOf(number, object)),
    rpdo: rawContent,
    tpdo: rawContent,
    "sdo-request": (frame) => this.sdoAlone(frame, true),
    "sdo-response": (frame) => this.sdoAlone(frame, false),
    heartbeat: decodeHeartbeat,
    other: rawContent,
  };

  private sdoAlone(frame: CanFrame, isRequest: boolean): Content {
    const step: SdoStep = new SdoReader().read(frame.data, isRequest);
    return decodeStep(step, frame, this.names);
  }

  private messageOf(number: number, object: number): { name: string; text: string } | undefined {
    const same = (event: UnitEvent): boolean =>
      (event.kind === "fault" || event.kind === "alarm") && event.number === number;
    const events = (this.settings.events?.() ?? []).filter(same);
    const found = events.find((event) => event.drive_object === object) ?? events[0];
    return found === undefined ? undefined : { name: found.name ?? "", text: found.text ?? "" };
  }
}

function isPdo(kind: ServiceKind): boolean {
  return kind === "rpdo" || kind === "tpdo";
}

/** A frame of which nothing is known. */
function rawContent(frame: CanFrame): Content {
  if (frame.isRemote) return { text: `remote request of ${frame.length} bytes`, rows: [] };
  const data = hexOf(frame.data, " ");
  return { text: data === "" ? "no data" : data, rows: [{ name: "Data", value: data === "" ? "none" : data }] };
}
