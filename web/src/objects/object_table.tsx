import { useRef } from "preact/hooks";

import { moveInRows } from "../parameters/shared/row_keys";
import { useRefresh } from "../parameters/shared/use_refresh";
import { rangeText, valueText } from "../parameters/text/value_text";
import { parentName, type Eds } from "./eds";
import type { ObjectList, ObjectRow } from "./object_source";
import { hexText } from "./object_text";

/** Objects are read one by one: so many at each look. */
const kMostRefreshed = 40;

function valueOf(row: ObjectRow): string {
  if (row.said !== undefined) return row.said;
  if (row.access === "wo") return "write-only";
  return row.value === undefined ? "" : valueText(row.value);
}

function Row(props: { row: ObjectRow; eds: Eds; href: string; isShown: boolean }) {
  const { row } = props;
  const parent = parentName(props.eds, row.index);
  return (
    <tr data-name={row.object} class={props.isShown ? "row-shown" : undefined}>
      <th scope="row" class="object-number">
        <a class="row-link" href={props.href} aria-current={props.isShown ? "true" : undefined}>
          {row.object}
        </a>
      </th>
      <td>
        {parent !== "" && parent !== row.name && <span class="muted">{`${parent}: `}</span>}
        {row.name}
      </td>
      <td class="number">{valueOf(row)}</td>
      <td class="number">{hexText(row.value, row.type)}</td>
      <td>{row.type}</td>
      <td>{row.access}</td>
      <td>{row.mappable ? "yes" : ""}</td>
      <td class="number">{rangeText(row.minimum, row.maximum)}</td>
    </tr>
  );
}

const kTitles: [string, string?][] = [
  ["Object"],
  ["Name"],
  ["Value", "number"],
  ["Hex", "number"],
  ["Type"],
  ["Access"],
  ["PDO"],
  ["Range", "number"],
];

/** The rows of a list of objects in a box of their own; those that can be seen are read again and again. */
export function ObjectTable(props: { list: ObjectList; eds: Eds; shown: string; link: (row: ObjectRow) => string }) {
  const { list } = props;
  const box = useRef<HTMLDivElement>(null);
  useRefresh(list, box, kMostRefreshed);
  return (
    <div class="scroll parameter-box" ref={box} tabIndex={0} role="region" aria-label="Objects">
      <table class="object-table">
        <thead>
          <tr>
            {kTitles.map(([title, look]) => (
              <th key={title} scope="col" class={look}>
                {title}
              </th>
            ))}
          </tr>
        </thead>
        <tbody onKeyDown={moveInRows}>
          {list.rows.value.map((row) => (
            <Row key={row.object} row={row} eds={props.eds} href={props.link(row)} isShown={row.object === props.shown} />
          ))}
        </tbody>
      </table>
      {list.progress.value === "partial" && list.error.value === "" && (
        <div class="buttons">
          <button type="button" onClick={() => void list.more()}>
            Show more
          </button>
        </div>
      )}
    </div>
  );
}
