import { usePage } from "../app/context";
import { linkTo } from "../app/route";
import { useProfile } from "../app/use_profile";
import { hasParameters } from "../model/profile";
import { quantity, rangeText, valueText } from "../parameters/text/value_text";
import { WriteField } from "../parameters/shared/write_field";
import { wordsOf } from "../source/refusal";
import type { ObjectEntry } from "../source/types";
import { Notice } from "../ui/notice";
import { useResource } from "../ui/resource";
import { edsEntry, parentName, type Eds } from "./eds";
import type { ObjectRow, Objects } from "./object_source";
import { hexText, objectText, type ObjectName } from "./object_text";

/** Time between two looks at the object (ms). */
const kPeriod = 1000;

interface Props {
  unit: string;
  objects: Objects;
  eds: Eds;
  name: ObjectName;
  /** The row of the table, for what cannot be read. */
  row: ObjectRow | undefined;
  close: string;
  onWritten: () => void;
}

/** All that is known of an object, and a field to write it. */
export function ObjectDetail(props: Props) {
  const { objects, name, eds, row } = props;
  const { isLive } = usePage().source;
  const key = objectText(name);
  const answer = useResource(() => objects.read(name), [objects, key], isLive ? kPeriod : undefined);
  const entry: ObjectEntry | undefined = answer.value ?? row;
  const written = (): void => {
    answer.again();
    props.onWritten();
  };
  return (
    <section class="card parameter-detail" aria-label={`Object ${key}`}>
      <div class="parameter-detail-head">
        <h2>
          <span class="mono">{`${key.slice(0, 4)}h:${key.slice(5)}`}</span> {entry?.name}
          <span class="muted"> {parentName(eds, name.index)}</span>
        </h2>
        <a class="button-link" href={props.close}>
          Close
        </a>
      </div>
      {answer.error !== "" && entry?.access !== "wo" && <Notice kind="warning">{`${answer.error}.`}</Notice>}
      {entry !== undefined && (
        <div class="parameter-facts">
          <div>
            {entry.value !== undefined && <p class="parameter-value">{valueText(entry.value)}</p>}
            {!["ro", "const"].includes(entry.access) && <Write {...props} entry={entry} onWritten={written} />}
          </div>
          <Facts unit={props.unit} eds={eds} entry={entry} />
        </div>
      )}
    </section>
  );
}

function Write(props: Props & { entry: ObjectEntry }) {
  const { entry, objects, name } = props;
  const range = rangeText(entry.minimum, entry.maximum);
  const write = async (text: string): Promise<void> => {
    await objects.write(name, text);
    props.onWritten();
  };
  return (
    <WriteField
      key={objectText(name)}
      label="Value"
      present={entry.value === undefined ? "" : valueText(entry.value)}
      hint={`${entry.type}${range === "" ? "" : `, ${range}`}. Decimal, 0x1F or 1Fh.`}
      write={write}
    />
  );
}

function Facts(props: { unit: string; eds: Eds; entry: ObjectEntry }) {
  const { entry, eds } = props;
  const profile = useProfile(props.unit) ?? "s120";
  const facts: [string, string][] = [
    ["Hexadecimal", hexText(entry.value, entry.type)],
    ["Type", entry.type],
    ["Access", entry.access],
    ["Can be mapped into PDOs", entry.mappable ? "yes" : "no"],
    ["Range", quantity(rangeText(entry.minimum, entry.maximum), "")],
    ["Default in the EDS", edsEntry(eds, entry.index, entry.sub_index)?.defaultValue ?? ""],
  ];
  return (
    <dl class="facts">
      {facts
        .filter(([, value]) => value !== "")
        .map(([title, value]) => (
          <div key={title}>
            <dt>{title}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      {entry.parameter !== undefined && hasParameters(profile) && (
        <div>
          <dt>Parameter</dt>
          <dd>
            <a href={linkTo("parameters", props.unit, { place: entry.axis ?? 0, text: entry.parameter })}>{entry.parameter}</a>
          </dd>
        </div>
      )}
    </dl>
  );
}

/** Why the names of the EDS are missing; empty: they are there. */
export function edsRemark(error: unknown): string {
  return `Names of records and defaults are missing: ${wordsOf(error)}.`;
}
