// What a person does who has never seen candump: starts a drive, sees it turn, breaks it, finds out why, and changes a parameter.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import { Bench } from "./bench.ts";

let bench: Bench;

before(async () => {
  bench = await Bench.start();
  bench.cansend("000#0105");
  await bench.show("#/overview");
});
after(() => bench.close());

test("a wrong token is said to be wrong, and what was typed stays", async () => {
  const { page } = bench;
  await bench.giveToken("0123456789abcdef0123456789abcdef");
  await page.getByText("The token is wrong").first().waitFor();
  const field = page.getByLabel("Token", { exact: true });
  assert.equal(await field.inputValue(), "0123456789abcdef0123456789abcdef");
  await field.fill(bench.token);
  await page.getByRole("button", { name: "Use it" }).click();
  await page.getByRole("button", { name: "Token: right" }).waitFor();
});

test("hands turn the motor", async () => {
  const { page } = bench;
  await bench.show("#/hands");
  const take = page.getByRole("button", { name: "Take the control" });
  const enable = page.getByRole("button", { name: "Enable" });
  const isTurning = async (): Promise<boolean> => {
    const isTaken = await take.isDisabled();
    if (!isTaken) await take.click();
    if (!isTaken || await enable.isEnabled()) await enable.click();
    await page.getByText("Operation enabled").first().waitFor({ timeout: 5000 });
    const setpoint = page.getByLabel("rpm", { exact: true });
    await setpoint.fill("600");
    await setpoint.press("Enter");
    bench.axisctl("wait", "value", "1/speed", "ge", "590", "--timeout", "5");
    return true;
  };
  // A page that gets no processor for a while is silent, and then the axis stops: it has to be enabled again.
  for (let tries = 0; tries < 8 && !(await isTurning().catch(() => false)); ++tries);
  bench.axisctl("wait", "value", "1/speed", "ge", "590", "--timeout", "5");
});

test("the state machine shows where the axis is", async () => {
  const { page } = bench;
  const other = await page.context().newPage();
  await other.goto(`${bench.url}#/states`);
  await other.getByText("Operation enabled").first().waitFor();
  await other.getByText("here").first().waitFor();
  await other.close();
});

test("a fault is put in by hand, and its cause found by three clicks from the overview", async () => {
  const { page } = bench;
  await page.getByLabel("Fault or alarm").fill("7860");
  await page.getByRole("button", { name: "Make it occur" }).click();
  await page.getByText("F07860").first().waitFor();
  await page.getByRole("link", { name: "Overview", exact: true }).click(); // 1
  await page.getByRole("link", { name: /F07860/ }).first().click(); // 2: the scope shows what it was and why
  const detail = page.getByLabel("What was chosen");
  await detail.getByRole("heading", { name: /F07860/ }).waitFor();
  await detail.getByText(/fault\.inject/).first().waitFor();
  await detail.getByText(/Fault/).first().waitFor();
});

test("a frame is decoded by the EDS", async () => {
  const { page } = bench;
  await bench.show("#/scope?signals=1/speed");
  await page.reload();
  await page.getByRole("button", { name: "Frames", exact: true }).click();
  await page.getByLabel("Service").selectOption("SDO");
  const request = page.getByRole("button", { name: /605#4041600000000000/ }).first();
  for (let tries = 0; tries < 20 && !(await request.isVisible()); ++tries) {
    bench.cansend("605#4041600000000000"); // until the page listens
    await request.waitFor({ timeout: 1000 }).catch(() => undefined);
  }
  await request.click();
  await page.getByLabel("What was chosen").getByText(/Statusword/).first().waitFor();
});

test("a parameter is written, and one is refused in words", async () => {
  const { page } = bench;
  await bench.show("#/parameters?place=1&text=p1120&show=1/p1120");
  const value = page.getByRole("textbox", { name: /p1120|New value|Value/ }).last();
  await value.fill("2.5");
  await value.press("Enter");
  bench.axisctl("wait", "value", "1/p1120", "eq", "2.5", "--timeout", "30");
  await value.fill("-1");
  await value.press("Enter");
  await page.getByText(/below the minimum/).first().waitFor();
  assert.equal(await value.inputValue(), "-1");
});

test("what the hands have sent stands in the list of events", async () => {
  const { page } = bench;
  await bench.show("#/overview");
  await page.getByText(/fault\.inject/).first().waitFor();
  await page.getByText(/panel\.take/).first().waitFor();
});
