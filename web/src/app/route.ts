/** The pages, in the order of the navigation. */
export const kPages = [
  { page: "overview", title: "Overview", needsUnit: false },
  { page: "scope", title: "Scope", needsUnit: true },
  { page: "states", title: "State machine", needsUnit: true },
  { page: "parameters", title: "Parameters", needsUnit: true },
  { page: "objects", title: "Objects", needsUnit: true },
  { page: "process-data", title: "Process data", needsUnit: true },
  { page: "hands", title: "Hands", needsUnit: true },
  { page: "fleet", title: "Fleet", needsUnit: false },
] as const;

export type PageName = (typeof kPages)[number]["page"];

/** Where the page is: `#/scope/vcan0/5?axis=1` is page scope of unit vcan0/5 with axis 1. */
export interface Route {
  page: PageName;
  /** BUS/NODE, empty: none was named. */
  unit: string;
  query: URLSearchParams;
}

/** The route in @param hash; what is no page is the overview. */
export function parseRoute(hash: string): Route {
  const [path = "", query = ""] = hash.replace(/^#\/?/, "").split("?", 2);
  const [name = "", ...unit] = path.split("/").map(decodeURIComponent);
  const known = kPages.find((each) => each.page === name);
  return { page: known?.page ?? "overview", unit: known ? unit.join("/") : "", query: new URLSearchParams(query) };
}

/** The hash of a page, for links. */
export function linkTo(page: PageName, unit = "", query: Record<string, string | number> = {}): string {
  const words = new URLSearchParams(Object.entries(query).map(([key, value]) => [key, String(value)])).toString();
  return `#/${page}${unit === "" ? "" : `/${unit}`}${words === "" ? "" : `?${words}`}`;
}
