import type { Source } from "../source/source";

/** Which device a unit is: the drive unit, or an axis of CiA 402, which has objects and no parameters. */
export type Profile = "s120" | "cia402";

/** The profile that @param unit tells; one that tells none is a drive unit. */
export function profileOf(unit: { profile?: string } | undefined): Profile {
  return unit?.profile === "cia402" ? "cia402" : "s120";
}

/** Whether a unit of @param profile has parameters, with all that is made of them: wiring, operator panel, identification. */
export function hasParameters(profile: Profile): boolean {
  return profile === "s120";
}

/** The profile that @param unit of @param source tells; undefined: it tells none. */
export async function profileAt(source: Source, unit: string): Promise<Profile | undefined> {
  const all = await source.overview().catch(() => []);
  const told = all.find((each) => each.unit === unit);
  return told?.profile === undefined ? undefined : profileOf(told);
}
