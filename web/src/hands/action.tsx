import type { ComponentChildren } from "preact";
import { useState } from "preact/hooks";

import { usePage } from "../app/context";
import type { Source } from "../source/source";
import type { Journal } from "./journal";
import { refusalLines } from "./refusal_lines";

/** What the cards of the page act on. */
export interface Hand {
  source: Source;
  unit: string;
  axis: number;
  journal: Journal;
}

/** An action whose refusal is said beside it. */
export interface Action {
  isBusy: boolean;
  /** Why the last one was not done, line by line. */
  problem: string[];
  /** Does @param work, noted as @param words; true: it was done. */
  run: (words: string, work: () => Promise<unknown>) => Promise<boolean>;
  /** Says that what was typed cannot be sent. */
  refuse: (line: string) => void;
}

/** The state of an action of a card. */
export function useAction(journal: Journal): Action {
  const { permission } = usePage();
  const [isBusy, setIsBusy] = useState(false);
  const [problem, setProblem] = useState<string[]>([]);
  const run = async (words: string, work: () => Promise<unknown>): Promise<boolean> => {
    setIsBusy(true);
    try {
      await journal.run(words, work);
      setProblem([]);
      return true;
    } catch (error) {
      permission.note(error);
      setProblem(refusalLines(error));
      return false;
    } finally {
      setIsBusy(false);
    }
  };
  return { isBusy, problem, run, refuse: (line) => setProblem([line]) };
}

/** Where the refusal of an action is said. */
export function Problem(props: { lines: string[] }) {
  return (
    <div role="alert">
      {props.lines.length > 0 && (
        <p class="notice notice-error">
          {props.lines.map((line) => (
            <span key={line} class="hands-line">
              {line}{" "}
            </span>
          ))}
        </p>
      )}
    </div>
  );
}

/** A part of the page whose controls are off while nothing may be done. */
export function Card(props: { title: string; children: ComponentChildren; wide?: boolean }) {
  const { permission } = usePage();
  return (
    <section class={props.wide ? "card hands-card hands-wide" : "card hands-card"} aria-label={props.title}>
      <h2>{props.title}</h2>
      <fieldset class="hands-fields" disabled={permission.refusal.value !== ""}>
        {props.children}
      </fieldset>
    </section>
  );
}
