import type { Mark } from "../data/material";
import { instantText, niceStep, ticksOf } from "../view/scale";
import { kFont, type Palette } from "./palette";
import { fitted, xOf, type TimeField } from "./time_field";

/** Height of the ruler (CSS pixels); with marks it is higher. */
export const kRulerHeight = 26;
export const kMarksHeight = 20;
/** Width that an instant on the ruler needs. */
const kTickWidth = 92;

/** The round instants of the ruler. */
export function rulerTicks(field: TimeField): number[] {
  return ticksOf(field.from, field.to, Math.max(2, field.width / kTickWidth));
}

/** Draws the time axis with the named instants. */
export function drawRuler(context: CanvasRenderingContext2D, field: TimeField, marks: readonly Mark[], palette: Palette): void {
  context.font = kFont;
  context.textBaseline = "middle";
  context.fillStyle = palette.muted;
  context.strokeStyle = palette.line;
  const ticks = rulerTicks(field);
  const step = niceStep((field.to - field.from) / Math.max(2, field.width / kTickWidth));
  context.beginPath();
  for (const t of ticks) {
    const x = Math.round(xOf(field, t)) + 0.5;
    context.moveTo(x, kRulerHeight - 7);
    context.lineTo(x, kRulerHeight);
    const text = instantText(t, step);
    const half = context.measureText(text).width / 2;
    context.fillText(text, Math.min(field.left + field.width - 2 * half, Math.max(field.left, x - half)), 10);
  }
  context.moveTo(field.left, kRulerHeight - 0.5);
  context.lineTo(field.left + field.width, kRulerHeight - 0.5);
  context.stroke();
  context.textAlign = "left";
  drawMarks(context, field, marks, palette);
}

function drawMarks(context: CanvasRenderingContext2D, field: TimeField, marks: readonly Mark[], palette: Palette): void {
  const shown = marks.filter(({ t }) => t >= field.from && t <= field.to).toSorted((one, two) => one.t - two.t);
  const y = kRulerHeight + kMarksHeight / 2;
  let edge = -Infinity;
  shown.forEach((mark, i) => {
    const x = xOf(field, mark.t);
    const next = shown[i + 1];
    const room = (next === undefined ? field.left + field.width : xOf(field, next.t)) - x - 16;
    context.fillStyle = mark.isFailed === true ? (palette.tones["fault"]?.text ?? palette.text) : palette.accent;
    context.beginPath();
    context.moveTo(x, kRulerHeight + kMarksHeight);
    context.lineTo(x - 5, y - 4);
    context.lineTo(x + 5, y - 4);
    context.fill();
    if (x < edge) return;
    const text = fitted(context, mark.isFailed === true ? `${mark.text} – failed` : mark.text, room);
    context.fillText(text, x + 8, y);
    edge = x + 8 + context.measureText(text).width;
  });
}
