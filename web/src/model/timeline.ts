import type { UnitEvent } from "../source/types";

/** A state from one time to another; Infinity: it lasts. */
export interface Band {
  from: number;
  to: number;
  state: string;
  /** With what it begins, of the drive-state or NMT event; undefined: it held before all that is known. */
  event?: UnitEvent;
}

/** States of a unit in the course of time. */
export interface Timeline {
  nmt: Band[];
  /** By place: 1.. = axis, "infeed". */
  axes: Map<number | "infeed", Band[]>;
}

/** States at the end of what is known (now, or at the end of a recording), for what no event says. */
export interface KnownStates {
  nmt?: string | undefined;
  axes?: readonly { axis: number | "infeed"; state: string }[] | undefined;
}

/** The bands of all states; @param events in their order. */
export function timelineOf(events: readonly UnitEvent[], known: KnownStates = {}): Timeline {
  void events;
  void known;
  return { nmt: [], axes: new Map() };
}

/** Those of @param bands that are in [from, to). */
export function bandsIn(bands: readonly Band[], from: number, to: number): Band[] {
  return bands.filter((band) => band.to > from && band.from < to);
}
