import { useId, useState } from "preact/hooks";

import { numberIn } from "../number_text";
import { Problem, useAction, type Hand } from "../action";
import { findMessages, numberOf } from "./message_search";

/** Most messages that are offered. */
const kMost = 12;

/** Makes a fault or alarm occur, found by its number or by words. */
export function InjectField(props: { hand: Hand; place: number }) {
  const { hand, place } = props;
  const action = useAction(hand.journal);
  const hint = useId();
  const [text, setText] = useState("");
  const [value, setValue] = useState("0");
  const found = text.trim() === "" ? [] : findMessages(text, place, kMost);
  const inject = (code: string): void => {
    const number = numberOf(code);
    const faultValue = numberIn(value);
    if (number === undefined) action.refuse(`“${code}” is no number of a fault: 7860, F07860 or A07850.`);
    else if (faultValue === undefined) action.refuse(`“${value}” is no fault value: a whole number from 0.`);
    else
      void action.run(`Make ${code} occur at ${place === 0 ? "the control unit" : `axis ${place}`}`, () =>
        hand.source.act("POST", hand.unit, `axes/${place}/faults`, { number, value: faultValue }),
      );
  };
  return (
    <form
      onSubmit={(event) => {
        event.preventDefault();
        inject(text.trim());
      }}
    >
      <div class="row">
        <label class="field hands-grow">
          Fault or alarm
          <input type="search" value={text} placeholder="7860, or words" aria-describedby={hint} onInput={(event) => setText(event.currentTarget.value)} />
        </label>
        <label class="field">
          Its value
          <input class="hands-number" inputMode="numeric" value={value} onInput={(event) => setValue(event.currentTarget.value)} />
        </label>
        <button type="submit" disabled={action.isBusy}>
          Make it occur
        </button>
      </div>
      <Problem lines={action.problem} />
      <p id={hint} class="muted" role="status">
        {text.trim() === "" ? "By its number, or by words of what it means." : found.length === 0 ? "No fault or alarm has these words." : ""}
      </p>
      <ul class="hands-found">
        {found.map(([code, , name, cause]) => (
          <li key={code}>
            <button type="button" onClick={() => setText(code)} title={cause}>
              <span class="mono">{code}</span> {name}
            </button>
          </li>
        ))}
      </ul>
    </form>
  );
}
