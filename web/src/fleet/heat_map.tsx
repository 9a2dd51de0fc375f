import { Component } from "preact";
import { useRef, useState } from "preact/hooks";

import { linkTo } from "../app/route";
import type { Cell } from "./cells";
import { nextCell } from "./order";

interface CellProps {
  cell: Cell;
  /** It is the one that the Tab key comes to. */
  isEntry: boolean;
  /** The measure is faults: a click shows the cause. */
  toCause: boolean;
}

const kParts = ["unit", "axis", "text", "look", "words", "fault"] as const;

/** A cell that is drawn anew only if what it shows has changed. */
class CellLink extends Component<CellProps> {
  override shouldComponentUpdate(next: CellProps): boolean {
    const { cell, isEntry, toCause } = this.props;
    return isEntry !== next.isEntry || toCause !== next.toCause || kParts.some((part) => cell[part] !== next.cell[part]);
  }

  override render({ cell, isEntry, toCause }: CellProps) {
    const name = cell.axis === 0 ? cell.unit : `${cell.unit} axis ${cell.axis}`;
    const toFault = toCause && cell.fault !== undefined ? linkTo("scope", cell.unit, { fault: `${cell.axis}.${cell.fault}` }) : undefined;
    const query = cell.axis === 0 ? {} : { axis: cell.axis };
    const label = `${name}: ${cell.words}`;
    return (
      <li>
        <a class={`fleet-cell ${cell.look}`} href={toFault ?? linkTo("states", cell.unit, query)} aria-label={label} title={label} tabIndex={isEntry ? 0 : -1}>
          {cell.text}
        </a>
      </li>
    );
  }
}

/** Cells as a map; arrow keys go from one to the next. */
export function HeatMap(props: { cells: Cell[]; toCause: boolean }) {
  const { cells } = props;
  const list = useRef<HTMLUListElement>(null);
  const [entry, setEntry] = useState("");
  const present = cells.some((cell) => cell.key === entry) ? entry : (cells[0]?.key ?? "");
  const go = (event: KeyboardEvent): void => {
    const links = [...(list.current?.querySelectorAll("a") ?? [])];
    const index = links.indexOf(document.activeElement as HTMLAnchorElement);
    if (index < 0) return;
    const spots = links.map((link) => ({ left: link.offsetLeft, top: link.offsetTop }));
    const next = nextCell(spots, index, event.key);
    if (next === undefined) return;
    event.preventDefault();
    links[next]?.focus();
    setEntry(cells[next]?.key ?? "");
  };
  return (
    <ul ref={list} class="fleet-map" aria-label="Map of the fleet; arrow keys go from cell to cell" onKeyDown={go}>
      {cells.map((cell) => (
        <CellLink key={cell.key} cell={cell} isEntry={cell.key === present} toCause={props.toCause} />
      ))}
    </ul>
  );
}
