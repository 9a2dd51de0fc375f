/** Why something was not done, as the gateway or the unit says it. */
export class Refusal extends Error {
  readonly code: string;
  /** HTTP status; 0: there was no answer. */
  readonly status: number;
  readonly details: Record<string, unknown>;

  constructor(code: string, message: string, status = 0, details: Record<string, unknown> = {}) {
    super(message);
    this.name = "Refusal";
    this.code = code;
    this.status = status;
    this.details = details;
  }

  /** Whether the gateway or the daemon could not be reached: what was asked may be asked again. */
  get isAbsence(): boolean {
    return this.status === 0 || this.status >= 502;
  }
}

/** What anything that was thrown says to a person. */
export function wordsOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
