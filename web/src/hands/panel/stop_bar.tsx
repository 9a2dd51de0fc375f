import { useEffect } from "preact/hooks";

import { StateChip } from "../../ui/state_chip";
import { fixed } from "../../ui/number";
import type { Values } from "./meters";
import type { PanelLink } from "./panel_link";

/** The stop button, always in reach, with what the axis does; Escape does the same. */
export function StopBar(props: { link: PanelLink; axis: number; state: string; values: Values; stop: () => void }) {
  const { isHeld } = props.link;
  useEffect(() => {
    const stopByKey = (event: KeyboardEvent): void => {
      if (event.key === "Escape") props.stop();
    };
    addEventListener("keydown", stopByKey);
    return () => removeEventListener("keydown", stopByKey);
  }, [props.stop]);
  return (
    <div class="hands-bar" role="region" aria-label="Stop">
      <button type="button" class="hands-stop" disabled={!isHeld.value} onClick={props.stop} aria-keyshortcuts="Escape">
        ■ Stop
      </button>
      <span class="hands-bar-words">
        Axis {props.axis} <StateChip state={props.state} />{" "}
        <span class="mono">{fixed(props.values.speed, 1, "rpm")}</span>
      </span>
      <span class="muted hands-bar-words">
        {isHeld.value ? "Escape stops, too (OFF1)." : "This page has not taken the master control: there is nothing to stop from here."}
      </span>
    </div>
  );
}
