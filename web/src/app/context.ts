import { signal } from "@preact/signals";
import { createContext } from "preact";
import { useContext } from "preact/hooks";

import type { Events } from "../model/events";
import type { Units } from "../model/units";
import type { Source } from "../source/source";
import type { Permission } from "./permission";
import { parseRoute, type Route } from "./route";

/** What every page works with. */
export interface Page {
  source: Source;
  units: Units;
  events: Events;
  permission: Permission;
}

/** Where the page is; pages write location.hash, or replaceQuery(), to go elsewhere. */
export const route = signal<Route>(parseRoute(location.hash));
addEventListener("hashchange", () => {
  route.value = parseRoute(location.hash);
});

/** Exchanges the query of the address without a step in the browser's history. */
export function replaceQuery(query: URLSearchParams): void {
  const path = location.hash.split("?", 1)[0] ?? "";
  const words = query.toString();
  history.replaceState(null, "", words === "" ? path : `${path}?${words}`);
}

export const PageContext = createContext<Page | null>(null);

/** The source, the units, the events and what may be done. */
export function usePage(): Page {
  const page = useContext(PageContext);
  if (page === null) throw new Error("outside of the page");
  return page;
}
