import { useMemo } from "preact/hooks";

import { usePage } from "../app/context";
import type { ParameterDifference } from "../source/types";
import { csvField } from "../ui/download";
import { Notice } from "../ui/notice";
import { useResource } from "../ui/resource";
import type { Address } from "./shared/address";
import { CsvButton } from "./shared/csv_button";
import { placeOf, placeWords, placedText } from "./text/names";
import { parts } from "./shared/paged_list";
import type { ParameterSource, Reference } from "./data/parameter_source";
import { valueText } from "./text/value_text";

interface All {
  entries: ParameterDifference[];
  isStored: boolean;
}

const kReferences: { against: Reference; title: string; column: string }[] = [
  { against: "factory", title: "A new unit", column: "Factory value" },
  { against: "stored", title: "What is saved", column: "Saved value" },
];

async function allOf(source: ParameterSource, against: Reference): Promise<All> {
  const all: All = { entries: [], isStored: false };
  for await (const part of parts((from) => source.differences(against, from))) {
    all.entries.push(...part.entries);
    all.isStored = part.isStored;
  }
  return all;
}

/** Differences as CSV with a head. */
export function differencesCsv(entries: readonly ParameterDifference[], against: Reference): string {
  const lines = entries.map((entry) =>
    [entry.axis, entry.parameter, entry.name, entry.value, entry.reference, entry.unit].map(csvField).join(","),
  );
  return [`place,parameter,name,value,${against},unit`, ...lines, ""].join("\n");
}

function Table(props: { entries: readonly ParameterDifference[]; column: string; address: Address }) {
  return (
    <div class="scroll parameter-box" tabIndex={0} role="region" aria-label="Differences">
      <table>
        <thead>
          <tr>
            <th scope="col">Drive object</th>
            <th scope="col">Number</th>
            <th scope="col">Name</th>
            <th scope="col" class="number">
              Value
            </th>
            <th scope="col" class="number">
              {props.column}
            </th>
            <th scope="col">Unit</th>
          </tr>
        </thead>
        <tbody>
          {props.entries.map((entry) => (
            <tr key={`${entry.axis}/${entry.parameter}`}>
              <td>{placeWords(entry.axis)}</td>
              <td class="mono">
                <a href={linkOf(props.address, entry)}>{entry.parameter}</a>
              </td>
              <td>{entry.name}</td>
              <td class="number">{valueText(entry.value)}</td>
              <td class="number">{valueText(entry.reference)}</td>
              <td>{entry.unit}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function linkOf(address: Address, entry: ParameterDifference): string {
  const place = placeOf(entry.axis);
  const show = placedText({ place, name: entry.parameter });
  return address.link({ view: undefined, against: undefined, text: undefined, filter: "changed", place: String(place), show });
}

/** What differs in all drive objects, from a new unit or from what is saved. */
export function DifferencesView(props: { unit: string; source: ParameterSource; address: Address; turn: number }) {
  const { source, address } = props;
  const { isLive } = usePage().source;
  const chosen = kReferences.find(({ against }) => against === address.query.get("against")) ?? kReferences[0];
  const against = chosen?.against ?? "factory";
  const key = useMemo(() => `${against} ${props.turn}`, [against, props.turn]);
  const all = useResource(async () => ({ key, ...(await allOf(source, against)) }), [source, key]);
  const present = all.value?.key === key ? all.value : undefined;
  return (
    <>
      <div class="row parameter-tools">
        <label class="field">
          Compared with
          <select value={against} onChange={(event) => address.replace({ against: event.currentTarget.value })}>
            {kReferences.map((each) => (
              <option key={each.against} value={each.against}>
                {each.title}
              </option>
            ))}
          </select>
        </label>
        {isLive && (
          <button type="button" onClick={all.again}>
            Compare again
          </button>
        )}
        <CsvButton
          name={`differences-${props.unit.replace("/", "-")}-${against}.csv`}
          text={async () => differencesCsv((await allOf(source, against)).entries, against)}
        />
      </div>
      <p role="status" class="muted">
        {present === undefined ? (all.error === "" ? "Comparing …" : "") : wordsFor(present, against)}
      </p>
      {all.error !== "" && <Notice kind="warning">{`${all.error}.`}</Notice>}
      {present !== undefined && present.entries.length > 0 && (
        <Table entries={present.entries} column={chosen?.column ?? ""} address={address} />
      )}
    </>
  );
}

function wordsFor(all: All, against: Reference): string {
  const count = all.entries.length === 1 ? "1 parameter differs" : `${all.entries.length || "No"} parameters differ`;
  if (against === "stored" && !all.isStored) return `Nothing was saved yet: compared with a new unit. ${count}.`;
  return `${count} from ${against === "stored" ? "what is saved" : "a new unit"}.`;
}
