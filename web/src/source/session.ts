import { Refusal } from "./refusal";

/** A unit of a recorded session: its resources as they were at the end, and what was recorded. */
export interface SessionUnit {
  unit: string;
  resources: Record<string, unknown>;
  eds?: string;
  recordings: { name: string; data: string }[];
}

/** What `axisctl record --html` puts into the page (docs/reference/session.md). */
export interface Session {
  format: "axisd-session";
  version: number;
  title: string;
  made_by: string;
  made_at: string;
  verdict?: { passed: boolean; text: string };
  report?: unknown;
  units: SessionUnit[];
}

/** The session in @param value, or a Refusal that says what is wrong. */
export function sessionOf(value: unknown): Session {
  const session = value as Partial<Session> | null;
  if (session?.format !== "axisd-session")
    throw new Refusal("damaged", "this is no recorded session: it has no \"format\": \"axisd-session\"");
  if (session.version !== 1)
    throw new Refusal("damaged", `the session has version ${String(session.version)}, this page reads version 1`);
  if (!Array.isArray(session.units)) throw new Refusal("damaged", "the session has no list of units");
  return session as Session;
}

/** The session that stands in the page; null: none, the page is served by a gateway. */
export function embeddedSession(document: Document): Session | null {
  const element = document.getElementById("session");
  if (element === null) return null;
  let value: unknown;
  try {
    value = JSON.parse(element.textContent);
  } catch {
    throw new Refusal("damaged", "the session in this page is damaged: it is no JSON");
  }
  return value === null ? null : sessionOf(value);
}

/** The bytes of base64 text. */
export function bytesOf(text: string): Uint8Array {
  return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
}
