import { linkTo } from "../app/route";
import type { Message } from "../source/types";

function nameOf(letter: string, number: number): string {
  return `${letter}${String(number).padStart(5, "0")}`;
}

/** Faults and alarms of a place of a unit; each leads to its cause in the scope. */
export function FaultChips(props: { unit: string; place: number; faults: Message[]; alarms: Message[] }) {
  const chip = (letter: "F" | "A") => (message: Message) => (
    <li key={`${letter}${message.number}`}>
      <a
        class={`chip tone-${letter === "F" ? "fault" : "brake"}`}
        href={linkTo("scope", props.unit, { fault: `${props.place}.${message.number}` })}
        title="Show its cause in the scope"
      >
        {nameOf(letter, message.number)} {message.text}
      </a>
    </li>
  );
  if (props.faults.length + props.alarms.length === 0) return null;
  return (
    <ul class="overview-chips">
      {props.faults.map(chip("F"))}
      {props.alarms.map(chip("A"))}
    </ul>
  );
}
