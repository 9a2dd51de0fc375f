import type { Range } from "../view/window";

/** Where on a canvas the time lies: x from left to left + width. All in CSS pixels. */
export interface TimeField extends Range {
  left: number;
  width: number;
}

/** Where @param t is. */
export function xOf(field: TimeField, t: number): number {
  return field.left + ((t - field.from) / (field.to - field.from)) * field.width;
}

/** Makes @param canvas so many CSS pixels large, sharp on every screen; its context, cleared. */
export function cleared(canvas: HTMLCanvasElement, width: number, height: number): CanvasRenderingContext2D | null {
  const ratio = devicePixelRatio || 1;
  const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== w || canvas.height !== h) {
    canvas.width = w;
    canvas.height = h;
    canvas.style.width = `${width}px`;
    canvas.style.height = `${height}px`;
  }
  const context = canvas.getContext("2d");
  context?.setTransform(ratio, 0, 0, ratio, 0, 0);
  context?.clearRect(0, 0, width, height);
  return context;
}

/** @param text, cut so that it is not wider than @param width. */
export function fitted(context: CanvasRenderingContext2D, text: string, width: number): string {
  if (context.measureText(text).width <= width) return text;
  let cut = text;
  while (cut.length > 1 && context.measureText(`${cut}…`).width > width) cut = cut.slice(0, -1);
  return cut.length > 1 ? `${cut}…` : "";
}
