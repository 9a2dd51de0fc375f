import { describe, expect, it } from "vitest";

import { candumpOfFrames, csvOfSamples } from "../../../src/recording/export";
import { openFile } from "../../../src/recording/open_file";
import { csvRows } from "../../../src/recording/csv";
import { dataFile } from "../data/files";

function open(text: string, name = "file") {
  return openFile(name, new TextEncoder().encode(text));
}

describe("a log of candump", () => {
  const text = new TextDecoder().decode(dataFile("run.log"));
  const log = open(text, "run.log");

  it("is read with the directions of the predefined connection set", () => {
    expect(log).toMatchObject({ format: "candump", from: 0, unit: "", remark: "" });
    expect(log.frames.size).toBe(40);
    expect(log.startedAt).toBe(1795464880.27436);
    expect([log.frames.frame(0)?.sent, log.frames.frame(1)?.sent]).toEqual([false, true]);
  });

  it("comes out as it went in", () => {
    expect(candumpOfFrames(log.frames, log.from, log.to, "vcan0", log.startedAt)).toBe(text);
  });

  it("takes remote frames, 29 bits and directions, and leaves error frames out", () => {
    const found = open("# a comment\n(1.000000) can0 705#R1\n(1.5) can0 18FF0A05#01 T\n(1.6) can0 2000008C#0004000000000000\n(2.0) can0 080# R\n");
    expect(found.frames.frame(0)).toMatchObject({ isRemote: true, length: 1 });
    expect(found.frames.frame(1)).toMatchObject({ isExtended: true, id: 0x18ff0a05, sent: false });
    expect(found.frames.frame(2)).toMatchObject({ id: 0x80, sent: true, t: 1 });
    expect(found.remark).toBe("1 error frames were left out");
  });

  it("names lines that cannot be read", () => {
    const found = open("(1.0) can0 205#0F00\n(1.1) can0 205#0F0\n(1.2) can0 25#00\nhello\n(1.3) can0 205#000102030405060708\n");
    expect(found.frames.size).toBe(1);
    expect(found.remark).toBe(
      'left out: line 2: "0F0" is no data: pairs of hexadecimal digits; line 3: an identifier has 3 or 8 hexadecimal digits, not 2; ' +
        "line 4: (seconds) interface id#data was expected; line 5: 9 bytes of data; a CAN frame has at most 8",
    );
  });

  it("of CAN FD is refused", () => {
    expect(() => open("(1.0) can0 205##00F00\n", "fd.log")).toThrow(
      "fd.log, line 1: a frame of CAN FD; CANopen and this page know classical CAN only",
    );
  });
});

describe("a trace", () => {
  it("is read from CSV and comes out as it went in", () => {
    const text = new TextDecoder().decode(dataFile("trace.csv"));
    const trace = open(text, "trace.csv");
    expect(trace).toMatchObject({ format: "trace-csv", remark: "" });
    expect(trace.samples.signals).toEqual([{ signal: "1/speed", unit: "rpm" }, { signal: "1/torque", unit: "Nm" }]);
    expect(trace.triggerT).toBeCloseTo(3.16541902, 8);
    expect(csvOfSamples(trace.samples, trace.from, trace.to, trace.triggerT)).toBe(text);
    expect(csvOfSamples(trace.samples, 3.17, 3.18)).toBe("t (s),1/speed (rpm),1/torque (Nm)\n3.173419020,594.3077623250783,0\n");
  });

  it("is read from JSON with its frames and events", () => {
    const trace = openFile("trace.json", dataFile("trace.json"));
    expect(trace.frames.size).toBe(12);
    expect(trace.events.map(({ kind }) => kind)).toEqual(["drive-state", "fault", "emcy"]);
    expect(trace.events[1]).toMatchObject({ name: "F07860", axis: 1, active: true });
    expect(trace.samples.signals[0]).toMatchObject({ signal: "1/speed", text: "Speed of the motor shaft" });
  });

  it.each([
    ["t (s),1/speed (rpm)\n1,x\n", 'file, line 2: 2 numbers were expected, not "1,x"'],
    ["t (s),1/speed (rpm)\n1\n", 'file, line 2: 2 numbers were expected, not "1"'],
    ["{}", 'file: JSON, but no trace: "signals" and "samples" were expected'],
    ['{"a":', "file: no JSON: "],
    ["", "file: the file is empty"],
    ["PK\u0003\u0004", 'file begins with "PK..": a recording (AXISREC)'],
  ])("%j is refused with words", (text, message) => {
    expect(() => open(text)).toThrow(message);
  });
});

it("reads CSV with quotes", () => {
  expect(csvRows('a,"b,""c""\nd",e\r\n\r\n1,,\n')).toEqual([["a", 'b,"c"\nd', "e"], ["1", "", ""]]);
});
