import type { Place } from "../source/types";
import { filterOf, kFilters, type Filter } from "./text/filters";
import { parsedPlace, placeWords } from "./text/names";

/** The choice of a drive object. */
export function PlaceField(props: { places: readonly Place[]; place: Place; onPlace: (place: Place) => void }) {
  const all = props.places.includes(props.place) ? props.places : [...props.places, props.place];
  return (
    <label class="field">
      Drive object
      <select value={String(props.place)} onChange={(event) => props.onPlace(parsedPlace(event.currentTarget.value) ?? 0)}>
        {all.map((place) => (
          <option key={place} value={String(place)}>
            {placeWords(place)}
          </option>
        ))}
      </select>
    </label>
  );
}

/** The choice of a filter. */
export function FilterField(props: { filter: Filter; onFilter: (filter: Filter) => void }) {
  return (
    <label class="field">
      Filter
      <select value={props.filter} onChange={(event) => props.onFilter(filterOf(event.currentTarget.value))}>
        {kFilters.map(({ filter, title }) => (
          <option key={filter} value={filter}>
            {title}
          </option>
        ))}
      </select>
    </label>
  );
}
