import { kLaneCount } from "../../canopen/services";
import type { Material } from "../data/material";
import { Density, type Bins } from "../view/density";
import { heightOf, rowsOf, type Row } from "../view/layout";
import type { Selection } from "../view/scope_model";
import { drawBands } from "./bands";
import { drawFrames, drawNames } from "./frames";
import { drawEventMarks } from "./marks";
import type { Palette } from "./palette";
import { xOf, type TimeField } from "./time_field";

/** Number of the lane of foreign frames: it is shown if there are any. */
const kOther = kLaneCount - 1;

/** Below the curves: states as bands, events as marks, frames in lanes. */
export class LowerPicture {
  rows: Row[] = [];
  private readonly density = new Density();
  private hasOther = false;

  /** Counts the frames and finds the rows; the height of the picture. */
  prepare(material: Material, field: TimeField): { bins: Bins; height: number } {
    const bins = this.density.of(material.frames, field.from, field.to, Math.max(10, Math.round(field.width)));
    if (!this.hasOther) this.hasOther = bins.counts.subarray(kOther * bins.count).some((count) => count > 0);
    const lanes = Array.from({ length: kLaneCount }, (_, lane) => lane).filter((lane) => lane !== kOther || this.hasOther);
    this.rows = rowsOf([...material.timeline().axes.keys()], lanes);
    return { bins, height: heightOf(this.rows) };
  }

  /** Frames have come to other lanes: they are counted again. */
  forget(): void {
    this.density.forget();
    this.hasOther = false;
  }

  draw(
    context: CanvasRenderingContext2D,
    material: Material,
    field: TimeField,
    bins: Bins,
    selection: Selection | null,
    palette: Palette,
  ): void {
    drawNames(context, this.rows, field, bins, palette);
    const end = material.isLive ? field.to : material.extent().to;
    context.save();
    context.beginPath();
    context.rect(field.left, 0, field.width + 1, heightOf(this.rows));
    context.clip();
    for (const row of this.rows) this.drawRow(context, row, material, field, bins, end, selection, palette);
    context.restore();
  }

  private drawRow(
    context: CanvasRenderingContext2D,
    row: Row,
    material: Material,
    field: TimeField,
    bins: Bins,
    end: number,
    selection: Selection | null,
    palette: Palette,
  ): void {
    const states = material.timeline();
    if (row.kind === "nmt") drawBands(context, row, field, states.nmt, end, palette);
    if (row.kind === "axis" && row.place !== undefined)
      drawBands(context, row, field, states.axes.get(row.place) ?? [], end, palette);
    if (row.kind === "marks") {
      const events = material.events().filter(({ t }) => t >= field.from && t <= field.to);
      drawEventMarks(context, row, field, events, selection?.kind === "event" ? selection.event : undefined, palette);
    }
    if (row.kind !== "frames") return;
    drawFrames(context, row, field, bins, palette);
    if (selection?.kind !== "frame" || material.frames.laneAt(selection.serial) !== row.lane) return;
    const x = xOf(field, material.frames.timeOf(selection.serial));
    context.strokeStyle = palette.accent;
    context.lineWidth = 2;
    context.strokeRect(x - 3, row.top, 6, row.height);
    context.lineWidth = 1;
  }
}
