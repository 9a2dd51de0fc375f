import type { Source } from "../source/source";
import type { Pdo, PdoList } from "../source/types";

/** The PDOs of a unit at a time. */
export interface Pdos {
  pdos: Pdo[];
  /** Whether frames are counted, and since when (s). */
  isWatched: boolean;
  watchedSeconds: number;
}

/** What is wanted of the PDOs. */
export interface WantedPdos {
  /** 0: all. */
  axis: number;
  /** Those too that are not valid. */
  all: boolean;
}

/** The PDOs of @param unit; a recording has all of them, an answer of a unit comes in pages. */
export async function pdosOf(source: Source, unit: string, wanted: WantedPdos): Promise<Pdos> {
  const found: Pdos = { pdos: [], isWatched: false, watchedSeconds: 0 };
  const query = source.isLive ? { all: wanted.all, axis: wanted.axis === 0 ? undefined : wanted.axis } : { all: true };
  let from: number | undefined = 0;
  while (from !== undefined) {
    const page: PdoList = await source.get<PdoList>(unit, "pdos", { ...query, from });
    found.pdos.push(...page.pdos);
    found.isWatched = page.is_watched;
    found.watchedSeconds = page.watched_s ?? 0;
    from = source.isLive ? page.next : undefined;
  }
  found.pdos = found.pdos.filter((pdo) => isWanted(pdo, wanted));
  return found;
}

/** Whether @param pdo is among those that are wanted. */
export function isWanted(pdo: Pdo, { axis, all }: WantedPdos): boolean {
  return (all || pdo.is_valid) && (axis === 0 || pdo.axis === axis);
}
