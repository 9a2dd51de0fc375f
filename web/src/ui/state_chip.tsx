import { lookOf } from "./state_words";

/** A drive state as a coloured word. */
export function StateChip(props: { state: string }) {
  return <span class={`chip tone-${lookOf(props.state).tone}`}>{props.state}</span>;
}
