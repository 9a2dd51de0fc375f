// What goes wrong around the page: said in words at the place, and nothing lost.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { writeFileSync } from "node:fs";

import { Bench } from "./bench.ts";

let bench: Bench;

before(async () => {
  bench = await Bench.start();
});
after(() => bench.close());

test("a daemon that stops and comes back", async () => {
  const { page } = bench;
  await bench.show("#/parameters?place=1&text=p1120&show=1/p1120");
  await page.getByText("RFG ramp-up time").first().waitFor();
  await bench.unit.end();
  await page.getByText(/cannot be reached|No answer|no unit|no-daemon|not/i).first().waitFor();
  await bench.startUnit(5, { axes: [{ name: "X" }] });
  await bench.show("#/overview");
  await bench.untilUnitIsThere();
  await page.getByText("Axis 1").first().waitFor();
});

test("a gateway that is gone leaves the last picture, and is told from the moment it is back", async () => {
  const { page } = bench;
  await bench.show("#/overview");
  await bench.untilUnitIsThere();
  await page.getByText("Axis 1").first().waitFor();
  await bench.gateway.end();
  await page.getByRole("alert").getByText(/No answer: axisd-http/).waitFor();
  assert.ok(await page.getByText("Axis 1").first().isVisible());
  await bench.startGateway();
  await page.getByRole("alert").waitFor({ state: "detached" });
});

test("a damaged file is refused with what was expected", async () => {
  const { page } = bench;
  const path = bench.path("damaged.axrec");
  writeFileSync(path, "AXISREC\n\u0001\u0000\u0000\u0000 nonsense");
  await bench.show("#/scope");
  const chooser = page.waitForEvent("filechooser");
  await page.getByRole("button", { name: /Open file/ }).click();
  await (await chooser).setFiles(path);
  await page.getByText(/damaged\.axrec/).first().waitFor();
});

test("a slow network makes no pile of requests", async () => {
  const { page } = bench;
  let open = 0;
  let most = 0;
  await page.route("**/api/v1/overview", async (route) => {
    most = Math.max(most, ++open);
    await new Promise((done) => setTimeout(done, 1500));
    await route.continue();
    --open;
  });
  const answers = Promise.all([1, 2].map(() => page.waitForResponse(/overview/)));
  await bench.show("#/overview");
  await answers;
  await page.waitForResponse(/overview/);
  assert.equal(most, 1);
  await page.unroute("**/api/v1/overview");
});

test("what is written before the last answer has come is written after it, and what is typed stays", async () => {
  const { page } = bench;
  await bench.show("#/overview");
  await bench.giveToken();
  await bench.show("#/parameters?place=1&text=p1120&show=1/p1120");
  let writes = 0;
  await page.route("**/api/v1/**/parameters/**", async (route) => {
    if (route.request().method() === "PUT") {
      ++writes;
      await new Promise((done) => setTimeout(done, 1000));
    }
    await route.continue();
  });
  const value = page.getByRole("textbox", { name: /^Value/ });
  for (const text of ["2.5", "3.5"]) {
    await value.fill(text);
    await value.press("Enter");
    await value.press("Enter");
  }
  await value.fill("4.5");
  await page.getByText("2.5 was written.").waitFor();
  assert.equal(await value.inputValue(), "4.5");
  await page.getByText("3.5 was written.").waitFor();
  bench.axisctl("wait", "value", "1/p1120", "eq", "3.5", "--timeout", "30");
  assert.equal(await value.inputValue(), "4.5");
  assert.equal(writes, 2);
  await page.unroute("**/api/v1/**/parameters/**");
});
