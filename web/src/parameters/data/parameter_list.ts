import type { ParameterEntry } from "../../source/types";
import { PagedList } from "../shared/paged_list";
import type { ParameterSource, Wanted } from "./parameter_source";

/** The parameters that are wanted, as many as were asked for, with their present values. */
export type ParameterList = PagedList<ParameterEntry, Wanted>;

/** A list of the parameters of @param source. */
export function parameterList(source: ParameterSource): ParameterList {
  return new PagedList<ParameterEntry, Wanted>({
    part: (wanted, from) => source.part(wanted, from),
    again: ({ place }, rows) => source.read(place, rows.map((row) => row.parameter)),
    key: (row) => row.parameter,
  });
}
