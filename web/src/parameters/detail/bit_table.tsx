import type { ParameterEntry } from "../../source/types";
import { placeOf, placeWords, type PlacedName } from "../text/names";
import { bitRows, type Bit } from "./wiring";

/** The bits of a word, with the inputs that take them. */
export function BitTable(props: { entry: ParameterEntry; width: number; link: (target: PlacedName) => string }) {
  const { entry, width, link } = props;
  const bits = bitRows(entry, width);
  return (
    <details open={width <= 16}>
      <summary>{`${width} bits`}</summary>
      <ol class="bits" start={0} aria-label={`Bits of ${entry.parameter}`}>
        {bits.map((bit) => (
          <li key={bit.bit} class={bit.isSet ? "bit bit-set" : "bit"}>
            <a href={link({ place: placeOf(entry.axis), name: `${entry.parameter}.${bit.bit}` })}>
              <span class="bit-number">{bit.bit}</span> <span class="bit-value">{bit.isSet ? 1 : 0}</span>
            </a>
            <Users bit={bit} entry={entry} link={link} />
          </li>
        ))}
      </ol>
    </details>
  );
}

function Users(props: { bit: Bit; entry: ParameterEntry; link: (target: PlacedName) => string }) {
  return (
    <>
      {props.bit.users.map((use) => (
        <a key={`${use.axis} ${use.parameter}`} class="bit-user" href={props.link({ place: placeOf(use.axis), name: use.parameter })}>
          {use.axis === props.entry.axis ? use.parameter : `${use.parameter}, ${placeWords(use.axis)}`}
        </a>
      ))}
    </>
  );
}
