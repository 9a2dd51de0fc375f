import { describe, expect, it } from "vitest";

import { LiveParameters } from "../../../src/parameters/data/live_parameters";
import { entryNamed, RecordedParameters } from "../../../src/parameters/data/recorded_parameters";
import { RecordedSource } from "../../../src/source/recorded_source";
import type { Query, Source } from "../../../src/source/source";
import { entry, kInput, kWord } from "./samples";

/** A source that notes what is asked, and always gives the same page. */
function asked(page: unknown): { source: Source; requests: [string, Query][] } {
  const requests: [string, Query][] = [];
  const get = (_: string, resource: string, query: Query = {}): Promise<unknown> => {
    requests.push([resource, query]);
    return Promise.resolve(page);
  };
  return { source: { isLive: true, get } as unknown as Source, requests };
}

describe("parameters of a unit that lives", () => {
  const kPage = { parameters: [kWord, kInput, entry({})], total: 9, next: 3 };

  it("are listed by filter without a text", async () => {
    const { source, requests } = asked(kPage);
    const part = await new LiveParameters(source, "vcan0/5").part({ place: 1, text: "", filter: "inputs" }, 64);
    expect(requests).toEqual([["axes/1/parameters", { filter: "inputs", from: 64 }]]);
    expect(part.next).toBe(3);
  });

  it("are searched by the unit, and filtered here", async () => {
    const { source, requests } = asked(kPage);
    const parameters = new LiveParameters(source, "vcan0/5");
    const part = await parameters.part({ place: "infeed", text: "r0899.2", filter: "outputs" }, 0);
    expect(requests).toEqual([["parameters", { text: "r0899", axis: "infeed", from: 0 }]]);
    expect(part.entries).toEqual([kWord]);
  });

  it("are listed when only the changed ones are wanted, and searched here", async () => {
    const { source, requests } = asked(kPage);
    const part = await new LiveParameters(source, "vcan0/5").part({ place: 1, text: "ramp", filter: "changed" }, 0);
    expect(requests[0]?.[0]).toBe("axes/1/parameters");
    expect(part.entries.map((each) => each.parameter)).toEqual(["p1120"]);
  });

  it("are read 32 at a time", async () => {
    const { source, requests } = asked({ parameters: [], total: 0 });
    const names = Array.from({ length: 40 }, (_, index) => `p8861[${index}]`);
    await new LiveParameters(source, "vcan0/5").read(2, names);
    expect(requests).toHaveLength(2);
    expect(requests[1]?.[0]).toBe(`parameters/${names.slice(32).map(encodeURIComponent).join(",")}`);
  });
});

describe("parameters of a recording", () => {
  const kElements = [0, 1].map((index) => entry({ parameter: `p1070[${index}]`, number: 1070, index, indices: 2 }));
  const resources = {
    "": { axes: [{ axis: 1 }] },
    "axes/0/parameters": { parameters: [entry({ axis: 0, parameter: "r0722", number: 722, name: "Inputs" })] },
    "axes/1/parameters": { parameters: [kWord, kInput, ...kElements] },
    "parameters/diff?against=factory": { parameters: [{ parameter: "p1120" }], is_stored: false },
  };
  const source = new RecordedSource({
    format: "axisd-session",
    version: 1,
    title: "",
    made_by: "",
    made_at: "",
    units: [{ unit: "vcan0/5", resources, recordings: [] }],
  });
  const parameters = new RecordedParameters(source, "vcan0/5");

  it("are searched and filtered in the page", async () => {
    const part = await parameters.part({ place: 1, text: "899", filter: "all" }, 0);
    expect(part).toEqual({ entries: [kWord], total: 4 });
    expect((await parameters.part({ place: 1, text: "", filter: "inputs" }, 0)).entries).toEqual([kInput]);
  });

  it("are found by name, with a bit or an index", async () => {
    const read = await parameters.read(1, ["r0899.2", "p1070", "p1070[1]", "p9999"]);
    expect(read.map((each) => [each.parameter, each.value])).toEqual([["r0899.2", 1], ["p1070[0]", 10], ["p1070[1]", 10]]);
    expect(entryNamed([kWord], "r0899.1")?.value).toBe(0);
  });

  it("are found elsewhere, and differ as was recorded", async () => {
    expect(await parameters.elsewhere("inputs")).toEqual([{ parameter: "r0722", name: "Inputs", places: [0] }]);
    expect((await parameters.differences("factory")).entries).toHaveLength(1);
    await expect(parameters.differences("stored")).rejects.toThrow("was not recorded");
  });

  it("say what was not recorded", async () => {
    await expect(parameters.part({ place: 2, text: "", filter: "all" }, 0)).rejects.toThrow("was not recorded");
  });
});
