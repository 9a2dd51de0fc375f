import { Refusal } from "../../source/refusal";
import { download } from "../../ui/download";
import { fileName } from "../data/exports";
import type { ScopeState } from "../data/scope_state";
import { instantText } from "../view/scale";
import { LowerPicture } from "./lower_picture";
import { kFont, lightPalette, type Palette } from "./palette";
import { kRight, Plot } from "./plot";
import { drawRuler, kMarksHeight, kRulerHeight, rulerTicks } from "./ruler";
import { xOf, type TimeField } from "./time_field";

const kWidth = 1400;
const kPlotHeight = 420;
const kLeft = 96;
const kTitle = 30;
const kLegendRow = 18;
/** Pixels of the file a CSS pixel. */
const kRatio = 2;

/** Draws the signals' names with their curves' colours; the height that it took. */
function drawLegend(context: CanvasRenderingContext2D, state: ScopeState, top: number, palette: Palette): number {
  context.font = kFont;
  context.textBaseline = "middle";
  let x = kLeft;
  let y = top + kLegendRow / 2;
  state.model.material.peek().samples.signals.forEach((signal, i) => {
    const text = `${signal.signal}${signal.text ? ` ${signal.text}` : ""}${signal.unit ? ` (${signal.unit})` : ""}`;
    const width = context.measureText(text).width + 34;
    if (x + width > kWidth && x > kLeft) {
      x = kLeft;
      y += kLegendRow;
    }
    context.fillStyle = palette.curves[i % palette.curves.length] ?? palette.text;
    context.fillRect(x, y - 2, 16, 3);
    context.fillStyle = palette.text;
    context.fillText(text, x + 20, y);
    x += width;
  });
  return y + kLegendRow / 2 - top;
}

/** The curves on canvases of their own; they are taken away by end(). */
async function drawCurves(state: ScopeState, field: TimeField, palette: Palette): Promise<{ canvases: HTMLCanvasElement[]; end: () => void }> {
  const place = document.createElement("div");
  place.className = "scope-export";
  document.body.append(place);
  const plot = new Plot(place);
  const { samples } = state.model.material.peek();
  plot.build(samples.signals, kLeft + field.width + kRight, kPlotHeight, kLeft, palette);
  plot.ticks = rulerTicks(field);
  plot.draw(samples.window(field.from, field.to, Math.round(field.width)), field);
  await new Promise((done) => setTimeout(done, 60));
  return {
    canvases: plot.canvases(),
    end: () => {
      plot.end();
      place.remove();
    },
  };
}

function drawLines(context: CanvasRenderingContext2D, state: ScopeState, field: TimeField, top: number, bottom: number, palette: Palette): void {
  const lines = [["A", state.model.a.peek()], ["B", state.model.b.peek()]] as const;
  context.strokeStyle = palette.accent;
  context.fillStyle = palette.accent;
  context.setLineDash([5, 3]);
  for (const [name, t] of lines) {
    if (t === null || t < field.from || t > field.to) continue;
    const x = xOf(field, t);
    context.beginPath();
    context.moveTo(x, top);
    context.lineTo(x, bottom);
    context.stroke();
    context.fillText(`${name} ${instantText(t, (field.to - field.from) / 2000)}`, x + 4, top + 7);
  }
  context.setLineDash([]);
}

/** Hands the picture to the user, on a light ground whatever the theme. */
export async function exportPng(state: ScopeState): Promise<void> {
  const material = state.model.material.peek();
  const palette = lightPalette();
  const field: TimeField = { left: kLeft, width: kWidth - kLeft - kRight, ...state.model.range() };
  const lower = new LowerPicture();
  const { bins, height } = lower.prepare(material, field);
  const { canvases, end } = await drawCurves(state, field, palette);
  const heights = canvases.map((canvas) => canvas.height / (devicePixelRatio || 1));
  const rulerHeight = kRulerHeight + (material.marks.length > 0 ? kMarksHeight : 0);
  const legend = kLegendRow * Math.max(1, Math.ceil(material.samples.signals.length / 2));
  const canvas = document.createElement("canvas");
  canvas.width = kWidth * kRatio;
  canvas.height = (kTitle + legend + rulerHeight + heights.reduce((sum, each) => sum + each, 0) + height + 8) * kRatio;
  const context = canvas.getContext("2d");
  if (context === null) throw new Refusal("no-canvas", "This browser draws no pictures.");
  context.scale(kRatio, kRatio);
  context.fillStyle = palette.back;
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.fillStyle = palette.text;
  context.font = `bold ${kFont}`;
  context.textBaseline = "middle";
  context.fillText(`${material.name}, from ${instantText(field.from, 1e-3)} to ${instantText(field.to, 1e-3)}`, kLeft, kTitle / 2);
  drawLegend(context, state, kTitle, palette);
  let top = kTitle + legend;
  const begin = top;
  context.translate(0, top);
  drawRuler(context, field, material.marks, palette);
  context.translate(0, -top);
  top += rulerHeight;
  canvases.forEach((each, i) => {
    context.drawImage(each, 0, top, kWidth, heights[i] ?? 0);
    top += heights[i] ?? 0;
  });
  context.translate(0, top);
  lower.draw(context, material, field, bins, null, palette);
  context.translate(0, -top);
  drawLines(context, state, field, begin, top + height, palette);
  end();
  await save(canvas, fileName(state, "png"));
}

async function save(canvas: HTMLCanvasElement, name: string): Promise<void> {
  const blob = await new Promise<Blob | null>((done) => canvas.toBlob(done, "image/png"));
  if (blob === null) throw new Refusal("no-picture", "The picture is too large for this browser.");
  download(name, blob, "image/png");
}
