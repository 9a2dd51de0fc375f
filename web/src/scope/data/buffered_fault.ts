import { Refusal } from "../../source/refusal";
import type { Source } from "../../source/source";
import type { Buffers, UnitEvent } from "../../source/types";

/** A fault or alarm as the buffer of its place has it, as if it were an event; a Refusal if it is not there. */
export async function bufferedFault(source: Source, unit: string, place: number | "infeed", number: number): Promise<UnitEvent> {
  const buffers = await source.get<Buffers>(unit, `axes/${place}/faults`);
  const find = (list: Buffers["faults"] = []): NonNullable<Buffers["faults"]>[number] | undefined => list.find((each) => each.number === number);
  const fault = find(buffers.faults);
  const found = fault ?? find(buffers.alarms);
  if (found === undefined)
    throw new Refusal("unknown", `Neither the events that are known nor the fault buffer have a fault or an alarm ${number} of place ${place}.`);
  const kind = fault === undefined ? "alarm" : "fault";
  const letter = kind === "fault" ? "F" : "A";
  const name = `${letter}${String(number).padStart(5, "0")}`;
  const { received_s: t, value } = found;
  return { t, unit, kind, axis: place, number, name, text: found.name?.replace(/^[FA]\d+\s*/, "") ?? "", value, active: true };
}
