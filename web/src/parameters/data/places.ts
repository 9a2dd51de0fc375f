import type { Source } from "../../source/source";
import type { Place } from "../../source/types";

/** The drive objects of @param unit: control unit, infeed if it is one, axes. */
export async function placesOf(source: Source, unit: string): Promise<Place[]> {
  const status = await source.get<{ axes?: { axis: number }[] }>(unit, "");
  const supply = await source.get<{ is_drive_object?: boolean }>(unit, "supply").catch(() => ({ is_drive_object: false }));
  const axes = (status.axes ?? []).map(({ axis }) => axis);
  return supply.is_drive_object === true ? [0, "infeed", ...axes] : [0, ...axes];
}
