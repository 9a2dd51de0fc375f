import { useRef } from "preact/hooks";

import type { ParameterEntry } from "../source/types";
import type { ParameterList } from "./data/parameter_list";
import { moveInRows } from "./shared/row_keys";
import { useRefresh } from "./shared/use_refresh";
import { rangeText, valueText } from "./text/value_text";

/** Rows that are read at each look. */
const kMostRefreshed = 64;

function Row(props: { entry: ParameterEntry; href: string; isShown: boolean }) {
  const { entry } = props;
  const isChanged = entry.differs_from_factory === true;
  return (
    <tr data-name={entry.parameter} class={props.isShown ? "row-shown" : undefined}>
      <th scope="row" class="parameter-number">
        <a class="row-link" href={props.href} aria-current={props.isShown ? "true" : undefined}>
          {entry.parameter}
        </a>
      </th>
      <td>{entry.name}</td>
      <td class={typeof entry.value === "number" ? "number" : "number source"}>
        {isChanged && <span class="changed-mark">changed </span>}
        {valueText(entry.value)}
      </td>
      <td>{entry.unit}</td>
      <td class="number">{rangeText(entry.minimum, entry.maximum)}</td>
      <td class="number">{entry.factory === undefined ? "" : valueText(entry.factory)}</td>
      <td>{entry.access}</td>
      <td>{entry.when ?? ""}</td>
    </tr>
  );
}

/** The rows of a list in a box of their own; those that can be seen are read again every second. */
export function ParameterTable(props: { list: ParameterList; shown: string; link: (entry: ParameterEntry) => string; label: string }) {
  const { list } = props;
  const box = useRef<HTMLDivElement>(null);
  useRefresh(list, box, kMostRefreshed);
  const isPartial = list.progress.value === "partial";
  return (
    <div class="scroll parameter-box" ref={box} tabIndex={0} role="region" aria-label={props.label}>
      <table class="parameter-table">
        <thead>
          <tr>
            <th scope="col">Number</th>
            <th scope="col">Name</th>
            <th scope="col" class="number">
              Value
            </th>
            <th scope="col">Unit</th>
            <th scope="col" class="number">
              Range
            </th>
            <th scope="col" class="number">
              Factory
            </th>
            <th scope="col">Access</th>
            <th scope="col">Change</th>
          </tr>
        </thead>
        <tbody onKeyDown={moveInRows}>
          {list.rows.value.map((entry) => (
            <Row key={entry.parameter} entry={entry} href={props.link(entry)} isShown={entry.parameter === props.shown} />
          ))}
        </tbody>
      </table>
      {isPartial && list.error.value === "" && (
        <div class="buttons">
          <button type="button" onClick={() => void list.more()}>
            Show more
          </button>
        </div>
      )}
    </div>
  );
}
