import type { components } from "../../generated/openapi";

type Schemas = components["schemas"];

/** GET UNIT: what the unit and its axes do. */
export type Status = Schemas["result.status"];
export type AxisStatus = NonNullable<Status["axes"]>[number];
export type DriveState = Schemas["drive-state"];
export type NmtState = Schemas["nmt-state"];
export type UnitEvent = Schemas["event"] & { id?: number; by?: string; method?: string };
export type Explanation = Schemas["result.explain"];
export type PdoList = Schemas["result.pdo.list"];
export type Pdo = NonNullable<PdoList["pdos"]>[number];
export type ParameterEntry = NonNullable<Schemas["result.parameter.list"]["parameters"]>[number];
export type ParameterDifference = NonNullable<Schemas["result.parameter.diff"]["parameters"]>[number];
export type ObjectEntry = Schemas["result.object.read"];
export type SignalEntry = NonNullable<Schemas["result.signal.list"]["signals"]>[number];
export type TraceStatus = Schemas["trace-status"];
export type Buffers = Schemas["result.fault.buffer"];
export type InjectKind = NonNullable<Schemas["result.inject.kinds"]["kinds"]>[number];
export type InjectedFault = NonNullable<Schemas["result.inject.list"]["faults"]>[number];
export type Message = Schemas["message"];

/** Where a parameter is: 0 = control unit, 1.. = axis. */
export type Place = number | "infeed";

/** What the overview says of an axis. */
export interface AxisOverview {
  axis: number;
  name: string;
  type: string;
  state: DriveState;
  /** Of an axis of CiA 402: "no mode", "profile position", ... */
  mode?: string;
  /** Of an axis of CiA 402: whether its home position is known. */
  homed?: boolean;
  speed_rpm: number;
  setpoint_rpm: number;
  torque_Nm: number;
  current_A: number;
  position: number;
  motor_temperature_C: number;
  faults: Message[];
  alarms: Message[];
}

/** What the overview says of a unit. */
export interface UnitOverview {
  unit: string;
  /** Of a farm: where it is. */
  host?: string;
  on: boolean;
  /** Why there is nothing more. */
  error?: string;
  node_id?: number;
  /** "cia402"; absent or "s120": the drive unit. */
  profile?: string;
  nmt_state?: NmtState;
  uptime_s?: number;
  leds?: { run: string; error: string };
  bus?: { state: string; link: string; received: number; sent: number; load_percent?: number };
  dc_link_V?: number;
  skipped_cycles?: number;
  control_unit?: { faults: Message[]; alarms: Message[] };
  axes?: AxisOverview[];
}

/** GET /api/v1/server: what the gateway allows. */
export interface ServerInfo {
  program: string;
  version: string;
  read_only: boolean;
  /** What the token of the request was. */
  token: "none" | "missing" | "wrong" | "right";
}

/** Samples of the asked signals; a row of values a signal. */
export interface SampleBatch {
  unit: string;
  t: number[];
  values: (number | null)[][];
  lost: number;
}

/** Frames as "12.345678 R 205#0F00". */
export interface FrameBatch {
  unit: string;
  t: number;
  frames: string[];
  lost: number;
}

/** GET UNIT/axes/{axis}/panel. */
export interface Panel {
  axis: number;
  active: boolean;
  on: boolean;
  speed_rpm: number;
  timeout_ms: number;
  remaining_ms: number;
  state: DriveState;
  refusal?: string;
}

/** GET UNIT/axes/{axis}/state-machine. */
export interface StateMachine {
  axis: number;
  state: DriveState;
  states: DriveState[];
  transitions: {
    /** That of CiA 402; absent where it has none. */
    number?: number;
    from: DriveState;
    to: DriveState;
    /** The unit takes it without a command. */
    by_itself?: boolean;
    is_open: boolean;
    conditions: { text: string; met: boolean; parameter?: string }[];
  }[];
}

/** GET UNIT/axes/{axis}/identification. */
export interface Identification {
  axis: number;
  selected: string;
  phase: "idle" | "waiting" | "measuring" | "done" | "failed";
  progress_percent: number;
  text: string;
  results: {
    parameter: string;
    name: string;
    unit: string;
    value: number;
    /** Absent where the data sheet does not say it. */
    data_sheet?: number | null;
    deviation_percent?: number | null;
  }[];
}
