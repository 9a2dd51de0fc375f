import { useEffect, useMemo } from "preact/hooks";

import { usePage } from "../app/context";
import { useProfile } from "../app/use_profile";
import { parsedEds, parentName, type Eds } from "../objects/eds";
import { ObjectDetail, edsRemark } from "../objects/object_detail";
import { objectList, Objects as ObjectsOf, type ObjectList, type WantedObjects } from "../objects/object_source";
import { ObjectTable } from "../objects/object_table";
import {
  kObjectFilters,
  nameOf,
  objectFilterOf,
  objectsCsv,
  objectText,
  parsedObject,
  type ObjectName,
} from "../objects/object_text";
import { useAddress, type Address } from "../parameters/shared/address";
import { CsvButton } from "../parameters/shared/csv_button";
import { FoundLine } from "../parameters/shared/found_line";
import { everything } from "../parameters/shared/paged_list";
import { SearchField } from "../parameters/shared/search_field";
import { useResource } from "../ui/resource";

const kNoEds: Eds = new Map();

function shownOf(query: URLSearchParams): ObjectName | undefined {
  const named = query.get("show");
  return named === "none" ? undefined : parsedObject(named ?? query.get("text") ?? "");
}

async function csvOf(objects: ObjectsOf, wanted: WantedObjects, eds: Eds, told: (share: number) => void): Promise<string> {
  const rows = await everything((from) => objects.part(wanted, from), () => undefined);
  return objectsCsv(await objects.readAll(rows, told), (index) => parentName(eds, index));
}

function Tools(props: { unit: string; objects: ObjectsOf; wanted: WantedObjects; eds: Eds; address: Address }) {
  const { wanted, address, objects, eds } = props;
  return (
    <div class="row parameter-tools">
      <SearchField
        label="Search"
        hint="6040, 1018:01, velocity"
        text={wanted.text}
        onText={(text) => address.replace({ text, show: undefined })}
      />
      <label class="field">
        Filter
        <select value={wanted.filter} onChange={(event) => address.replace({ filter: event.currentTarget.value })}>
          {kObjectFilters.map(({ filter, title }) => (
            <option key={filter} value={filter}>
              {title}
            </option>
          ))}
        </select>
      </label>
      <CsvButton
        name={`objects-${props.unit.replace("/", "-")}-${wanted.filter}.csv`}
        text={(told) => csvOf(objects, wanted, eds, told)}
      />
    </div>
  );
}

function Shown(props: { unit: string; objects: ObjectsOf; list: ObjectList; eds: Eds; name: ObjectName; address: Address }) {
  const { list, name } = props;
  const row = list.rows.value.find((each) => each.index === name.index && each.sub_index === name.sub);
  return (
    <ObjectDetail
      key={objectText(name)}
      unit={props.unit}
      objects={props.objects}
      eds={props.eds}
      name={name}
      row={row}
      close={props.address.link({ show: "none" })}
      onWritten={() => void list.refresh(row === undefined ? [] : [row.object])}
    />
  );
}

/** The object dictionary of a unit: search, values, writing with the abort code of a refusal. */
export function Objects(props: { unit: string }) {
  const { source } = usePage();
  const { unit } = props;
  const address = useAddress("objects", unit);
  const profile = useProfile(unit) ?? "s120";
  const objects = useMemo(() => new ObjectsOf(source, unit, profile), [source, unit, profile]);
  const list = useMemo(() => objectList(objects), [objects]);
  const eds = useResource(async () => parsedEds(await source.eds(unit)), [source, unit]);
  const wanted: WantedObjects = { text: address.query.get("text") ?? "", filter: objectFilterOf(address.query.get("filter")) };
  useEffect(() => void list.ask(wanted), [list, wanted.text, wanted.filter]);
  const shown = shownOf(address.query);
  const names = eds.value ?? kNoEds;
  const rows = list.rows.value;
  const hasValues = source.isLive || rows.length === 0 || rows.some((row) => row.value !== undefined);
  return (
    <div class="parameters">
      <div class="parameters-head">
        <h1>Objects</h1>
      </div>
      <Tools unit={unit} objects={objects} wanted={wanted} eds={names} address={address} />
      <FoundLine list={list} />
      {!hasValues && <p class="muted">The values of the objects were not recorded.</p>}
      {eds.error !== "" && <p class="muted">{edsRemark(eds.error)}</p>}
      <div class={shown === undefined ? "parameter-split" : "parameter-split parameter-split-shown"}>
        <ObjectTable
          list={list}
          eds={names}
          shown={shown === undefined ? "" : objectText(shown).replace(":", "h:")}
          link={(row) => address.link({ show: objectText(nameOf(row)) })}
        />
        {shown !== undefined && <Shown unit={unit} objects={objects} list={list} eds={names} name={shown} address={address} />}
      </div>
    </div>
  );
}
