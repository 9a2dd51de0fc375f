import { afterEach, expect, test, vi } from "vitest";

import { LiveSource } from "../../src/source/live_source";
import { RecordedSource } from "../../src/source/recorded_source";
import { Refusal } from "../../src/source/refusal";
import { sessionOf, type Session } from "../../src/source/session";

/** Answers of a gateway, one after the other; what was asked. */
function gateway(...answers: [number, unknown][]): { url: string; init: RequestInit }[] {
  const asked: { url: string; init: RequestInit }[] = [];
  vi.stubGlobal("fetch", (url: string, init: RequestInit) => {
    asked.push({ url, init });
    const [status, body] = answers[asked.length - 1] ?? [500, null];
    return Promise.resolve(new Response(JSON.stringify(body), { status }));
  });
  return asked;
}
afterEach(() => vi.unstubAllGlobals());

test("a list comes in pages until none follows", async () => {
  const asked = gateway([200, { objects: [1, 2], next: 2 }], [200, { objects: [3] }]);
  const source = new LiveSource("", () => "");
  expect(await source.all("vcan0/5", "objects", "objects", { text: "60" })).toEqual([1, 2, 3]);
  expect(asked.map((each) => each.url)).toEqual([
    "/api/v1/units/vcan0/5/objects?text=60&from=0",
    "/api/v1/units/vcan0/5/objects?text=60&from=2",
  ]);
});

test("only what changes something carries the token", async () => {
  const asked = gateway([200, {}], [200, {}]);
  const source = new LiveSource("", () => "a-token");
  await source.get("vcan0/5", "explain");
  await source.act("PUT", "vcan0/5", "parameters/p1120", { value: 1 }, { axis: 1 });
  expect(new Headers(asked[0]?.init.headers).get("Authorization")).toBeNull();
  expect(new Headers(asked[1]?.init.headers).get("Authorization")).toBe("Bearer a-token");
});

test("a refusal keeps code, words and limits", async () => {
  gateway([422, { error: { code: "out-of-range", message: "p1120: below the minimum of 0 s", limits: { minimum: 0 } } }]);
  const why = await new LiveSource("", () => "t").act("PUT", "u/1", "parameters/p1120", {}).catch((e: unknown) => e);
  expect(why).toBeInstanceOf(Refusal);
  expect(why).toMatchObject({ code: "out-of-range", status: 422, message: "p1120: below the minimum of 0 s" });
  expect((why as Refusal).details["limits"]).toEqual({ minimum: 0 });
  expect((why as Refusal).isAbsence).toBe(false);
});

test("a gateway that is gone is an absence", async () => {
  vi.stubGlobal("fetch", () => Promise.reject(new TypeError("Failed to fetch")));
  const why = await new LiveSource("", () => "").overview().catch((e: unknown) => e);
  expect(why).toMatchObject({ code: "no-gateway", status: 0, isAbsence: true });
});

const session: Session = {
  format: "axisd-session",
  version: 1,
  title: "a run",
  made_by: "axisctl 0.2",
  made_at: "2026-11-23T20:00:00Z",
  verdict: { passed: false, text: "step 3 failed" },
  units: [
    {
      unit: "vcan0/5",
      resources: { "": { node_id: 5, nmt_state: "Operational" }, "pdos?all=true": { pdos: [1, 2] }, explain: { axes: [] } },
      recordings: [{ name: "a.axrec", data: "AAEC" }],
    },
  ],
};

test("a session gives what was recorded, lists as a whole", async () => {
  const source = new RecordedSource(sessionOf(session));
  expect(await source.overview()).toMatchObject([{ unit: "vcan0/5", node_id: 5, on: true }]);
  expect(await source.all("vcan0/5", "pdos", "pdos", { all: true })).toEqual([1, 2]);
  expect(source.recordings[0]?.bytes).toEqual(new Uint8Array([0, 1, 2]));
  expect(source.verdict).toMatchObject({ title: "a run", passed: false });
});

test("what was not recorded, and what would change something, is refused in words", async () => {
  const source = new RecordedSource(sessionOf(session));
  await expect(source.get("vcan0/5", "storage")).rejects.toThrow("storage was not recorded");
  await expect(source.act()).rejects.toThrow("nothing can be changed");
});

test("what is no session says what was expected", () => {
  expect(() => sessionOf({ a: 1 })).toThrow('no "format": "axisd-session"');
  expect(() => sessionOf({ format: "axisd-session", version: 7 })).toThrow("version 7");
});
