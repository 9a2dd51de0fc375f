/** Simulated drive units for tests; docs/how-to/fixtures.md. */
import { EventEmitter } from 'node:events';

/** Anything that this package throws by itself. */
export class AxisdError extends Error {}
/** A program was not found. */
export class Missing extends AxisdError {}
/** A daemon or hub has ended although it is needed. */
export class Ended extends AxisdError {}
/** The unit has refused a request. */
export class Refused extends AxisdError {
  code: string;
  details: Record<string, unknown>;
}
/** Something has not come in time. */
export class Timeout extends AxisdError {}

/** A fault, docs/reference/faults.md; further keys are the arguments of its kind. */
export interface FaultValue {
  kind: string;
  event?: string;
  after?: number;
  every?: number;
  times?: number;
  probability?: number;
  seed?: number;
  while?: string;
  until?: string;
  for_ms?: number;
  [argument: string]: unknown;
}

export interface Frame {
  id: number;
  data: Buffer;
  extended: boolean;
  remote: boolean;
  /** End of the frame on the bus, s since 1970. */
  time: number;
  /** As cansend takes it: 185#3716. */
  toString(): string;
}

/** The bus of a unit, read by candump. */
export class Bus extends EventEmitter {
  readonly path: string;
  readonly frames: Frame[];
  /** Sends a frame as cansend takes it: '205#0F00'. */
  send(frame: string): Promise<void>;
  /** The next frame under `id`; those before it are passed over. `timeout` in ms. */
  waitFor(id?: number, options?: { data?: string; where?: (frame: Frame) => boolean; timeout?: number }): Promise<Frame>;
  /** Injects a fault of the bus: inject('bus.drop', { id: '0x185', times: 1 }). */
  inject(kind: string, keys?: Partial<FaultValue>): Promise<Fault>;
  faults(): Promise<Fault[]>;
  /** Passes over all frames so far. */
  skip(): void;
}

export class Fault {
  readonly id: number;
  readonly kind: string;
  row(): Promise<{ id: number; kind: string; state: string; hits: number; opportunities: number; hit_at?: number[] }>;
  hits(): Promise<number>;
  state(): Promise<'waiting' | 'active' | 'over'>;
  wait(hits?: number, timeout?: number): Promise<void>;
  remove(): Promise<void>;
}

export interface UnitKeys {
  /** How many, or what the configuration says of each. */
  axes?: number | object[];
  /** Further keys of the configuration, docs/reference/configuration.md. */
  config?: object;
  /** Faults that are loaded at the start. */
  inject?: FaultValue[];
  /** That of faults with a probability that have none. */
  seed?: number;
  nodeId?: number;
  /** The path of a bus that is served already; without it the unit has a private one. */
  bus?: string;
  /** Of the private bus, bit/s; 0: frames take no time. */
  bitRate?: number;
  /** Whose time the private bus has: 'real' or 'scaled=10'. Timeouts are ms of this process. */
  time?: string;
  /** Further words for the command line of axisd. */
  options?: string[];
  /** ms that calls and waits take at most unless they are told. */
  timeout?: number;
}

export interface Wish {
  state?: string;
  nmt?: string;
  message?: string;
  gone?: string;
  value?: string;
  frame?: number;
  axis?: number;
  data?: string;
  where?: (frame: Frame) => boolean;
  lt?: number;
  le?: number;
  eq?: number;
  ne?: number;
  ge?: number;
  gt?: number;
  timeout?: number;
}

/** A daemon and a bus of its own, from its boot-up to close(). */
export class Unit {
  /** Starts one and sets CAN_BUS; rejects with the one line of axisd if it does not take the configuration. */
  static start(keys?: UnitKeys): Promise<Unit>;
  readonly nodeId: number;
  readonly bus: Bus;
  /** What has happened since the start, as lines of events.subscribe. */
  readonly events: Array<Record<string, unknown>>;
  call(method: string, params?: object): Promise<any>;
  status(): Promise<any>;
  state(axis?: number): Promise<string>;
  explain(axis?: number): Promise<string[]>;
  read(parameter: string): Promise<number | string>;
  write(parameter: string, value: number | string): Promise<void>;
  signal(name: string): Promise<number | null>;
  nmt(command: 'start' | 'stop' | 'pre-operational' | 'reset-node' | 'reset-communication'): Promise<void>;
  switchOn(axis?: number): Promise<void>;
  inject(kind: string, keys?: Partial<FaultValue>): Promise<Fault>;
  faults(): Promise<Fault[]>;
  removeFaults(): Promise<number>;
  /** Waits for one thing; resolves with the frame or value, if it was one. */
  wait(wish: Wish): Promise<any>;
  /** Frames, state and faults, as text. */
  report(): Promise<string>;
  /** Runs `body`; if that fails, the report is a diagnostic of the test. */
  watch<T>(t: { diagnostic(text: string): void }, body: (unit: Unit) => Promise<T>): Promise<T>;
  close(): Promise<void>;
}
