// The page of a scenario that has failed, opened from the disk: no gateway, no daemon, no network.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { after, before, test } from "node:test";

import { AxeBuilder } from "@axe-core/playwright";
import type { Browser, Locator, Page } from "playwright-core";

import { kBin, kPatience, openChromium } from "./bench.ts";

const folder = mkdtempSync(join(tmpdir(), "axisd-session-"));
const complaints: string[] = [];
let browser: Browser;
let page: Page;
let pages: Locator;

before(async () => {
  const scenario = {
    title: "The drive turns and reports a speed that it cannot have",
    units: [{ name: "drive", node_id: 5, config: { axes: [{ parameters: { p1120: 0.2 } }] } }],
    steps: [
      { nmt: "start" },
      { turn_on: 1 },
      { send: "305#0F0000008002", about: "600 rpm" },
      { expect: { signal: "1/speed", at_least: 590 }, within_ms: 20000 },
      { call: "fault.inject", params: { axis: 1, number: 7860 } },
      { expect: { signal: "1/speed", at_least: 5000 }, within_ms: 200 },
    ],
  };
  writeFileSync(join(folder, "trial.json"), JSON.stringify(scenario));
  const run = spawnSync(resolve(kBin, "axisctl"), ["run", "trial.json", "--html", folder], { cwd: folder, encoding: "utf8" });
  assert.equal(run.status, 11, run.stdout + run.stderr);
  browser = await openChromium();
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
  context.setDefaultTimeout(kPatience);
  page = await context.newPage();
  pages = page.getByRole("navigation", { name: "Pages" });
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) complaints.push(request.url());
  });
  await page.goto(`file://${join(folder, "trial.html")}`);
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
});

test("the verdict and its steps stand first", async () => {
  await page.getByText("The drive turns and reports a speed that it cannot have").first().waitFor();
  await page.getByText(/failed/i).first().waitFor();
});

test("the scope has signals, frames and events of the run", async () => {
  await pages.getByRole("link", { name: "Scope", exact: true }).click();
  await page.getByText(/1\/speed/).first().waitFor();
  await page.getByText(/F07860/).first().waitFor();
  await page.getByRole("button", { name: "Frames", exact: true }).click();
  await page.getByRole("button", { name: /TPDO/ }).first().waitFor();
});

test("every page has what was recorded, or says that it was not", async () => {
  for (const name of ["Overview", "State machine", "Parameters", "Objects", "Process data", "Hands", "Fleet"]) {
    await pages.getByRole("link", { name, exact: true }).click();
    await page.getByRole("heading", { level: 1 }).first().waitFor();
    const found = await new AxeBuilder({ page }).analyze();
    assert.deepEqual(found.violations.map((each) => each.id), [], name);
  }
  await pages.getByRole("link", { name: "Hands", exact: true }).click();
  await page.getByText("This is a recording: nothing can be changed.").first().waitFor();
});

test("nothing was asked of any server, and nothing complains", () => {
  assert.deepEqual(complaints, []);
});
