import { useState } from "preact/hooks";

import { usePage } from "../app/context";
import { refusalLines } from "../parameters/text/refusal_text";
import { duration } from "../ui/number";
import type { Pdos } from "./pdo_source";

/** Begins and ends the counting of frames; says what is missing without it. */
export function WatchBar(props: { unit: string; pdos: Pdos; onDone: () => void }) {
  const { source, permission } = usePage();
  const { isWatched, watchedSeconds } = props.pdos;
  const [said, setSaid] = useState("");
  const mayNot = permission.refusal.value;
  const change = async (): Promise<void> => {
    try {
      await source.act("POST", props.unit, "pdos/watch", { watch: !isWatched });
      setSaid("");
      props.onDone();
    } catch (error) {
      permission.note(error);
      setSaid(`Refused: ${refusalLines(error).join(" ")}`);
    }
  };
  const state = isWatched
    ? `Frames are counted for ${duration(Math.round(watchedSeconds))}.`
    : "Frames are not counted: mapping and values are shown, no data, age or rate.";
  return (
    <div class="row">
      <button type="button" disabled={mayNot !== ""} onClick={() => void change()}>
        {isWatched ? "Stop counting" : "Count frames"}
      </button>
      <span class="muted">{state}</span>
      {!isWatched && mayNot !== "" && <span class="muted">{mayNot}</span>}
      <span role="status">{said}</span>
    </div>
  );
}
