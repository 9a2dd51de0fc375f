import type { Pdo } from "../source/types";
import type { Eds } from "./eds";

/** Rows of the picture of the bus, from the top. The place in the list is the number of the lane in stores. */
export const kLanes = [
  { lane: "nmt", name: "NMT", text: "NMT commands" },
  { lane: "sync", name: "SYNC", text: "synchronisation" },
  { lane: "emcy", name: "EMCY", text: "emergency messages" },
  { lane: "rpdo", name: "RPDO", text: "process data to the unit" },
  { lane: "tpdo", name: "TPDO", text: "process data of the unit" },
  { lane: "sdo", name: "SDO", text: "service data: requests and responses" },
  { lane: "heartbeat", name: "Heartbeat", text: "boot-up, heartbeat and node guarding" },
  { lane: "other", name: "Other", text: "time stamps and foreign frames" },
] as const;

export type Lane = (typeof kLanes)[number]["lane"];
export const kLaneCount = kLanes.length;

/** Number of @param lane in stores. */
export function laneNumber(lane: Lane): number {
  return kLanes.findIndex((row) => row.lane === lane);
}

export type ServiceKind =
  | "nmt"
  | "sync"
  | "time"
  | "emcy"
  | "rpdo"
  | "tpdo"
  | "sdo-request"
  | "sdo-response"
  | "heartbeat"
  | "other";

/** What a COB-ID is for. */
export interface Service {
  kind: ServiceKind;
  lane: Lane;
  /** "TPDO 1", "SDO response", "heartbeat of node 7". */
  name: string;
  /** Of a PDO or of an SDO server, from 1. */
  number?: number;
  /** Whose it is, if the identifier says so. */
  node?: number;
  /** As pdo.list has it, if it is one of the unit. */
  pdo?: Pdo;
}

/** An SDO server with the identifiers that it uses. */
export interface SdoServer {
  server: number;
  request: number;
  response: number;
}

/** What is known of the identifiers of a unit. */
export interface ServiceSettings {
  nodeId?: number | undefined;
  /** Those of pdo.list; only valid ones count. */
  pdos?: readonly Pdo[] | undefined;
  /** Beyond that of 1200h. */
  sdoServers?: readonly SdoServer[] | undefined;
  /** For what the rest does not say: COB-IDs of SYNC, EMCY and SDO servers. */
  eds?: Eds | undefined;
}

/** The predefined connection set (CiA 301, 7.3.3): function code, that is the upper 4 bits of the identifier. */
const kPredefined: readonly { kind: ServiceKind; number?: number }[] = [
  { kind: "nmt" },
  { kind: "emcy" },
  { kind: "time" },
  { kind: "tpdo", number: 1 },
  { kind: "rpdo", number: 1 },
  { kind: "tpdo", number: 2 },
  { kind: "rpdo", number: 2 },
  { kind: "tpdo", number: 3 },
  { kind: "rpdo", number: 3 },
  { kind: "tpdo", number: 4 },
  { kind: "rpdo", number: 4 },
  { kind: "sdo-response", number: 1 },
  { kind: "sdo-request", number: 1 },
  { kind: "other" },
  { kind: "heartbeat" },
  { kind: "other" },
];

const kNames: Record<ServiceKind, string> = {
  nmt: "NMT command",
  sync: "SYNC",
  time: "TIME",
  emcy: "EMCY",
  rpdo: "RPDO",
  tpdo: "TPDO",
  "sdo-request": "SDO request",
  "sdo-response": "SDO response",
  heartbeat: "heartbeat",
  other: "frame",
};

const kLaneOf: Record<ServiceKind, Lane> = {
  nmt: "nmt",
  sync: "sync",
  time: "other",
  emcy: "emcy",
  rpdo: "rpdo",
  tpdo: "tpdo",
  "sdo-request": "sdo",
  "sdo-response": "sdo",
  heartbeat: "heartbeat",
  other: "other",
};

/** Whether @param kind counts from 1 in names: RPDO 3. */
function isNumbered(kind: ServiceKind): boolean {
  return kind === "rpdo" || kind === "tpdo";
}

function service(kind: ServiceKind, more: { number?: number; node?: number; pdo?: Pdo } = {}, own?: number): Service {
  let name = kNames[kind];
  if (more.number !== undefined && (isNumbered(kind) || more.number > 1)) name += ` ${more.number}`;
  if (more.pdo !== undefined) name = more.pdo.axis > 1 ? `${more.pdo.pdo} of axis ${more.pdo.axis}` : more.pdo.pdo;
  if (more.node !== undefined && more.node !== own) name += ` of node ${more.node}`;
  return { kind, lane: kLaneOf[kind], name, ...more };
}

