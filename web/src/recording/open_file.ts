import { Refusal } from "../source/refusal";
import type { Recording } from "./recording";

/** What is told of a unit whose file does not say it. */
export interface OpenSettings {
  /** Number of the lane of an identifier (ServiceMap.laneOf); if not given, by the head of the file and the predefined set. */
  laneOf?: (id: number, isExtended: boolean) => number;
}

/** The recording in @param bytes, whatever it is: .axrec, candump log, CSV or JSON of a trace. A Refusal says what is wrong and where. */
export function openFile(name: string, bytes: Uint8Array, settings: OpenSettings = {}): Recording {
  void settings;
  throw new Refusal("damaged", `${name}: ${bytes.length}`);
}
