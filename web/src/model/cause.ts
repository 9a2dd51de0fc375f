import { decodeNmt } from "../canopen/network";
import { changedBits, changeText, commandKind, commandOf, wordText, type BitRow } from "../canopen/words";
import type { UnitEvent } from "../source/types";
import { lastChange, type ControlwordChange } from "./story/controlword";
import { eventAt } from "./event_store";
import { eventWords, timeText } from "./story/event_words";
import type { FrameStore } from "./frame_store";
import { laneNumber } from "../canopen/services";
import { pointerOf, type Past, type Pointer } from "./story/past";
import { kHappenings, moversOf, type Happening, type Mover } from "./story/transitions";

/** Why something has happened. */
export interface Cause {
  /** A sentence. */
  text: string;
  /** What it points to; undefined: by itself. */
  pointer?: Pointer;
  /** Of a controlword that has changed. */
  controlword?: { before?: number | undefined; now: number; changed: BitRow[] };
}

export { storyOfFault, type FaultStory, type Step } from "./story/fault_story";
export type { Past, Pointer } from "./story/past";

const kCycle = 0.004;
/** A controlword acts with the next cycle; events are seen at its end, and the sender may be late by one. */
const kCycles = 3;
/** Frames have six decimals (s). */
const kRounding = 1e-6;
/** Least time that is looked back (s): a machine that is busy runs cycles late. */
const kLeast = 0.02;
const kHappeningKinds: readonly Mover[] = ["initialised", "standstill", "fault", "acknowledged", "measurement", "voltage-lost"];

function isHappening(mover: Mover): mover is Happening {
  return kHappeningKinds.includes(mover);
}

/** Time between the two newest SYNC frames before @param t, 0 without: a synchronous RPDO waits so long. */
function syncPeriod(frames: FrameStore, t: number): number {
  const sync = laneNumber("sync");
  const times: number[] = [];
  for (let serial = frames.at(t) - 1; serial >= frames.first && times.length < 2; --serial) {
    if (t - frames.timeOf(serial) > 2) break;
    if (frames.laneAt(serial) === sync) times.push(frames.timeOf(serial));
  }
  return times.length < 2 ? 0 : (times[0] ?? 0) - (times[1] ?? 0);
}

function causeOfChange({ now, before }: ControlwordChange, event: UnitEvent, { decoder }: Past): Cause {
  const { profile } = decoder.settings;
  const changed = before === undefined ? [] : changedBits(before.value, now.value, profile);
  const was = before === undefined ? "" : `${wordText(before.value)} → `;
  const bits = changed.length === 0 ? "" : `: ${changed.map(changeText).join(", ")}`;
  const when = now.t > event.t ? "in the same cycle" : `${timeText(event.t - now.t)} before`;
  const text = `Controlword ${was}${wordText(now.value)} (${commandOf(now.value, profile)}) in ${now.by}, ${when}${bits}.`;
  return { text, pointer: pointerOf(now), controlword: { before: before?.value, now: now.value, changed } };
}

/** Whether @param change can have caused the transition. */
function fits(change: ControlwordChange, movers: readonly Mover[]): boolean {
  if (movers.length === 0) return true;
  if (movers.includes("acknowledged") && (change.now.value & 0x80) !== 0) return true;
  const command = commandKind(change.now.value);
  if (movers.includes("quick-stop") && command === "disable-voltage") return true;
  return movers.includes(command);
}

/**
 * The change of the controlword that has caused @param event. States of a trace have the time at which their step
 * began: the frame may be later by a cycle.
 */
function changeFor(
  event: UnitEvent,
  past: Past,
  axis: number,
  cycles: number,
  movers: readonly Mover[],
): ControlwordChange | undefined {
  const since = event.t - cycles - 2 * syncPeriod(past.frames, event.t);
  for (const until of [event.t + kRounding, event.t + (past.cycleS ?? kCycle)]) {
    const change = lastChange(past, axis, until, since);
    const isInTime = change !== undefined && (change.now.isSynchronous || event.t - change.now.t <= cycles);
    if (isInTime && fits(change, movers)) return change;
  }
  return undefined;
}

/** The newest event in [until - within, until] that @param wanted takes. */
function newest(
  events: readonly UnitEvent[],
  until: number,
  within: number,
  wanted: (event: UnitEvent) => boolean,
): UnitEvent | undefined {
  for (let place = eventAt(events, until + 1e-9) - 1; place >= 0; --place) {
    const event = events[place];
    if (event === undefined || until - event.t > within) return undefined;
    if (wanted(event)) return event;
  }
  return undefined;
}

