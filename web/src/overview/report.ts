/** A step of a scenario as the page shows it. */
export interface ReportStep {
  number: number;
  text: string;
  /** Since the start (s); undefined: it was not begun. */
  t: number | undefined;
  outcome: "passed" | "failed" | "not run";
  remark: string;
}

function outcomeOf(step: Record<string, unknown>): ReportStep["outcome"] {
  if (step["outcome"] === "passed" || step["passed"] === true) return "passed";
  return step["outcome"] === "failed" || step["passed"] === false ? "failed" : "not run";
}

function textOf(...values: unknown[]): string {
  return values.find((value): value is string => typeof value === "string") ?? "";
}

function numberOf(...values: unknown[]): number | undefined {
  return values.find((value): value is number => typeof value === "number");
}

function stepOf(value: unknown, index: number): ReportStep {
  const step = (value ?? {}) as Record<string, unknown>;
  const isTold = typeof step["what"] === "string";
  return {
    number: numberOf(step["number"], step["step"]) ?? index + 1,
    text: textOf(step["what"], step["text"]),
    t: numberOf(step["t_s"], step["t"]),
    outcome: outcomeOf(step),
    remark: textOf(step["remark"], isTold ? step["text"] : undefined),
  };
}

/** The steps of a report of `axisctl run`; none: it has none. */
export function stepsOf(report: unknown): ReportStep[] {
  const steps = (report as { steps?: unknown } | null | undefined)?.steps;
  return Array.isArray(steps) ? steps.map(stepOf) : [];
}

/** What a report says of the run as a whole: "seed 1, 0.052 s, the bus is gone". */
export function summaryOf(report: unknown): string {
  const { seed, seconds, problem } = (report ?? {}) as Record<string, unknown>;
  const words: string[] = [];
  if (typeof seed === "number") words.push(`seed ${seed}`);
  if (typeof seconds === "number") words.push(`${seconds.toFixed(3)}\u2009s`);
  if (typeof problem === "string" && problem !== "") words.push(problem);
  return words.join(", ");
}
