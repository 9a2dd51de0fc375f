import { useId, useRef, useState } from "preact/hooks";

import { usePage } from "../../app/context";
import { refusalLines } from "../text/refusal_text";
import { WriteQueue } from "./write_queue";

interface Props {
  label: string;
  /** The value as it is now, shown until something is typed. */
  present: string;
  unit?: string;
  /** What can be typed and when, below the field. */
  hint?: string;
  /** Why it cannot be written at the moment, as the unit says it; the field stays usable. */
  refusal?: string;
  suggestions?: readonly string[];
  /** What has been typed, for suggestions. */
  onTyped?: (text: string) => void;
  /** Writes; rejected with a Refusal. */
  write: (text: string) => Promise<void>;
}

/** What came of the last write. */
interface Outcome {
  lines: string[];
  isRefused: boolean;
}

/**
 * A field whose text is written with Enter or its button; a refusal is said below, and what was typed stays. What is
 * written before the last answer has come is written after it (WriteQueue).
 */
export function WriteField(props: Props) {
  const { permission } = usePage();
  const id = useId();
  const [typed, setTyped] = useState<string | null>(null);
  const [outcome, setOutcome] = useState<Outcome | null>(null);
  const [isBusy, setIsBusy] = useState(false);
  const queue = useRef(new WriteQueue());
  const mayNot = permission.refusal.value;
  const text = typed ?? props.present;
  const type = (value: string): void => {
    setTyped(value);
    setOutcome(null);
    props.onTyped?.(value);
  };
  const forget = (): void => {
    setTyped(null);
    setOutcome(null);
  };
  const forgetWritten = (written: string): void => setTyped((now) => (now?.trim() === written ? null : now));
  const write = async (wanted: string): Promise<boolean> => {
    setIsBusy(true);
    const outcome = await outcomeOf(props.write, wanted, (error) => permission.note(error), () => forgetWritten(wanted));
    setOutcome(outcome);
    setIsBusy(false);
    return !outcome.isRefused;
  };
  const submit = (event: Event): void => {
    event.preventDefault();
    void queue.current.add(text.trim(), write);
  };
  return (
    <form class="write-field" onSubmit={submit}>
      <label for={id}>
        {props.label}
        {props.unit ? ` (${props.unit})` : ""}
      </label>
      <div class="write-field-row">
        <input
          id={id}
          value={text}
          disabled={mayNot !== ""}
          autocomplete="off"
          spellcheck={false}
          list={props.suggestions === undefined ? undefined : `${id}-list`}
          aria-describedby={`${id}-said`}
          aria-invalid={outcome?.isRefused === true}
          onInput={(event) => type(event.currentTarget.value)}
          onKeyDown={(event) => event.key === "Escape" && setTyped(null)}
        />
        <button type="submit" class="primary" disabled={mayNot !== ""}>
          {isBusy ? "Writing …" : "Write"}
        </button>
        {typed !== null && typed !== props.present && (
          <button type="button" onClick={forget}>
            Undo typing
          </button>
        )}
      </div>
      {props.suggestions !== undefined && (
        <datalist id={`${id}-list`}>
          {props.suggestions.map((each) => (
            <option key={each} value={each} />
          ))}
        </datalist>
      )}
      <div id={`${id}-said`}>
        <Said outcome={outcome} refusal={mayNot === "" ? props.refusal : mayNot} hint={props.hint} />
      </div>
    </form>
  );
}

function Said(props: { outcome: Outcome | null; refusal: string | undefined; hint: string | undefined }) {
  const { outcome, refusal, hint } = props;
  return (
    <>
      <div role="status">
        {outcome !== null && (
          <p class={`notice ${outcome.isRefused ? "notice-error" : "notice-info"}`}>{outcome.lines.join(" ")}</p>
        )}
      </div>
      {refusal !== undefined && refusal !== "" && <p class="muted">{refusal}</p>}
      {hint !== undefined && <p class="muted">{hint}</p>}
    </>
  );
}

async function outcomeOf(
  write: Props["write"],
  text: string,
  refused: (error: unknown) => void,
  written: () => void,
): Promise<Outcome> {
  try {
    await write(text);
    written();
    return { lines: [`${text} was written.`], isRefused: false };
  } catch (error) {
    refused(error);
    return { lines: ["Refused:", ...refusalLines(error)], isRefused: true };
  }
}
