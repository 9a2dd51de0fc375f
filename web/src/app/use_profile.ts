import { profileOf, type Profile } from "../model/profile";
import { usePage } from "./context";

/** The profile of the unit called @param unit; undefined until there is an answer about units. */
export function useProfile(unit: string): Profile | undefined {
  const { units } = usePage();
  const isWaiting = units.seenAt.value === 0 && units.absence.value === "";
  return isWaiting ? undefined : profileOf(units.find(unit));
}
