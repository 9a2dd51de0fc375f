// A gateway with --read-only: everything is shown, nothing can be done, and the page says why.
import { after, before, test } from "node:test";

import { Bench } from "./bench.ts";

let bench: Bench;

before(async () => {
  bench = await Bench.start({ readOnly: true });
});
after(() => bench.close());

test("hands are off and say why", async () => {
  const { page } = bench;
  await bench.show("#/hands");
  await page.getByText(/--read-only/).first().waitFor();
  await page.locator("button:disabled", { hasText: "Take the control" }).waitFor();
});

test("all the rest is there", async () => {
  const { page } = bench;
  await bench.show("#/overview");
  await page.getByText("Axis 1").first().waitFor();
  await bench.show("#/parameters?place=1&text=p1120");
  await page.getByText("RFG ramp-up time").first().waitFor();
});
