import { describe, expect, it } from "vitest";

import { Decoder } from "../../../src/canopen/decode";
import { parseEds } from "../../../src/canopen/eds";
import { ServiceMap } from "../../../src/canopen/services";
import { FrameStore } from "../../../src/model/frame_store";
import { frameOf, projectText } from "../data/files";

const kEds = parseEds(projectText("eds/axisd.eds"));
const kServices = new ServiceMap({ nodeId: 5 });
const kDecoder = new Decoder({ services: kServices, eds: kEds });

function storeOf(lines: string[]): FrameStore {
  const store = new FrameStore(kServices.laneOf);
  lines.forEach((line, i) => store.append(frameOf(line, i / 1000)));
  return store;
}

function at(store: FrameStore, serial: number) {
  const found = kDecoder.decodeAt(store, serial);
  if (found === undefined) throw new Error(`no frame ${serial}`);
  return found;
}

function valueIn(store: FrameStore, serial: number): string | undefined {
  return at(store, serial).rows.find((row) => row.name === "Value of the transfer")?.value;
}

describe("an SDO transfer", () => {
  const other = ["185#3116", "606#4000100000000000"];

  it("in segments is put together, with other frames between its own", () => {
    const store = storeOf(["605#4008100000000000", "585#4108100008000000", ...other, "605#6000000000000000", "585#0053494E414D4943", "605#7000000000000000", "585#1D53000000000000"]);
    expect(at(store, 5)).toMatchObject({ partner: 4, transfer: [0, 1, 4, 5, 6, 7] });
    expect(at(store, 5).headline).toBe("SDO response: upload segment of 1008h:00 Manufacturer Device Name");
    expect(at(store, 0).partner).toBe(1);
    expect(at(store, 7).rows.find((row) => row.name === "Transfer")?.value).toBe("upload in segments, 6 frames");
    expect(valueIn(store, 7)).toBe('"SINAMICS"');
  });

  it("ends with an abort of either side", () => {
    const store = storeOf(["605#2300100001000000", "585#8000100002000106", "605#4000100000000000", "585#430010009201FFFF"]);
    expect(at(store, 0).transfer).toEqual([0, 1]);
    expect(at(store, 0).rows.find((row) => row.name === "Transfer")?.value).toBe("download expedited, aborted, 2 frames");
    expect(at(store, 3).transfer).toEqual([2, 3]);
  });

  it("in blocks from the client is put together, resent segments too", () => {
    const store = storeOf([
      "605#C608100009000000", "585#A408100002000000", "605#0131323334353637", "605#8238390000000000", "585#A201020000000000",
      "605#8138390000000000", "585#A201020000000000", "605#D5AB120000000000", "585#A100000000000000", "605#4000100000000000",
    ]);
    expect(at(store, 2).transfer).toEqual([0, 1, 2, 3, 4, 5, 6, 7, 8]);
    expect(at(store, 2).headline).toBe("SDO request: block segment 1 of 1008h:00 Manufacturer Device Name");
    expect(at(store, 3).headline).toContain("block segment 2, the last");
    expect(valueIn(store, 8)).toBe('"123456789"');
    expect(at(store, 8).rows.find((row) => row.name === "Transfer")?.value).toBe("download in blocks, 9 frames");
    expect(at(store, 8).remark).toBeUndefined();
    expect(at(store, 9).transfer).toEqual([9]);
  });

  it("in blocks from the server is put together, a full last block too", () => {
    const store = storeOf([
      "605#A408100002000000", "585#C60810000E000000", "605#A300000000000000", "585#0141424344454647", "585#8248494A4B4C4D4E",
      "605#A202020000000000", "585#C1AB120000000000", "605#A100000000000000",
    ]);
    expect(valueIn(store, 7)).toBe('"ABCDEFGHIJKLMN"');
    expect(at(store, 6).headline).toBe("SDO response: block upload: end of 1008h:00 Manufacturer Device Name");
    expect(at(store, 4).partner).toBe(2);
  });

  it("whose sizes differ says so", () => {
    const store = storeOf(["605#2108100003000000", "585#6008100000000000", "605#0D41000000000000", "585#2000000000000000"]);
    expect(at(store, 3).remark).toBe("3 bytes were announced, 1 have come");
  });

  it("whose response is for another object says so", () => {
    const store = storeOf(["605#4008100000000000", "585#430010009201FFFF"]);
    expect(at(store, 1).remark).toBe("the request was for 1008h:00 Manufacturer Device Name");
  });
});
