import type { BitRow } from "../../canopen/words";

/** Bits of a word that have a name; those that are set are told by a mark, too. */
export function BitTable(props: { bits: readonly BitRow[] }) {
  if (props.bits.length === 0) return null;
  return (
    <ul class="scope-bits">
      {props.bits.map((bit) => (
        <li key={bit.bit} class={bit.value !== 0 ? "scope-bit-set" : ""}>
          <span class="mono">{bit.bit}</span> {bit.name} <span class="mono">= {bit.value}</span>
        </li>
      ))}
    </ul>
  );
}
