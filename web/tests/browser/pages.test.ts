// Every page: it is there, axe finds nothing, nothing is wider than the window, nothing complains on the console.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import { AxeBuilder } from "@axe-core/playwright";

import { Bench } from "./bench.ts";

const kPages = ["overview", "scope", "states", "parameters", "objects", "process-data", "hands", "fleet"];
let bench: Bench;

before(async () => {
  bench = await Bench.start();
});
after(() => bench.close());

for (const colorScheme of ["light", "dark"] as const)
  for (const size of [{ width: 1280, height: 800 }, { width: 390, height: 844 }])
    for (const name of kPages)
      test(`${name}, ${colorScheme}, ${size.width} wide`, async () => {
        const { page } = bench;
        await page.emulateMedia({ colorScheme });
        await page.setViewportSize(size);
        await bench.show(`#/${name}`);
        await page.waitForFunction(() => document.querySelector(".notice-error") === null);
        const found = await new AxeBuilder({ page }).analyze();
        const findings = found.violations.map((each) => `${each.id}: ${each.nodes.map((node) => node.html).join(" ")}`);
        assert.deepEqual(findings, []);
        const width = await page.evaluate(() => document.documentElement.scrollWidth);
        assert.ok(width <= size.width, `the page is ${width} wide`);
        assert.deepEqual(bench.complaints, []);
      });
