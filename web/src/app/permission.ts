import { signal } from "@preact/signals";

import { Refusal, wordsOf } from "../source/refusal";
import type { Source } from "../source/source";
import type { ServerInfo } from "../source/types";

const kTokenKey = "axisd-token";

/** The token that the user has given, kept for this tab. */
export const token = signal(sessionStorage.getItem(kTokenKey) ?? "");

/** Whether the user may change anything, and why not. */
export class Permission {
  readonly server = signal<ServerInfo | null>(null);
  /** Why the user may not act; empty: he may. */
  readonly refusal = signal("nobody has asked yet");

  constructor(private readonly source: Source) {}

  /** Asks the gateway what it allows with the present token. */
  async ask(): Promise<void> {
    try {
      this.server.value = await this.source.server();
      this.refusal.value = this.source.isLive ? reasonOf(this.server.value) : "This is a recording: nothing can be changed.";
    } catch (error) {
      this.refusal.value = `axisd-http does not say whether anything may be changed: ${wordsOf(error)}`;
    }
  }

  /** Takes @param text as the token; the refusal says whether it is the right one. */
  async take(text: string): Promise<void> {
    token.value = text.trim();
    if (token.value === "") sessionStorage.removeItem(kTokenKey);
    else sessionStorage.setItem(kTokenKey, token.value);
    await this.ask();
  }

  /** To be told of each refusal of an action: a token may have become wrong. */
  note(error: unknown): void {
    if (error instanceof Refusal && (error.status === 401 || error.status === 403)) void this.ask();
  }
}

function reasonOf(server: ServerInfo): string {
  if (server.read_only) return "axisd-http runs with --read-only: nothing can be changed.";
  if (server.token === "right") return "";
  if (server.token === "wrong") return "The token is wrong: it stands in the file that axisd-http names at its start.";
  return "Changing anything needs the token of axisd-http.";
}
