import { usePage } from "../../app/context";
import type { ParameterEntry, Place } from "../../source/types";
import { useResource } from "../../ui/resource";
import { parsedName, type PlacedName } from "../text/names";
import type { ParameterSource } from "../data/parameter_source";
import { quantity } from "../text/value_text";

/** Time between two looks at all indices (ms). */
const kPeriod = 2000;
/** Most indices that are shown. */
const kMost = 128;

/** The values of all indices of a parameter. */
export function IndexTable(props: {
  source: ParameterSource;
  place: Place;
  entry: ParameterEntry;
  link: (target: PlacedName) => string;
}) {
  const { source, place, entry } = props;
  const { isLive } = usePage().source;
  const base = parsedName(entry.parameter)?.base ?? entry.parameter;
  const names = Array.from({ length: Math.min(entry.indices, kMost) }, (_, index) => `${base}[${index}]`);
  const values = useResource(() => source.read(place, names), [source, place, base], isLive ? kPeriod : undefined);
  return (
    <>
      {values.error !== "" && <p class="muted">{values.error}</p>}
      <ul class="indices" aria-label={`Indices of ${base}`}>
        {(values.value ?? []).map((each) => (
          <li key={each.parameter}>
            <a href={props.link({ place, name: each.parameter })} aria-current={each.index === entry.index ? "true" : undefined}>
              {`[${each.index}]`}
            </a>{" "}
            <span class="mono">{quantity(each.value, each.unit)}</span>
          </li>
        ))}
      </ul>
    </>
  );
}
