import { laneNumber } from "../../canopen/services";
import type { UnitEvent } from "../../source/types";
import { eventAt } from "../event_store";
import { eventWords } from "./event_words";
import type { Past, Pointer } from "./past";

/** A thing that has led to a fault, or that has come of it. */
export interface Step extends Pointer {
  text: string;
  /** Seconds since the fault; negative: before. */
  after: number;
}

/** The story of a fault or alarm. */
export interface FaultStory {
  event: UnitEvent;
  /** "F07900 Motor blocked/speed controller at its limit". */
  title: string;
  /** "fault value 2 (0x2)", ... */
  value: string;
  /** What has probably led to it, the most probable first. */
  causes: Step[];
  /** What the unit did, in the order of time. */
  reaction: Step[];
}

/** How far a cause may be in the past, and what came of it in the future (s). */
const kLookBack = 10;
const kLookAhead = 60;
const kMostCauses = 5;
const kMostSteps = 40;
/** A cause that is so long ago (s) weighs 1/e. */
const kFading = 3;
/** The unit tells of all that a cycle has brought at its end: what is so little later (s) may be the cause. */
const kSameCycle = 0.004;

/** What can lead to a fault: how much it weighs if it came just before. */
interface Suspect {
  matches: (event: UnitEvent, fault: UnitEvent) => boolean;
  weight: number;
}

function isMethod(event: UnitEvent, pattern: RegExp): boolean {
  const kind: string = event.kind;
  return kind === "control" && pattern.test(event.method ?? "");
}

function isSameDrive(event: UnitEvent, fault: UnitEvent): boolean {
  return event.axis === undefined || event.axis === 0 || event.axis === fault.axis || fault.axis === 0;
}

function names(event: UnitEvent, fault: UnitEvent): boolean {
  return new RegExp(`(^|\\D)0*${fault.number ?? -1}(\\D|$)`).test(event.text ?? "");
}

/** Faults of a group, with what leads to them: communication, supply, encoder, load. */
const kGroups: readonly { numbers: (number: number) => boolean; matches: Suspect["matches"] }[] = [
  { numbers: (n) => n >= 8700 && n < 8800, matches: (event) => ["nmt", "link", "bus", "power"].includes(event.kind) },
  {
    numbers: (n) => [7802, 7840, 7841, 30002, 30003, 30011].includes(n),
    matches: (event) => isMethod(event, /^supply\./),
  },
  { numbers: (n) => n >= 31000 && n < 34000, matches: (event) => isMethod(event, /^encoder\./) },
  { numbers: (n) => (n >= 7900 && n < 7910) || n === 30005, matches: (event) => isMethod(event, /^load\./) },
];

/** The first that matches counts. */
const kSuspects: readonly Suspect[] = [
  { matches: (event, fault) => isMethod(event, /^fault\.inject$/) && names(event, fault), weight: 100 },
  {
    matches: (event, fault) =>
      kGroups.some((group) => group.numbers(fault.number ?? -1) && group.matches(event, fault)),
    weight: 95,
  },
  { matches: (event, fault) => event.kind === "fault" && event.active !== false && isSameDrive(event, fault), weight: 85 },
  { matches: (event, fault) => isMethod(event, /^(load|supply|encoder)\./) && isSameDrive(event, fault), weight: 80 },
  { matches: (event) => isMethod(event, /^inject\.add$/), weight: 75 },
  { matches: (event, fault) => event.kind === "alarm" && event.active !== false && isSameDrive(event, fault), weight: 70 },
  { matches: (event) => ["link", "bus"].includes(event.kind), weight: 60 },
  { matches: (event, fault) => event.kind === "parameter" && isSameDrive(event, fault), weight: 55 },
  { matches: (event) => event.kind === "object", weight: 45 },
  { matches: (event) => event.kind === "nmt", weight: 40 },
  { matches: (event) => isMethod(event, /./), weight: 40 },
];

function stepOf(event: UnitEvent, fault: UnitEvent): Step {
  return { t: event.t, event, after: event.t - fault.t, text: eventWords(event) };
}

function causesOf(fault: UnitEvent, { events }: Past): Step[] {
  const found: { step: Step; weight: number }[] = [];
  for (let place = eventAt(events, fault.t - kLookBack); place < events.length; ++place) {
    const event = events[place];
    if (event === undefined || event.t > fault.t + kSameCycle) break;
    if (event === fault || (event.t === fault.t && event.number === fault.number)) continue;
    const suspect = kSuspects.find((row) => row.matches(event, fault));
    if (suspect === undefined || (event.t > fault.t && suspect.weight < 95)) continue;
    const weight = suspect.weight * Math.exp(-Math.max(fault.t - event.t, 0) / kFading);
    found.push({ step: stepOf(event, fault), weight });
  }
  return found
    .sort((a, b) => b.weight - a.weight)
    .slice(0, kMostCauses)
    .map(({ step }) => step);
}

/** Whether @param event tells what the unit did because of @param fault. */
function isReaction(event: UnitEvent, fault: UnitEvent): boolean {
  if (event.kind === "drive-state") return isSameDrive(event, fault);
  if (event.kind === "nmt" || event.kind === "emcy") return true;
  return event.kind === "fault" && event.number === fault.number && event.axis === fault.axis && event.active === false;
}

/** When the story is over: the fault has gone, or the same one has come again. */
function endOf(fault: UnitEvent, { events }: Past): number {
  const gone = events.find(
    (event) => event !== fault && event.kind === fault.kind && event.number === fault.number && event.axis === fault.axis && event.t > fault.t,
  );
  return Math.min(gone?.t ?? Infinity, fault.t + kLookAhead);
}

/** The emergency messages from @param from to @param to, as frames where they are kept. */
function emergencies(fault: UnitEvent, { frames, decoder }: Past, from: number, to: number): Step[] {
  const lane = laneNumber("emcy");
  const steps: Step[] = [];
  const [begin, end] = frames.range(from, to + 1e-6);
  for (let serial = begin; serial < end && steps.length < kMostSteps; ++serial) {
    if (frames.laneAt(serial) !== lane) continue;
    const frame = frames.frame(serial);
    if (frame?.sent !== true) continue;
    steps.push({ t: frame.t, frame: serial, after: frame.t - fault.t, text: decoder.decode(frame).headline });
  }
  return steps;
}

function reactionOf(fault: UnitEvent, past: Past): Step[] {
  const [from, to] = [fault.t, endOf(fault, past)];
  const frames = emergencies(fault, past, from - kSameCycle, to);
  const steps = [...frames];
  for (let place = eventAt(past.events, from); place < past.events.length; ++place) {
    const event = past.events[place];
    if (event === undefined || event.t > to) break;
    if (event === fault || !isReaction(event, fault)) continue;
    if (event.kind !== "emcy" || frames.length === 0) steps.push(stepOf(event, fault));
  }
  return steps.sort((a, b) => a.t - b.t).slice(0, kMostSteps);
}

/** What a fault or alarm is, what has led to it, and what came of it. */
export function storyOfFault(event: UnitEvent, past: Past): FaultStory {
  const number = typeof event.value === "number" ? event.value : Number(event.value ?? 0);
  const kind = event.kind === "alarm" ? "alarm value" : "fault value";
  return {
    event,
    title: `${event.name ?? ""} ${event.text ?? ""}`.trim(),
    value: `${kind} ${number} (0x${(number >>> 0).toString(16).toUpperCase()})`,
    causes: causesOf(event, past),
    reaction: reactionOf(event, past),
  };
}
