import type { UnitEvent } from "../source/types";

/** A state from one time to another; Infinity: it lasts. */
export interface Band {
  from: number;
  to: number;
  state: string;
  /** With what it begins, of the drive-state or NMT event; undefined: it held before all that is known. */
  event?: UnitEvent;
}

/** Where a drive state is: 1.. = axis, or the infeed. */
export type StatePlace = number | "infeed";

/** States of a unit in the course of time. */
export interface Timeline {
  nmt: Band[];
  axes: Map<StatePlace, Band[]>;
}

/** States at the end of what is known (now, or at the end of a recording), for what no event says. */
export interface KnownStates {
  nmt?: string | undefined;
  axes?: readonly { axis: StatePlace; state: string }[] | undefined;
}

/** What an event begins, if it begins a state: its place, "nmt" for that of the node. */
export function statePlaceOf(event: UnitEvent): StatePlace | "nmt" | undefined {
  if (event.kind === "nmt") return "nmt";
  if (event.kind !== "drive-state") return undefined;
  return event.axis === "infeed" ? "infeed" : Number(event.axis ?? 0);
}

function addState(bands: Band[], event: UnitEvent): void {
  const last = bands.at(-1);
  if (last !== undefined) last.to = event.t;
  else if (typeof event.before === "string") bands.push({ from: -Infinity, to: event.t, state: event.before });
  bands.push({ from: event.t, to: Infinity, state: event.state ?? "", event });
}

/** The bands of all states; @param events in their order. */
export function timelineOf(events: readonly UnitEvent[], known: KnownStates = {}): Timeline {
  const places = new Map<StatePlace | "nmt", Band[]>([["nmt", []]]);
  for (const { axis } of known.axes ?? []) places.set(axis, []);
  for (const event of events) {
    const place = statePlaceOf(event);
    if (place === undefined) continue;
    const bands = places.get(place) ?? [];
    places.set(place, bands);
    addState(bands, event);
  }
  const states = new Map<StatePlace | "nmt", string | undefined>([["nmt", known.nmt]]);
  for (const { axis, state } of known.axes ?? []) states.set(axis, state);
  for (const [place, bands] of places) {
    const state = states.get(place);
    if (bands.length === 0 && state !== undefined) bands.push({ from: -Infinity, to: Infinity, state });
  }
  const nmt = places.get("nmt") ?? [];
  const axes = new Map<StatePlace, Band[]>();
  for (const [place, bands] of places) if (place !== "nmt") axes.set(place, bands);
  return { nmt, axes };
}

/** Those of @param bands that are in [from, to). */
export function bandsIn(bands: readonly Band[], from: number, to: number): Band[] {
  return bands.filter((band) => band.to > from && band.from < to);
}
