import type { Source } from "../../source/source";
import type { ParameterDifference, ParameterEntry, Place } from "../../source/types";
import type { Filter } from "../text/filters";
import { LiveParameters } from "./live_parameters";
import type { Part } from "../shared/paged_list";
import { RecordedParameters } from "./recorded_parameters";

/** What is listed. */
export interface Wanted {
  place: Place;
  /** Beginning of a number, or words of name and effect; empty: any. */
  text: string;
  filter: Filter;
}

export type Reference = "factory" | "stored";

/** A part of the differences, of all places. */
export interface Differences extends Part<ParameterDifference> {
  /** Whether anything was saved yet. */
  isStored: boolean;
}

/** Where a parameter is that was not found in the place that was asked. */
export interface Elsewhere {
  parameter: string;
  name: string;
  places: Place[];
}

/** The parameters of a unit, alive or recorded. All promises are rejected with a Refusal. */
export interface ParameterSource {
  /** A part of what is wanted. */
  part(wanted: Wanted, from: number): Promise<Part<ParameterEntry>>;
  /** The parameters called @param names, as they are now; what the place does not have is missing in a recording, refused by a unit. */
  read(place: Place, names: readonly string[]): Promise<ParameterEntry[]>;
  /** Parameters of any place that @param text finds. */
  elsewhere(text: string): Promise<Elsewhere[]>;
  differences(against: Reference, from: number): Promise<Differences>;
}

/** The parameters of @param unit in @param source. */
export function parametersOf(source: Source, unit: string): ParameterSource {
  return source.isLive ? new LiveParameters(source, unit) : new RecordedParameters(source, unit);
}
