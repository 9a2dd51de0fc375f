'use strict';

/*
 * An independent master (npm canopen) drives the built axisd over a CAN interface, or under with-can over its bus.
 *   node master.js --axisd PROGRAM --eds FILE [--interface vcan0] [--verbose]
 * --verbose prints every frame too. One line a step; exit status 0 if every step passed.
 */
const assert = require('assert');
const { CanBus } = require('./can_bus');
const { Axisd } = require('./axisd');
const { DriveUnit } = require('./drive_unit');
const { options, runSteps } = require('./run_steps');
const pdo = require('./steps_pdo');

const NODE_ID = 5;

async function powerOff({ program }) {
  assert.strictEqual(await program.end(), 0, 'exit status');
  return 'SIGTERM, exit status 0';
}

const STEPS = [
  ...require('./steps_nmt'),
  ...require('./steps_sdo'),
  ...pdo.steps,
  ...require('./steps_sync'),
  ...require('./steps_emcy'),
  ...pdo.lastSteps,
  { name: 'power-off', run: powerOff },
];

async function main() {
  const { axisd, eds, interface: canInterface, verbose } = options({
    axisd: { type: 'string' },
    eds: { type: 'string' },
    interface: { type: 'string', default: 'vcan0' },
    verbose: { type: 'boolean', default: false },
  });
  const bus = new CanBus(canInterface, { verbose });
  const unit = new DriveUnit(bus, NODE_ID, eds);
  const bootUp = unit.frame(0x700 + NODE_ID);
  const program = new Axisd(axisd, { canInterface, nodeId: NODE_ID });
  const passed = await runSteps(STEPS, { bus, unit, program, bootUp });
  program.cleanUp();
  return passed ? 0 : 1;
}

main().then((status) => process.exit(status), (error) => {
  console.error(error);
  process.exit(1);
});
