// Makes the pictures of docs/how-to/page/, on the bus of with-can: node tests/browser/pictures.ts
import { mkdirSync } from "node:fs";
import { fileURLToPath } from "node:url";

import { Bench } from "./bench.ts";

const kFolder = fileURLToPath(new URL("../../../docs/how-to/page/", import.meta.url));
/** From the standstill to 3000 rpm: shutdown, switch on, enable operation, target velocity. */
const kStart = ["205#0600", "205#0700", "205#0F00", "305#0F000000800C"];

mkdirSync(kFolder, { recursive: true });
const axis = { name: "X", parameters: { p1120: 1, p1121: 0.5 } };
const bench = await Bench.start({ config: { axes: [axis, { name: "Y" }] }, viewport: { width: 1280, height: 760 } });
const { page } = bench;
const pause = (ms: number): Promise<void> => page.waitForTimeout(ms);
const picture = (name: string): Promise<Buffer> => page.screenshot({ path: `${kFolder}${name}.png` });

bench.cansend("000#0105");
await bench.show("#/overview");
await bench.giveToken();
await bench.show("#/scope?signals=1/speed,1/speed_setpoint,1/torque,1/current");
await pause(1500);
for (const frame of kStart) {
  bench.cansend(frame);
  await pause(200);
}
await pause(2500);
bench.axisctl("load", "1", "6");
await pause(1000);
bench.cansend("605#4041600000000000");
bench.axisctl("fault", "inject", "1", "7860");
await pause(1500);
await page.getByRole("button", { name: /F07860/ }).first().click();
await pause(700);
await picture("scope");
bench.axisctl("load", "1", "0");
for (const [name, hash] of [
  ["overview", "#/overview"],
  ["states", "#/states"],
  ["parameters", "#/parameters?place=1&text=p0840&show=1/p0840"],
  ["objects", "#/objects?text=60"],
  ["process-data", "#/process-data"],
  ["hands", "#/hands"],
  ["fleet", "#/fleet"],
] as const) {
  await bench.show(hash);
  await pause(1500);
  await picture(name);
}
await bench.close();
