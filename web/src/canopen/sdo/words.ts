import type { Content, DecodedRow } from "../decoded";
import type { Eds } from "../eds";
import { hexOf, objectText, type CanFrame } from "../frame";
import { objectWords, type Scaling } from "../object_words";
import type { SdoStep, SdoTransfer } from "./reader";
import type { TransferPlace } from "./transfer";
import { typeName } from "../value";
import { wordText } from "../words";

/** What objects are called, and how their values are read. */
export interface ObjectNames {
  eds?: Eds | undefined;
  scaling: Scaling;
}

interface Place {
  index: number;
  subIndex: number;
}

const kFormText: Record<SdoTransfer["form"], string> = {
  expedited: "expedited",
  segmented: "in segments",
  block: "in blocks",
};

function nameOf({ index, subIndex }: Place, { eds }: ObjectNames): string {
  return `${objectText(index, subIndex)} ${eds?.nameOf(index, subIndex) ?? ""}`.trim();
}

function objectRow(at: Place, names: ObjectNames): DecodedRow {
  const type = typeName(names.eds?.find(at.index, at.subIndex)?.dataType ?? 0);
  const name = names.eds?.nameOf(at.index, at.subIndex) ?? "";
  const value = [name, type].filter((word) => word !== "").join(", ");
  return { name: "Object", value: value === "" ? "not in the EDS" : value, object: objectText(at.index, at.subIndex) };
}

function valueRow(at: Place, data: Uint8Array, names: ObjectNames, name = "Value"): DecodedRow {
  const type = names.eds?.find(at.index, at.subIndex)?.dataType ?? 0;
  const row: DecodedRow = { name, ...objectWords(at.index, at.subIndex, data, type, names.scaling) };
  if (data.length > 0 && data.length <= 8) row.raw = hexOf(data, " ");
  row.object = objectText(at.index, at.subIndex);
  return row;
}

/** A frame by itself: segments do not say what they are a part of. */
export function decodeStep(step: SdoStep, frame: CanFrame, names: ObjectNames): Content {
  const rows: DecodedRow[] = [{ name: "Command", value: step.text, raw: wordText(frame.data[0] ?? 0, 2) }];
  let { text } = step;
  if (step.object !== undefined) {
    rows.push(objectRow(step.object, names));
    text += ` ${nameOf(step.object, names)}`;
  }
  if (step.object !== undefined && step.data !== undefined) {
    const row = valueRow(step.object, step.data, names);
    rows.push(row);
    text += ` = ${row.value}`;
  } else if (step.data !== undefined) {
    rows.push({ name: "Data", value: hexOf(step.data, " ") });
  }
  rows.push(...step.rows);
  return step.remark === undefined ? { text, rows } : { text, rows, remark: step.remark };
}

function stateText(transfer: SdoTransfer): string {
  const how = `${transfer.direction} ${kFormText[transfer.form]}`;
  if (transfer.state === "aborted") return `${how}, aborted`;
  return transfer.state === "done" ? how : `${how}, not ended`;
}

/** A frame with what its transfer tells of it. */
export function decodeTransfer(place: TransferPlace, frame: CanFrame, names: ObjectNames): Content {
  const { step, transfer } = place;
  const content = decodeStep(step, frame, names);
  if (transfer === undefined) return content;
  const object = { index: transfer.index, subIndex: transfer.subIndex };
  if (step.object === undefined) {
    content.text += ` of ${nameOf(object, names)}`;
    content.rows.splice(1, 0, objectRow(object, names));
  } else if (step.object.index !== object.index || step.object.subIndex !== object.subIndex) {
    content.remark = `the request was for ${nameOf(object, names)}`;
  }
  content.rows.push({ name: "Transfer", value: `${stateText(transfer)}, ${place.frames.length} frames` });
  const hasOwnValue = step.object !== undefined && step.data !== undefined;
  if (transfer.state === "done" && !hasOwnValue)
    content.rows.push(valueRow(object, Uint8Array.from(transfer.data), names, "Value of the transfer"));
  if (transfer.size !== undefined && transfer.state === "done" && transfer.size !== transfer.data.length)
    content.remark = `${transfer.size} bytes were announced, ${transfer.data.length} have come`;
  return content;
}
