import { useState } from "preact/hooks";

import { numberIn } from "../number_text";

/** A speed by slider and by number; @param onChange is told of each that is one. */
export function SetpointFields(props: { value: number; end: number; onChange: (rpm: number) => void; onSettled: (rpm: number) => void }) {
  const [typed, setTyped] = useState<string | undefined>(undefined);
  const take = (): void => {
    const value = numberIn(typed ?? "");
    if (value === undefined) return;
    setTyped(undefined);
    props.onChange(value);
    props.onSettled(value);
  };
  const isWrong = typed !== undefined && numberIn(typed) === undefined;
  return (
    <div class="hands-setpoint">
      <label class="field hands-slider">
        Speed setpoint
        <input
          type="range"
          min={-props.end}
          max={props.end}
          step={props.end / 300}
          value={props.value}
          onInput={(event) => props.onChange(Math.round(Number(event.currentTarget.value)))}
          onChange={(event) => props.onSettled(Math.round(Number(event.currentTarget.value)))}
        />
      </label>
      <label class="field">
        rpm
        <input
          class="hands-number"
          inputMode="decimal"
          value={typed ?? String(props.value)}
          aria-invalid={isWrong}
          onInput={(event) => setTyped(event.currentTarget.value)}
          onBlur={take}
          onKeyDown={(event) => {
            if (event.key === "Enter") take();
          }}
        />
      </label>
      <button
        type="button"
        onClick={() => {
          setTyped(undefined);
          props.onChange(0);
          props.onSettled(0);
        }}
      >
        Zero
      </button>
      {isWrong && <span role="alert">This is no number: it is not sent.</span>}
    </div>
  );
}