function sameDrive(event: UnitEvent, other: UnitEvent): boolean {
  return event.axis === undefined || other.axis === undefined || event.axis === other.axis;
}

/** What the client of the control socket did that can switch a drive: panels, wiring, acknowledgements. */
function actsOnDrive(event: UnitEvent, of: UnitEvent): boolean {
  const kind: string = event.kind;
  if (!sameDrive(event, of)) return false;
  if (kind === "control") return /^(panel|fault|input|if1|pkw|ds47|supply|unit)\./.test(event.method ?? "");
  return kind === "parameter" || (kind === "nmt" && event.state !== "Operational");
}

/** The change before that began what now ends: OFF1 for OFF1 braking. */
function causeOfStandstill(event: UnitEvent, past: Past): Cause {
  const began = newest(past.events, event.t - 1e-9, Infinity, (other) =>
    other.kind === "drive-state" && other.axis === event.axis && other.state === event.before);
  if (began === undefined) return { text: kHappenings.standstill };
  const braked = timeText(event.t - began.t);
  return {
    text: `The drive has come to a standstill by itself, ${braked} after ${String(event.before)} began.`,
    pointer: { t: began.t, event: began },
  };
}

function causeOfNmt(event: UnitEvent, past: Past): Cause {
  const lane = laneNumber("nmt");
  const node = past.decoder.settings.services.nodeId;
  const [begin, end] = past.frames.range(event.t - kLeast, event.t + 1e-6);
  for (let serial = end - 1; serial >= begin; --serial) {
    const frame = past.frames.laneAt(serial) === lane ? past.frames.frame(serial) : undefined;
    const whom = frame?.data[1] ?? -1;
    if (frame === undefined || (whom !== 0 && node !== undefined && whom !== node)) continue;
    return { text: `NMT command: ${decodeNmt(frame).text}.`, pointer: { t: frame.t, frame: serial } };
  }
  const other = newest(past.events, event.t, kLeast, ({ kind }) => ["link", "bus", "fault", "power"].includes(kind));
  if (other === undefined) return { text: "By itself: no NMT command was received." };
  return { text: `Without an NMT command; just before: ${eventWords(other)}.`, pointer: { t: other.t, event: other } };
}

/** Why the drive state (or NMT state) changed with @param event. */
export function causeOfState(event: UnitEvent, past: Past): Cause {
  if (event.kind === "nmt") return causeOfNmt(event, past);
  const movers = moversOf(String(event.before ?? ""), event.state ?? "", past.decoder.settings.profile);
  const axis = event.axis === "infeed" ? 0 : Number(event.axis ?? 0);
  const cycles = Math.max(kCycles * (past.cycleS ?? kCycle), kLeast);
  const change = axis === 0 ? undefined : changeFor(event, past, axis, cycles, movers);
  if (change !== undefined && !movers.includes("fault")) return causeOfChange(change, event, past);
  if (movers.includes("fault")) {
    const fault = newest(past.events, event.t, cycles, (other) =>
      other.kind === "fault" && other.active !== false && sameDrive(other, event)) ?? following(past.events, event);
    if (fault !== undefined) return { text: `Fault ${eventWords(fault)}.`, pointer: { t: fault.t, event: fault } };
  }
  if (change !== undefined) return causeOfChange(change, event, past);
  const acted = newest(past.events, event.t, Math.max(cycles, 0.1), (other) => actsOnDrive(other, event));
  if (movers.includes("standstill")) return causeOfStandstill(event, past);
  if (acted !== undefined) return { text: `Just before: ${eventWords(acted)}.`, pointer: { t: acted.t, event: acted } };
  const own = movers.find(isHappening);
  return { text: own === undefined ? "By itself: no controlword has changed within the last cycles." : `${kHappenings[own]} Nothing on the bus or the control socket came with it.` };
}

/** A fault that comes with the state may stand behind it, at the same time. */
function following(events: readonly UnitEvent[], event: UnitEvent): UnitEvent | undefined {
  for (let place = eventAt(events, event.t); place < events.length; ++place) {
    const other = events[place];
    if (other === undefined || other.t > event.t + kCycle) return undefined;
    if (other.kind === "fault" && other.active !== false && sameDrive(other, event)) return other;
  }
  return undefined;
}
