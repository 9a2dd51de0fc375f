import { useEffect, useState } from "preact/hooks";

import { replaceQuery, route } from "../../app/context";
import { linkTo, type PageName } from "../../app/route";

/** Words of the address that are to be set; undefined or empty takes one away. */
export type Patch = Record<string, string | undefined>;

/** @param query with @param patch. */
export function patched(query: URLSearchParams, patch: Patch): URLSearchParams {
  const words = new URLSearchParams(query);
  for (const [key, value] of Object.entries(patch)) {
    if (value === undefined || value === "") words.delete(key);
    else words.set(key, value);
  }
  return words;
}

/** What stands in the address of a page of a unit. */
export interface Address {
  query: URLSearchParams;
  /** Exchanges words without a step in the browser's history. */
  replace: (patch: Patch) => void;
  /** The link to the same page with other words. */
  link: (patch: Patch) => string;
  /** Goes there, with a step in the history. */
  go: (patch: Patch) => void;
}

/** The address of @param page of @param unit; the page is rendered again when its words change. */
export function useAddress(page: PageName, unit: string): Address {
  const present = route.value;
  const [query, setQuery] = useState(present.query);
  useEffect(() => setQuery(present.query), [present]);
  const link = (patch: Patch): string => linkTo(page, unit, Object.fromEntries(patched(query, patch)));
  return {
    query,
    link,
    replace: (patch) => {
      const words = patched(query, patch);
      replaceQuery(words);
      setQuery(words);
    },
    go: (patch) => {
      location.hash = link(patch);
    },
  };
}
