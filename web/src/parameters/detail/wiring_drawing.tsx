import { useResource } from "../../ui/resource";
import type { ParameterEntry } from "../../source/types";
import { placeOf, placedText, type PlacedName } from "../text/names";
import type { ParameterSource } from "../data/parameter_source";
import { keyOf, neighboursOf, usersOf, wiringOf, type Edge, type Neighbours, type Node, type Wiring } from "./wiring";

const kWidth = 232;
const kHeight = 58;
const kGapX = 84;
const kGapY = 12;
/** Letters that a line of a box has room for. */
const kLetters = 32;

function left(node: Node): number {
  return 4 + node.column * (kWidth + kGapX);
}
function top(node: Node): number {
  return 4 + node.row * (kHeight + kGapY);
}

function cut(text: string): string {
  return text.length <= kLetters ? text : `${text.slice(0, kLetters - 1)}…`;
}

function Box(props: { node: Node; link: (target: PlacedName) => string }) {
  const { node } = props;
  const x = left(node);
  const y = top(node);
  const box = (
    <>
      <rect x={x} y={y} width={kWidth} height={kHeight} rx={5} />
      <text x={x + 10} y={y + 20} class="wiring-title">
        {cut(node.title)}
      </text>
      <text x={x + 10} y={y + 36} class="wiring-name">
        {cut(node.name)}
      </text>
      <text x={x + 10} y={y + 51} class="wiring-value">
        {cut(node.value)}
      </text>
    </>
  );
  if (node.target === undefined) return <g class={`wiring-box${node.isCentre ? " wiring-centre" : ""}`}>{box}</g>;
  return (
    <a class="wiring-box" href={props.link(node.target)}>
      {box}
    </a>
  );
}

function Line(props: { edge: Edge; wiring: Wiring }) {
  const from = props.wiring.nodes[props.edge.from];
  const to = props.wiring.nodes[props.edge.to];
  if (from === undefined || to === undefined) return null;
  const x0 = left(from) + kWidth;
  const y0 = top(from) + kHeight / 2;
  const x1 = left(to);
  const y1 = top(to) + kHeight / 2;
  const middle = x0 + kGapX / 2 - 12;
  return (
    <g class="wiring-line">
      <path d={`M${x0} ${y0}H${middle}V${y1}H${x1 - 7}`} />
      <path class="wiring-head" d={`M${x1 - 8} ${y1 - 5}L${x1} ${y1}L${x1 - 8} ${y1 + 5}Z`} />
      <text x={x1 - 10} y={y1 - 6} text-anchor="end">
        {props.edge.label}
      </text>
    </g>
  );
}

async function readAll(source: ParameterSource, names: readonly PlacedName[]): Promise<Map<string, ParameterEntry>> {
  const known = new Map<string, ParameterEntry>();
  for (const place of new Set(names.map((each) => each.place))) {
    const wanted = names.filter((each) => each.place === place).map((each) => each.name);
    const entries = await source.read(place, wanted);
    for (const entry of entries) known.set(keyOf(place, entry.parameter), entry);
  }
  return known;
}

/** What the drawing of @param entry has to know: its neighbours, and of an input those beside it at the same source. */
async function neighbourhood(source: ParameterSource, entry: ParameterEntry): Promise<Neighbours> {
  const known = await readAll(source, neighboursOf(entry));
  if (entry.source === undefined) return known;
  const beside = [...known.values()].flatMap((owner) => usersOf(owner));
  const names = beside.map((use): PlacedName => ({ place: placeOf(use.axis), name: use.parameter }));
  return new Map([...known, ...(await readAll(source, names))]);
}

/** The wires of a parameter: its source on the left, who uses it on the right; each box leads to its parameter. */
export function WiringDrawing(props: {
  source: ParameterSource;
  entry: ParameterEntry;
  period: number | undefined;
  link: (target: PlacedName) => string;
}) {
  const { entry, source } = props;
  const key = neighboursOf(entry).map(placedText).join(" ");
  const known = useResource(() => neighbourhood(source, entry), [source, entry.axis, entry.parameter, key], props.period);
  const wiring = wiringOf(entry, known.value ?? new Map<string, ParameterEntry>());
  if (wiring === undefined) return <p class="muted">It is neither an input nor an output of BICO: nothing is wired to it.</p>;
  const width = 8 + (1 + Math.max(...wiring.nodes.map((node) => node.column))) * (kWidth + kGapX) - kGapX;
  const height = 8 + wiring.rows * (kHeight + kGapY) - kGapY;
  const first = Math.min(...wiring.nodes.map((node) => node.column)) * (kWidth + kGapX);
  return (
    <>
      <div class="scroll wiring-scroll" tabIndex={0} role="group" aria-label={`Wiring of ${entry.parameter}`}>
        <svg class="wiring" width={width - first} height={height} viewBox={`${first} 0 ${width - first} ${height}`}>
          {wiring.edges.map((edge) => (
            <Line key={`${edge.from} ${edge.to}`} edge={edge} wiring={wiring} />
          ))}
          {wiring.nodes.map((node) => (
            <Box key={`${node.column} ${node.row}`} node={node} link={props.link} />
          ))}
        </svg>
      </div>
      {wiring.remark !== "" && <p class="muted">{wiring.remark}</p>}
      {known.error !== "" && <p class="muted">{`Names and values of the neighbours: ${known.error}.`}</p>}
    </>
  );
}
