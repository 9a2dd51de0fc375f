import { useEffect } from "preact/hooks";

import { usePage } from "../../app/context";
import { poll } from "../../model/poll";
import type { PagedList } from "./paged_list";
import { visibleNames } from "./row_keys";

/** Time between two looks at the rows that can be seen (ms). */
const kPeriod = 1000;

/** Reads the rows of @param list again that can be seen in @param box, @param most at most, as long as the unit lives. */
export function useRefresh<T, W>(list: PagedList<T, W>, box: { current: HTMLElement | null }, most: number): void {
  const { isLive } = usePage().source;
  useEffect(() => {
    if (!isLive) return undefined;
    const look = async (): Promise<void> => {
      if (box.current !== null && !document.hidden) await list.refresh(visibleNames(box.current, most));
    };
    return poll(look, kPeriod);
  }, [list, isLive]);
}
