import type { DriveState, StateMachine } from "../source/types";
import { lookOf } from "../ui/state_words";
import { edgeWords, type Edge, type Visit } from "./edges";
import { curveOf, type Layout } from "./layout";

/** So many of the last changes are drawn. */
const kTrail = 4;

interface PictureProps {
  machine: StateMachine;
  edges: Edge[];
  layout: Layout;
  /** Key of the edge whose conditions are shown. */
  shown: string;
  visits: Visit[];
  onLook: (key: string) => void;
  onChoose: (key: string) => void;
}

/** The name in one line, or in two where the box is narrow. */
function linesOf(name: string, layout: Layout): string[] {
  const words = name.split(" ");
  if (name.length * 8.2 < layout.box.width || words.length === 1) return [name];
  const half = Math.ceil(words.length / 2);
  return [words.slice(0, half).join(" "), words.slice(half).join(" ")];
}

function StateBox(props: { state: DriveState; isHere: boolean; layout: Layout }) {
  const { layout, state } = props;
  const { x, y } = layout.places[state];
  const { width, height } = layout.box;
  const lines = linesOf(state, layout);
  const look = lookOf(state);
  return (
    <g class={`states-box states-${look.tone} ${props.isHere ? "states-here" : ""}`}>
      <rect x={x - width / 2} y={y - height / 2} width={width} height={height} rx={8} />
      <text x={x} y={y - (lines.length - 1) * 8} text-anchor="middle" dominant-baseline="central">
        {lines.map((line, index) => (
          <tspan key={line} x={x} dy={index === 0 ? 0 : 17}>
            {line}
          </tspan>
        ))}
      </text>
      {props.isHere && (
        <text class="states-here-mark" x={x - width / 2 + 2} y={y - height / 2 - 7}>
          ● here
        </text>
      )}
    </g>
  );
}

function EdgeLine(props: { edge: Edge; picture: PictureProps; trail: number }) {
  const { edge, picture } = props;
  const isFromHere = edge.from === picture.machine.state;
  const isShown = edge.key === picture.shown;
  const curve = curveOf(picture.layout, edge.from, edge.to);
  const look = edge.isOpen ? "open" : isFromHere ? "near" : "far";
  const isNumbered = edge.numbers !== "" && (isFromHere || isShown || !edge.numbers.includes("13"));
  const names = isFromHere
    ? { role: "button" as const, tabIndex: 0, "aria-label": `${edgeWords(edge)}, ${edge.isOpen ? "open" : "not open"}`, "aria-pressed": isShown }
    : { "aria-hidden": true };
  return (
    <g
      {...names}
      class={`states-edge states-edge-${look} ${isShown ? "states-shown" : ""} ${props.trail > 0 ? "states-trail" : ""}`}
      onMouseEnter={() => picture.onLook(edge.key)}
      onMouseLeave={() => picture.onLook("")}
      onClick={() => picture.onChoose(edge.key)}
      onFocus={() => picture.onLook(edge.key)}
      onBlur={() => picture.onLook("")}
      onKeyDown={(event) => {
        if (event.key !== "Enter" && event.key !== " ") return;
        event.preventDefault();
        picture.onChoose(edge.key);
      }}
    >
      <path class="states-reach" d={curve.path} />
      <path class="states-line" d={curve.path} marker-end={`url(#states-${isShown ? "shown" : look})`} />
      {isNumbered && (
        <g>
          <circle cx={curve.label.x} cy={curve.label.y} r={11} />
          <text class="states-number" x={curve.label.x} y={curve.label.y} text-anchor="middle" dominant-baseline="central">
            {edge.numbers}
          </text>
        </g>
      )}
    </g>
  );
}

/** The heads of the arrows. */
function Markers() {
  return (
    <defs>
      {["open", "near", "far", "shown"].map((look) => (
        <marker key={look} id={`states-${look}`} class={`states-head-${look}`} viewBox="0 0 8 8" refX={7} refY={4} markerWidth={9} markerHeight={9} markerUnits="userSpaceOnUse" orient="auto">
          <path d="M 0 0 L 8 4 L 0 8 z" />
        </marker>
      ))}
    </defs>
  );
}

/** What is in front: lines of elsewhere, of here, those that are open. What is shown keeps its place, as it has the focus. */
function rankOf(edge: Edge, state: string): number {
  if (edge.isOpen) return 2;
  return edge.from === state ? 1 : 0;
}

/** The state machine as a drawing: where the axis is, and which ways are open. */
export function Picture(props: PictureProps) {
  const { layout, machine, edges } = props;
  const known = edges.filter((edge) => edge.from in layout.places && edge.to in layout.places);
  const sorted = [...known].sort((a, b) => rankOf(a, machine.state) - rankOf(b, machine.state));
  const trail = props.visits.slice(0, kTrail).map((visit) => `${visit.before}>${visit.state}`);
  return (
    <svg class="states-picture" viewBox={`0 0 ${layout.width} ${layout.height}`} role="group" aria-label="State machine">
      <Markers />
      {sorted.map((edge) => (
        <EdgeLine key={edge.key} edge={edge} picture={props} trail={trail.indexOf(edge.key) + 1} />
      ))}
      {machine.states
        .filter((state) => state in layout.places)
        .map((state) => (
          <StateBox key={state} state={state} isHere={state === machine.state} layout={layout} />
        ))}
    </svg>
  );
}
