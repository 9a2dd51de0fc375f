import type { ParameterEntry } from "../../source/types";

/** Which parameters are listed; `holds` says it of an entry, as the unit would. */
export const kFilters = [
  { filter: "all", title: "All", holds: () => true },
  { filter: "changed", title: "Changed against factory", holds: (entry: ParameterEntry) => entry.differs_from_factory === true },
  { filter: "unsaved", title: "Not saved", holds: (entry: ParameterEntry) => entry.differs_from_stored === true },
  { filter: "writable", title: "Writable now", holds: (entry: ParameterEntry) => entry.writable },
  { filter: "inputs", title: "BICO inputs", holds: (entry: ParameterEntry) => entry.type === "BI" || entry.type === "CI" },
  { filter: "outputs", title: "BICO outputs", holds: (entry: ParameterEntry) => entry.uses !== undefined },
] as const;

export type Filter = (typeof kFilters)[number]["filter"];

/** The filter that @param text names; all, if it names none. */
export function filterOf(text: string | null): Filter {
  return kFilters.find((each) => each.filter === text)?.filter ?? "all";
}

/** Whether @param entry is listed with @param filter. */
export function holds(filter: Filter, entry: ParameterEntry): boolean {
  return kFilters.find((each) => each.filter === filter)?.holds(entry) ?? true;
}
