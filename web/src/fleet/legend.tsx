import { kStateLooks } from "../ui/state_words";
import { fixed } from "../ui/number";
import { kLevels, type MeasureName } from "./cells";

interface Entry {
  look: string;
  text: string;
  words: string;
}

function levels(from: number, to: number, unit: string): Entry[] {
  return Array.from({ length: kLevels }, (_, level) => {
    const start = from + ((to - from) * level) / kLevels;
    return { look: `heat-${level}`, text: "", words: `from ${fixed(start, Math.abs(to - from) < 10 ? 1 : 0, unit)}` };
  });
}

const kEntries: Record<MeasureName, (scale: number) => Entry[]> = {
  state: () => Object.entries(kStateLooks).map(([words, { tone, letter }]) => ({ look: `tone-${tone}`, text: letter, words })),
  speed: (scale) => levels(0, scale, "rpm"),
  torque: (scale) => levels(0, scale, "N·m"),
  load: () => levels(0, 100, "%"),
  temperature: () => levels(20, 120, "°C"),
  faults: () => [
    { look: "tone-fault", text: "F1", words: "so many faults" },
    { look: "tone-brake", text: "A1", words: "so many alarms" },
    { look: "tone-off", text: "–", words: "none" },
  ],
};

/** What the colours and letters of the map mean. */
export function Legend(props: { measure: MeasureName; scale: number }) {
  return (
    <ul class="fleet-legend" aria-label="Legend">
      {kEntries[props.measure](props.scale).map((entry) => (
        <li key={entry.words}>
          <span class={`fleet-key ${entry.look}`} aria-hidden="true">
            {entry.text}
          </span>
          {entry.words}
        </li>
      ))}
    </ul>
  );
}
