import { parseEds } from "../../canopen/eds";
import { profileAt } from "../../model/profile";
import { openFile } from "../../recording/open_file";
import type { Source } from "../../source/source";
import type { Pdo, UnitEvent } from "../../source/types";
import type { Recording } from "../../recording/recording";
import type { Mark } from "./material";
import { RecordedMaterial, type Knowledge } from "./recorded_material";

/** What @param source knows of @param unit, as far as it can be asked. */
export async function knowledgeOf(source: Source, unit: string): Promise<Knowledge> {
  if (unit === "") return {};
  const eds = await source.eds(unit).then((text) => parseEds(text, unit)).catch(() => undefined);
  const pdos = await source.all<Pdo>(unit, "pdos", "pdos", { all: true }).catch(() => undefined);
  const node = Number(unit.split("/").at(-1));
  return { nodeId: Number.isInteger(node) ? node : undefined, eds, pdos, profile: await profileAt(source, unit) };
}

/** The material of @param recording; what its unit does not tell any more, @param unit tells: its EDS, and all if the file names none. */
export async function materialOf(source: Source, recording: Recording, unit: string, steps: readonly Mark[] = []): Promise<RecordedMaterial> {
  const isOther = recording.unit !== "" && recording.unit !== unit;
  const all = await source.overview().catch(() => []);
  const isThere = all.some((each) => each.unit === recording.unit);
  if (!isOther || isThere) return new RecordedMaterial(recording, await knowledgeOf(source, isOther ? recording.unit : unit), steps);
  const { eds } = await knowledgeOf(source, unit);
  return new RecordedMaterial(recording, { eds }, steps);
}

/** Opens the file called @param name: a Refusal says what is wrong with it. */
export async function openMaterial(source: Source, name: string, bytes: Uint8Array, unit: string): Promise<RecordedMaterial> {
  return materialOf(source, openFile(name, bytes), unit);
}

interface Step {
  t?: number;
  step?: number;
  name?: string;
  what?: string;
  text?: string;
  outcome?: string;
}

/** The steps of the scenario in @param report as marks; their times begin with the recording, at @param from. */
export function stepMarks(report: unknown, from: number): Mark[] {
  const steps = (report as { steps?: Step[] } | null | undefined)?.steps;
  if (!Array.isArray(steps)) return [];
  return steps
    .filter((step) => typeof step.t === "number" && step.outcome !== "not run")
    .map((step) => ({
      t: from + (step.t ?? 0),
      text: step.name ?? step.what ?? `step ${step.step ?? ""}`,
      isFailed: step.outcome === "failed",
    }));
}

/** The last coming of a fault or alarm in @param events. */
export function findFault(events: readonly UnitEvent[], place: number | "infeed", number: number): UnitEvent | undefined {
  return events.findLast(
    (event) =>
      (event.kind === "fault" || event.kind === "alarm") && event.active !== false && event.number === number && (event.axis ?? 0) === place,
  );
}
