import { useRef, useState } from "preact/hooks";

import type { Place } from "../source/types";
import { filterOf, kFilters, type Filter } from "./filters";
import { parsedPlace, placeWords } from "./names";

/** Time after the last letter until is searched (ms). */
const kPause = 250;

/** A search field that tells its text when nothing more is typed; Enter at once. */
export function SearchField(props: { label: string; hint: string; text: string; onText: (text: string) => void }) {
  const [typed, setTyped] = useState<string | null>(null);
  const timer = useRef<ReturnType<typeof setTimeout> | undefined>(undefined);
  const tell = (text: string): void => {
    clearTimeout(timer.current);
    props.onText(text);
    setTyped(null);
  };
  const type = (text: string): void => {
    clearTimeout(timer.current);
    setTyped(text);
    timer.current = setTimeout(() => tell(text), kPause);
  };
  return (
    <label class="field search-field">
      {props.label}
      <input
        type="search"
        value={typed ?? props.text}
        placeholder={props.hint}
        autocomplete="off"
        spellcheck={false}
        onInput={(event) => type(event.currentTarget.value)}
        onKeyDown={(event) => event.key === "Enter" && tell(event.currentTarget.value)}
      />
    </label>
  );
}

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
