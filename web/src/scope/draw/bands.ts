import { bandsIn, type Band } from "../../model/timeline";
import { lookOf } from "../../ui/state_words";
import type { Row } from "../view/layout";
import { kSmallFont, type Palette } from "./palette";
import { fitted, xOf, type TimeField } from "./time_field";

/** Tones of NMT states; drive states have theirs in ui/state_words. */
const kNmtTones: Record<string, string> = { operational: "run", "pre-operational": "ready", stopped: "brake" };

/** The tone of a band's state. */
export function toneOf(row: Row, state: string): string {
  if (row.kind === "axis") return lookOf(state).tone;
  return kNmtTones[state.toLowerCase().replaceAll("_", "-")] ?? "off";
}

/** Draws the states of @param bands in their row, until @param end. */
export function drawBands(
  context: CanvasRenderingContext2D,
  row: Row,
  field: TimeField,
  bands: readonly Band[],
  end: number,
  palette: Palette,
): void {
  context.font = kSmallFont;
  context.textBaseline = "middle";
  for (const band of bandsIn(bands, field.from, field.to)) {
    const left = Math.max(field.left, xOf(field, band.from));
    const right = Math.min(field.left + field.width, xOf(field, Math.min(band.to, end)));
    if (right < left) continue;
    const width = Math.max(1.5, right - left);
    const colours = palette.tones[toneOf(row, band.state)] ?? { text: palette.text, soft: palette.line };
    context.fillStyle = colours.soft;
    context.fillRect(left, row.top, width, row.height);
    context.fillStyle = colours.text;
    context.fillRect(left, row.top, 1.5, row.height);
    context.fillRect(left, row.top + row.height - 2, width, 2);
    if (width > 16) context.fillText(fitted(context, band.state, width - 8), left + 5, row.top + row.height / 2);
  }
}
