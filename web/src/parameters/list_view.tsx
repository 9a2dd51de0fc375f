import { useEffect, useMemo, useRef } from "preact/hooks";

import type { ParameterEntry, Place } from "../source/types";
import { useResource } from "../ui/resource";
import type { Address } from "./shared/address";
import { CsvButton } from "./shared/csv_button";
import { Detail } from "./detail/detail";
import { filterOf } from "./text/filters";
import { FoundLine } from "./shared/found_line";
import { parsedName, parsedPlace, parsedPlaced, placeWords, placedText, type PlacedName } from "./text/names";
import { everything } from "./shared/paged_list";
import { parameterList, type ParameterList } from "./data/parameter_list";
import type { ParameterSource, Wanted } from "./data/parameter_source";
import { ParameterTable } from "./parameter_table";
import { SearchField } from "./shared/search_field";
import { FilterField, PlaceField } from "./toolbar";
import { parametersCsv } from "./text/value_text";

interface Props {
  unit: string;
  source: ParameterSource;
  places: readonly Place[];
  address: Address;
}

function wantedOf(query: URLSearchParams, places: readonly Place[]): Wanted {
  const usual = places.find((place) => place !== 0 && place !== "infeed") ?? places[0] ?? 0;
  return {
    place: parsedPlace(query.get("place")) ?? usual,
    text: query.get("text") ?? "",
    filter: filterOf(query.get("filter")),
  };
}

/** What is shown in detail: what the address says, or what was searched for by its whole name and found. */
function shownOf(query: URLSearchParams, wanted: Wanted, list: ParameterList): PlacedName | undefined {
  if (query.has("show")) return parsedPlaced(query.get("show"));
  const name = wanted.text.trim().toLowerCase();
  const base = /\d{4}/.test(name) ? parsedName(name)?.base : undefined;
  const isFound = base !== undefined && list.rows.value.some((row) => parsedName(row.parameter)?.base === base);
  return isFound ? { place: wanted.place, name } : undefined;
}

/** Where it is that was not found here. */
function Elsewhere(props: Props & { wanted: Wanted }) {
  const { wanted, source, address } = props;
  const found = useResource(() => source.elsewhere(wanted.text), [source, wanted.text]);
  const others = (found.value ?? [])
    .map((each) => ({ ...each, places: each.places.filter((place) => place !== wanted.place) }))
    .filter((each) => each.places.length > 0);
  if (others.length === 0) return null;
  return (
    <div>
      <p>Elsewhere in the unit:</p>
      <ul>
        {others.slice(0, 12).map((each) => (
          <li key={each.parameter + each.name}>
            <span class="mono">{each.parameter}</span> {each.name}:{" "}
            {each.places.map((place) => (
              <span key={place}>
                <a href={address.link({ place: String(place), show: undefined })}>{placeWords(place)}</a>{" "}
              </span>
            ))}
          </li>
        ))}
      </ul>
    </div>
  );
}

function Found(props: Props & { list: ParameterList; wanted: Wanted }) {
  const { list, wanted } = props;
  const isNowhere = list.progress.value === "whole" && list.rows.value.length === 0;
  return (
    <>
      <FoundLine list={list} />
      {isNowhere && wanted.text !== "" && <Elsewhere {...props} />}
    </>
  );
}

/** Search, table and detail of the parameters. */
export function ListView(props: Props) {
  const { address, source } = props;
  const wanted = wantedOf(address.query, props.places);
  const list = useMemo(() => parameterList(source), [source]);
  useEffect(() => void list.ask(wanted), [list, wanted.place, wanted.text, wanted.filter]);
  const shown = shownOf(address.query, wanted, list);
  const isLater = useRef(false);
  useEffect(() => {
    isLater.current = true;
  }, []);
  const link = (target: PlacedName): string => address.link({ show: placedText(target) });
  const linkOf = (entry: ParameterEntry): string => link({ place: wanted.place, name: entry.parameter });
  const isListed = shown?.place === wanted.place;
  return (
    <>
      <div class="row parameter-tools">
        <PlaceField places={props.places} place={wanted.place} onPlace={(place) => address.replace({ place: String(place) })} />
        <SearchField
          label="Search"
          hint="p1120, 1120, ramp time"
          text={wanted.text}
          onText={(text) => address.replace({ text, show: undefined })}
        />
        <FilterField filter={wanted.filter} onFilter={(filter) => address.replace({ filter })} />
        <CsvButton
          name={`parameters-${props.unit.replace("/", "-")}-${wanted.place}-${wanted.filter}.csv`}
          text={async (told) => parametersCsv(await everything((from) => source.part(wanted, from), told))}
        />
      </div>
      <Found {...props} list={list} wanted={wanted} />
      <div class={shown === undefined ? "parameter-split" : "parameter-split parameter-split-shown"}>
        <ParameterTable
          list={list}
          shown={isListed ? shown.name : ""}
          link={linkOf}
          label={`Parameters of ${placeWords(wanted.place)}`}
        />
        {shown !== undefined && (
          <Detail
            key={placedText(shown)}
            unit={props.unit}
            source={source}
            shown={shown}
            link={link}
            takesFocus={isLater.current && address.query.has("show")}
            close={address.link({ show: "none" })}
            onWritten={(name) => void list.refresh([name])}
          />
        )}
      </div>
    </>
  );
}
