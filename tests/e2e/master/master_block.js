'use strict';

/*
 * An independent master (npm canopen) moves large values to and from a slave that serves SDO block transfer.
 *   node master_block.js --slave PROGRAM [--interface vcan0] [--verbose]
 * The slave is started as PROGRAM INTERFACE NODE-ID; its object 2001h is a DOMAIN that may be read and written.
 * --verbose prints every frame too. One line a step; exit status 0 if every step passed.
 */
const { CanBus } = require('./can_bus');
const { Program } = require('./program');
const { RemoteNode } = require('./remote_node');
const { options, runSteps } = require('./run_steps');

const NODE_ID = 11;

async function main() {
  const { slave, interface: canInterface, verbose } = options({
    slave: { type: 'string' },
    interface: { type: 'string', default: 'vcan0' },
    verbose: { type: 'boolean', default: false },
  });
  const bus = new CanBus(canInterface, { verbose });
  const node = new RemoteNode(bus, NODE_ID);
  const bootUp = node.frame(0x700 + NODE_ID);
  const program = new Program([slave, canInterface, `${NODE_ID}`]);
  const passed = await runSteps(require('./steps_block'), { bus, node, program, bootUp });
  program.kill();
  return passed ? 0 : 1;
}

main().then((status) => process.exit(status), (error) => {
  console.error(error);
  process.exit(1);
});