/** What @param id is by the predefined connection set alone. */
function predefined(id: number, own?: number): Service {
  const node = id & 0x7f;
  const row = kPredefined[id >> 7] ?? { kind: "other" };
  if (id === 0) return service("nmt");
  if (id === 0x080) return service("sync");
  if (id === 0x100) return service("time");
  if (node === 0 || row.kind === "other" || row.kind === "nmt" || row.kind === "time") return service("other");
  return service(row.kind, row.number === undefined ? { node } : { node, number: row.number }, own);
}

/** Whether the predefined connection set has the slave send @param id. */
export function isOfSlave(id: number): boolean {
  return ["emcy", "tpdo", "sdo-response", "heartbeat"].includes(predefined(id).kind);
}

/** Bit 31 of a COB-ID: it is not valid; bit 29: identifier of 29 bits (CiA 301, 7.5.2). */
const kNotValid = 0x80000000;
const kFrameBit = 0x20000000;
const kExtendedMask = 0x1fffffff;

interface Identifier {
  id: number;
  isExtended: boolean;
}

/** The identifier in @param cobId; undefined: it is not valid. */
export function identifierOf(cobId: number): Identifier | undefined {
  if ((cobId & kNotValid) !== 0) return undefined;
  const isExtended = (cobId & kFrameBit) !== 0;
  return { id: cobId & (isExtended ? kExtendedMask : 0x7ff), isExtended };
}

/** What every identifier on the bus of a unit is for. */
export class ServiceMap {
  readonly nodeId: number | undefined;
  private readonly own = new Map<number, Service>();
  private readonly known = new Map<number, Service>();
  /** Lanes of the identifiers of 11 bits; 255: not looked for yet. */
  private readonly lanes = new Uint8Array(0x800).fill(255);

  constructor(settings: ServiceSettings = {}) {
    this.nodeId = settings.nodeId;
    if (settings.eds !== undefined) this.addOfEds(settings.eds);
    for (const { server, request, response } of settings.sdoServers ?? []) this.addServer(server, request, response);
    for (const pdo of settings.pdos ?? []) if (pdo.is_valid) this.addPdo(pdo);
  }

  /** What @param id is for. */
  of(id: number, isExtended = false): Service {
    const key = isExtended ? id + kFrameBit : id;
    const found = this.own.get(key) ?? this.known.get(key);
    if (found !== undefined) return found;
    const made = isExtended ? service("other") : predefined(id, this.nodeId);
    this.known.set(key, made);
    return made;
  }

  /** Number of the lane of @param id, for FrameStore. */
  laneOf = (id: number, isExtended: boolean): number => {
    const known = isExtended ? undefined : this.lanes[id];
    if (known !== undefined && known < kLaneCount) return known;
    const lane = laneNumber(this.of(id, isExtended).lane);
    if (!isExtended) this.lanes[id] = lane;
    return lane;
  };

  private add(cobId: number, made: Service): void {
    const found = identifierOf(cobId);
    if (found !== undefined) this.own.set(found.isExtended ? found.id + kFrameBit : found.id, made);
  }

  private addPdo(pdo: Pdo): void {
    const number = Number(/\d+/.exec(pdo.pdo)?.[0] ?? 0);
    this.add(pdo.cob_id, service(pdo.direction === "receive" ? "rpdo" : "tpdo", { number, pdo }));
  }

  private addServer(number: number, request: number, response: number): void {
    const node = this.nodeId === undefined ? {} : { node: this.nodeId };
    this.add(request, service("sdo-request", { number, ...node }, this.nodeId));
    this.add(response, service("sdo-response", { number, ...node }, this.nodeId));
  }

  private addOfEds(eds: Eds): void {
    const node = this.nodeId;
    const sync = eds.defaultOf(0x1005, 0, node);
    const emcy = eds.defaultOf(0x1014, 0, node);
    if (sync !== undefined) this.add(sync, service("sync"));
    if (emcy !== undefined && node !== undefined) this.add(emcy, service("emcy", { node }, node));
    for (let server = 1; server <= 128; ++server) {
      const request = eds.defaultOf(0x11ff + server, 1, node);
      const response = eds.defaultOf(0x11ff + server, 2, node);
      if (request !== undefined && response !== undefined && request !== 0) this.addServer(server, request, response);
    }
  }
}
