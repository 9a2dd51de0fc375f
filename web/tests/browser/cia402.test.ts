// A unit of profile cia402: every page has what such a device has, and nothing of parameters, panels and wiring.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { AxeBuilder } from "@axe-core/playwright";

import { Bench, kBin } from "./bench.ts";

const kPages = ["overview", "scope", "states", "parameters", "objects", "process-data", "hands", "fleet"];
let bench: Bench;
/** What the page has asked that such a unit refuses. */
const refused: string[] = [];

before(async () => {
  bench = await Bench.start({ config: { profile: "cia402", axes: [{ name: "X" }] } });
  bench.page.on("request", (request) => {
    if (/\/(parameters|panel|identification|terminals|if1)(\/|\?|$)/.test(request.url())) refused.push(request.url());
  });
  await bench.show("#/overview");
  await bench.giveToken();
  await bench.page.getByRole("button", { name: "Token: right" }).waitFor();
});
after(() => bench.close());

test("the overview has mode and homing, and leads to objects", async () => {
  const { page } = bench;
  const axis = page.getByRole("region", { name: "Axis 1 X" });
  await axis.getByText("Switch on disabled").first().waitFor();
  await axis.getByText("no mode").waitFor();
  await axis.getByText("Homed").waitFor();
  await page.getByText("CiA 402, node 5").waitFor();
  await axis.getByRole("link", { name: "Objects" }).waitFor();
  assert.equal(await axis.getByRole("link", { name: "Parameters" }).count(), 0);
});

test("there are no parameters, and the page says so", async () => {
  const { page } = bench;
  const pages = page.getByRole("navigation", { name: "Pages" });
  await bench.show("#/objects");
  await pages.getByRole("link", { name: "Objects", exact: true }).waitFor();
  assert.equal(await pages.getByRole("link", { name: "Parameters" }).count(), 0);
  await bench.show("#/parameters");
  await page.getByText("This device has no parameters: its profile is cia402.").waitFor();
  await page.getByRole("main").getByRole("link", { name: "Objects" }).click();
  await page.getByRole("heading", { level: 1, name: "Objects" }).waitFor();
});

test("objects are named by the EDS of the profile", async () => {
  const { page } = bench;
  const unit = ((await (await fetch(new URL("/api/v1/units", bench.url))).json()) as { units: { unit: string }[] }).units[0]?.unit ?? "";
  const eds = await (await fetch(new URL(`/api/v1/units/${unit}/eds`, bench.url))).text();
  assert.equal(eds, readFileSync(join(kBin, "../share/axisd/eds/axisd-cia402.eds"), "utf8"));
  await bench.show("#/objects?text=6099");
  await page.getByText("Homing speeds", { exact: false }).first().waitFor();
});

test("hands enable the axis by controlword and turn it by a velocity", async () => {
  const { page } = bench;
  await bench.show("#/hands");
  const card = page.getByRole("region", { name: "Controlword and mode" });
  await card.getByLabel("Mode of operation").selectOption("3");
  await card.getByRole("button", { name: "Set the mode" }).click();
  await card.getByText("mode: profile velocity").waitFor();
  for (const [order, state] of [["Shutdown", "Ready to switch on"], ["Switch on", "Switched on"], ["Enable operation", "Operation enabled"]] as const) {
    await card.getByRole("button", { name: order, exact: true }).click();
    await card.getByText(state, { exact: true }).waitFor();
  }
  bench.axisctl("object", "write", "60FF:00", "655360"); // 10 revolutions a second
  bench.axisctl("wait", "value", "1/speed", "ge", "590", "--timeout", "30");
  for (const name of ["Operator panel", "Motor data identification", "Stop"])
    assert.equal(await page.getByRole("region", { name, exact: true }).count(), 0, name);
});

test("the state machine is that of CiA 402", async () => {
  const { page } = bench;
  await bench.show("#/states");
  const picture = page.getByRole("group", { name: "State machine" });
  await picture.getByText("Operation enabled").first().waitFor();
  await picture.getByRole("button", { name: /^11: Operation enabled → Quick stop active/ }).waitFor();
  await picture.getByRole("button", { name: /^8: Operation enabled → Ready to switch on/ }).waitFor();
  assert.equal(await picture.getByText(/OFF1|STOP2/).count(), 0);
  assert.equal(await page.getByRole("main").getByRole("link", { name: /^[pr]\d{4}/ }).count(), 0);
});

test("the scope has signals, and frames in words of the profile", async () => {
  const { page } = bench;
  await bench.show("#/scope?signals=1/speed,1/torque");
  await page.getByText("1/speed").first().waitFor();
  await page.getByRole("button", { name: "Frames", exact: true }).click();
  await page.getByLabel("Service").selectOption("SDO");
  const request = page.getByRole("button", { name: /605#23FF600000000A00/ }).first();
  for (let tries = 0; tries < 20 && !(await request.isVisible()); ++tries) {
    bench.cansend("605#23FF600000000A00"); // until the page listens
    await request.waitFor({ timeout: 1000 }).catch(() => undefined);
  }
  await request.click();
  await page.getByLabel("What was chosen").getByText("655360\u2009units/s").first().waitFor();
});

test("process data have the mapping of the profile", async () => {
  const { page } = bench;
  await bench.show("#/process-data");
  await page.getByRole("region", { name: "RPDO 1 axis 1" }).getByText("Controlword").first().waitFor();
});

for (const colorScheme of ["light", "dark"] as const)
  for (const size of [{ width: 1280, height: 800 }, { width: 390, height: 844 }])
    test(`every page, ${colorScheme}, ${size.width} wide`, async () => {
      const { page } = bench;
      await page.emulateMedia({ colorScheme });
      await page.setViewportSize(size);
      for (const name of kPages) {
        await bench.show(`#/${name}`);
        await page.waitForFunction(() => document.querySelector(".notice-error") === null);
        const found = await new AxeBuilder({ page }).analyze();
        assert.deepEqual(found.violations.map((each) => `${name} ${each.id}: ${each.nodes.map((node) => node.html).join(" ")}`), []);
        const width = await page.evaluate(() => document.documentElement.scrollWidth);
        assert.ok(width <= size.width, `${name} is ${width} wide`);
      }
    });

test("nothing was asked that such a unit refuses, and nothing complains", () => {
  assert.deepEqual(refused, []);
  assert.deepEqual(bench.complaints, []);
});
