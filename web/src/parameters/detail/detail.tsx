import { useEffect, useRef, useState } from "preact/hooks";

import { usePage } from "../../app/context";
import type { ParameterEntry } from "../../source/types";
import { Notice } from "../../ui/notice";
import { useResource } from "../../ui/resource";
import { BitTable } from "./bit_table";
import { IndexTable } from "./index_table";
import { parsedName, placeWords, withoutBit, type PlacedName } from "../text/names";
import { ParameterWrite } from "./parameter_write";
import type { ParameterSource } from "../data/parameter_source";
import { bitWidth, quantity, rangeText, valueText, whenWords } from "../text/value_text";
import { WiringDrawing } from "./wiring_drawing";

/** Time between two looks at the parameter (ms). */
const kPeriod = 1000;
const kSlowPeriod = 3000;

interface Props {
  unit: string;
  source: ParameterSource;
  shown: PlacedName;
  /** The address of another parameter. */
  link: (target: PlacedName) => string;
  close: string;
  /** Whether it takes the focus if nothing has it: the box that led here is gone. */
  takesFocus: boolean;
  /** A parameter has got another value. */
  onWritten: (name: string) => void;
}

/** All that is known of a parameter: what it does, its bits, indices and wires, and a field to write it. */
export function Detail(props: Props) {
  const { source, shown } = props;
  const { isLive } = usePage().source;
  const read = async (): Promise<ParameterEntry | null> => (await source.read(shown.place, [shown.name]))[0] ?? null;
  const answer = useResource(read, [source, shown.place, shown.name], isLive ? kPeriod : undefined);
  const entry = answer.value;
  const head = useRef<HTMLHeadingElement>(null);
  useEffect(() => {
    if (!props.takesFocus) return;
    if (document.activeElement === document.body) head.current?.focus({ preventScroll: true });
    head.current?.scrollIntoView({ block: "nearest" });
  }, []);
  return (
    <section class="card parameter-detail" aria-label={`Parameter ${shown.name}`}>
      <div class="parameter-detail-head">
        <h2 ref={head} tabIndex={-1}>
          <span class="mono">{shown.name}</span> {entry?.name}
          <span class="muted"> {placeWords(shown.place)}</span>
        </h2>
        <a class="button-link" href={props.close}>
          Close
        </a>
      </div>
      {answer.error !== "" && <Notice kind="warning">{answer.error}</Notice>}
      {entry === null && <Notice>{`${placeWords(shown.place)} has no ${shown.name}.`}</Notice>}
      {entry !== undefined && entry !== null && <Facts {...props} entry={entry} again={answer.again} />}
    </section>
  );
}

function Facts(props: Props & { entry: ParameterEntry; again: () => void }) {
  const { entry, source, shown } = props;
  const { isLive } = usePage().source;
  const width = entry.bit === undefined ? bitWidth(entry) : 0;
  const written = (): void => {
    props.again();
    props.onWritten(withoutBit(entry.parameter));
  };
  return (
    <>
      <div class="parameter-facts">
        <div>
          <p class="parameter-value" aria-live="off">
            {quantity(entry.value, entry.unit)}
          </p>
          <p>{entry.effect}</p>
          {entry.access === "read-write" && (
            <ParameterWrite unit={props.unit} source={source} place={shown.place} entry={entry} onWritten={written} />
          )}
        </div>
        <FactList entry={entry} link={props.link} />
      </div>
      <h3>Wiring</h3>
      <WiringDrawing source={source} entry={entry} period={isLive ? kSlowPeriod : undefined} link={props.link} />
      <div class="parameter-tables">
        {width > 0 && <BitTable entry={entry} width={width} link={props.link} />}
        {entry.indices > 1 && <Indices {...props} />}
      </div>
    </>
  );
}

function FactList(props: { entry: ParameterEntry; link: Props["link"] }) {
  const { entry } = props;
  const whole = parsedName(entry.parameter);
  const facts: [string, string][] = [
    ["Range", quantity(rangeText(entry.minimum, entry.maximum) || undefined, entry.unit)],
    ["Factory value", entry.factory === undefined ? "" : quantity(entry.factory, entry.unit)],
    ["Saved value", savedText(entry)],
    ["From the configuration", entry.preset === undefined ? "" : quantity(entry.preset, entry.unit)],
    ["Access", `${entry.access}, ${entry.type}`],
    ["Can be written", whenWords(entry.when)],
    ["Hexadecimal", entry.type.startsWith("U") && entry.bit === undefined ? `${Number(entry.value).toString(16).toUpperCase()}h` : ""],
    ["Index", entry.indices > 1 ? `${entry.index} of 0 to ${entry.indices - 1}` : ""],
    ["Drive object", String(entry.drive_object)],
  ];
  return (
    <dl class="facts">
      {facts
        .filter(([, value]) => value !== "" && value !== "–")
        .map(([title, value]) => (
          <div key={title}>
            <dt>{title}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      {whole?.bit !== undefined && (
        <div>
          <dt>Bit of</dt>
          <dd>
            <a href={props.link({ place: entry.axis === "infeed" ? "infeed" : Number(entry.axis), name: withoutBit(entry.parameter) })}>
              {withoutBit(entry.parameter)}
            </a>
          </dd>
        </div>
      )}
    </dl>
  );
}

function savedText(entry: ParameterEntry): string {
  if (entry.stored !== undefined) {
    return `${quantity(entry.stored, entry.unit)}${entry.differs_from_stored === true ? ", differs" : ""}`;
  }
  if (entry.access === "read-only") return "";
  if (entry.differs_from_stored === undefined) return "none: it is not among the saved parameters";
  return `nothing was saved yet, a new unit has ${valueText(entry.factory)}`;
}

function Indices(props: Props & { entry: ParameterEntry }) {
  const [isOpen, setIsOpen] = useState(false);
  const { entry } = props;
  return (
    <details onToggle={(event) => setIsOpen(event.currentTarget.open)}>
      <summary>{`${entry.indices} indices`}</summary>
      {isOpen && <IndexTable source={props.source} place={props.shown.place} entry={entry} link={props.link} />}
    </details>
  );
}
