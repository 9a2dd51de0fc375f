import { useEffect, useRef, useState } from "preact/hooks";

import { useProfile } from "../../app/use_profile";
import { hasParameters } from "../../model/profile";
import { wordsOf } from "../../source/refusal";
import type { SignalEntry } from "../../source/types";
import type { ScopeState } from "../data/scope_state";
import { kMostSignals } from "../view/link";

/** Time after the last letter until it is searched (ms). */
const kPause = 200;
const kMost = 40;

interface Found {
  signals: SignalEntry[];
  total: number;
}

/** The name of @param entry with index and bit as @param text says behind it: "r0949[3]", "r0899.2". */
function nameOf(entry: SignalEntry, text: string): string {
  const part = /(\[\d+\])?(\.\d+)?$/.exec(text.trim())?.[0] ?? "";
  const isIndex = part.startsWith("[") && entry.indices !== undefined;
  const isBit = part.includes(".") && entry.bits !== undefined;
  return part !== "" && (isIndex || isBit) ? `${entry.signal}${part}` : entry.signal;
}

/** Search by number and text; what is chosen is shown at once. */
export function SignalSearch(props: { state: ScopeState; isFull: boolean }) {
  const { state } = props;
  const [text, setText] = useState("");
  const [found, setFound] = useState<Found | undefined>(undefined);
  const [error, setError] = useState("");
  const turn = useRef(0);
  const isOfParameters = hasParameters(useProfile(state.unit) ?? "s120");

  useEffect(() => {
    const words = text.trim();
    const mine = ++turn.current;
    if (words === "") {
      setFound(undefined);
      return undefined;
    }
    const search = words.replace(/(\[\d+\])?(\.\d+)?$/, "");
    const timer = setTimeout(() => {
      state.page.source
        .get<Found>(state.unit, "signals", { search, count: kMost })
        .then((answer) => {
          if (mine !== turn.current) return;
          setFound(answer);
          setError("");
        })
        .catch((why: unknown) => {
          if (mine === turn.current) setError(wordsOf(why));
        });
    }, kPause);
    return () => clearTimeout(timer);
  }, [text]);

  const add = (entry: SignalEntry): void => {
    const name = nameOf(entry, text);
    const names = state.names.peek();
    if (names.includes(name) || props.isFull) return;
    state.heads.learn(entry, name);
    void state.choose([...names, name]);
  };

  return (
    <div class="scope-search">
      <label class="field">
        <span class="visually-hidden">{isOfParameters ? "Add a signal: number or words, with index and bit if wanted" : "Add a signal: words"}</span>
        <input
          type="search"
          value={text}
          placeholder={isOfParameters ? "Add a signal: speed, r0063, r0899.2" : "Add a signal: speed, torque"}
          onInput={(event) => setText(event.currentTarget.value)}
          onKeyDown={(event) => event.key === "Enter" && found?.signals[0] !== undefined && add(found.signals[0])}
        />
      </label>
      {props.isFull && <p class="muted">{`There are ${kMostSignals} signals: take one away first.`}</p>}
      {error !== "" && <p class="notice notice-error" role="alert">{error}</p>}
      {found !== undefined && (
        <>
          <p class="muted" aria-live="polite">
            {found.total === 0 ? "Nothing has these words." : `${found.total} found${found.total > kMost ? `, the first ${kMost} of them` : ""}`}
          </p>
          <ul class="scope-found" tabIndex={0} aria-label="Signals that were found">
            {found.signals.map((entry) => (
              <li key={entry.signal}>
                <button type="button" disabled={props.isFull || state.names.value.includes(nameOf(entry, text))} onClick={() => add(entry)}>
                  <code>{nameOf(entry, text)}</code> {entry.text} {entry.unit !== "" && <span class="muted">({entry.unit})</span>}
                </button>
              </li>
            ))}
          </ul>
        </>
      )}
    </div>
  );
}
