import type { UnitEvent } from "../../source/types";
import { clustersOf, type Cluster, type MarkLook } from "../view/event_marks";
import type { Row } from "../view/layout";
import type { Palette } from "./palette";
import { xOf, type TimeField } from "./time_field";

/** Marks closer than this are one (CSS pixels). */
export const kMarkDistance = 13;
const kRadius = 8;

type Shape = (context: CanvasRenderingContext2D, x: number, y: number, r: number) => void;

function polygon(points: readonly (readonly [number, number])[]): Shape {
  return (context, x, y, r) => {
    points.forEach(([dx, dy], i) => (i === 0 ? context.moveTo(x + dx * r, y + dy * r) : context.lineTo(x + dx * r, y + dy * r)));
    context.closePath();
  };
}

const kShapes: Record<MarkLook["shape"], Shape> = {
  triangle: polygon([[0, -1.15], [1.15, 0.95], [-1.15, 0.95]]),
  diamond: polygon([[0, -1.2], [1.2, 0], [0, 1.2], [-1.2, 0]]),
  square: polygon([[-0.9, -0.9], [0.9, -0.9], [0.9, 0.9], [-0.9, 0.9]]),
  cross: polygon([[-1, -0.6], [-0.6, -1], [0.6, -1], [1, -0.6], [1, 0.6], [0.6, 1], [-0.6, 1], [-1, 0.6]]),
  circle: (context, x, y, r) => context.arc(x, y, r, 0, 2 * Math.PI),
};

/** Draws @param events in their row, those that would cover each other as one. */
export function drawEventMarks(
  context: CanvasRenderingContext2D,
  row: Row,
  field: TimeField,
  events: readonly UnitEvent[],
  selected: UnitEvent | undefined,
  palette: Palette,
): void {
  const y = row.top + row.height / 2;
  context.textBaseline = "middle";
  context.textAlign = "center";
  for (const cluster of clustersOf(events, (t) => xOf(field, t), kMarkDistance)) drawMark(context, cluster, y, cluster.event === selected, palette);
  context.textAlign = "left";
}

function drawMark(context: CanvasRenderingContext2D, cluster: Cluster, y: number, isSelected: boolean, palette: Palette): void {
  const { x, look, count, event } = cluster;
  const colours = palette.tones[look.tone] ?? { text: palette.text, soft: palette.line };
  const isGone = event.active === false;
  context.beginPath();
  kShapes[look.shape](context, x, y, kRadius);
  context.fillStyle = isGone ? palette.back : colours.soft;
  context.strokeStyle = colours.text;
  context.lineWidth = isSelected ? 3 : 1.3;
  context.fill();
  context.stroke();
  context.lineWidth = 1;
  context.fillStyle = colours.text;
  context.font = "bold 10px system-ui, sans-serif";
  context.fillText(look.letter, x, y + (look.shape === "triangle" ? 2 : 0.5));
  if (count > 1) {
    context.font = "9px system-ui, sans-serif";
    context.fillText(count > 99 ? "99+" : String(count), x + kRadius + 5, y - 8);
  }
}
