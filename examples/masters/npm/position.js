'use strict';
// References the axis of node 5 and positions it: MDI, override, intermediate stop, traversing blocks, reject. The unit has
// "positioner": true and "positioner_wiring": "mdi": node position.js [EDS], with the npm packages canopen and socketcan.
const { DataType, controlword, blocks, mode, override, statusword, blockState, motionState, actualPosition,
  actualVelocity, begin, command, parameter, setpoints, until } = require('./positioner');

// 6040h
const ENABLED = 0x043F, NO_REJECT = 1 << 4, NO_STOP = 1 << 5, START = 1 << 6, REFERENCE = 1 << 11;
// 5800h and 5801h
const ABSOLUTE = 1 << 8, MDI = 1 << 15, TRACKING = 1 << 0;
// 6041h, 5810h (POS_ZSW1) and 5811h (POS_ZSW2)
const REACHED = 1 << 8, REFERENCED = 1 << 14, ACCEPTED = 1 << 15;
const BLOCK = 0x3F, IN_BLOCKS = 1 << 13;
const TRAVERSING = 1 << 15;
const WINDOW = 40;                                        // LU, p2544
const FULL = 0x4000;                                      // 100 %
const RPM = 69905;                                        // increments/s

// Number, task, mode, position (LU), parameter of each traversing block: tasks 1 POSITIONING, 5 WAIT; bits 4 to 7 of the
// mode 0 END, 1 CONTINUE_WITH_STOP, 2 CONTINUE_FLYING, bits 8 to 11 0 ABSOLUTE, 1 RELATIVE.
const BLOCKS = [[1, 1, 0x020, 50000, 0], [2, 1, 0x010, 20000, 0], [3, 5, 0x010, 0, 200], [4, 1, 0x100, 10000, 0]];
const VELOCITY = 6000;                                    // 1000 LU/min

const is = (word, bit) => (word.value & bit) !== 0;
const at = (target) => Math.abs(actualPosition.value - target) <= WINDOW;
function expect(holds, what) { if (!holds) throw new Error(`expected ${what}; the axis is at ${actualPosition.value}`); }

/** A rising edge of START, until the unit has taken it. */
async function start() {
  await command(controlword, { set: START });
  await until(() => is(statusword, ACCEPTED), 'bit 15 of 6041h');
  await command(controlword, { clear: START });
  await until(() => !is(statusword, ACCEPTED), 'the end of bit 15 of 6041h');
}
const reached = (target) => until(() => is(statusword, REACHED) && at(target), `position ${target}`);
async function move(target) {
  await setpoints(target, VELOCITY);
  await start();
}
/** Sends @p stop when the axis is @p way off @p target, and waits until it stands, which is before the target. */
async function stopShortOf(target, way, stop) {
  await until(() => Math.abs(actualPosition.value - target) < way, 'the motion');
  await stop();
  await until(() => Math.abs(actualVelocity.value) < RPM, 'standstill');
  expect(Math.abs(actualPosition.value - target) > WINDOW, `a stop before ${target}`);
}

async function prepare() {
  await parameter(2607, 0, DataType.UNSIGNED8);           // no reference cam: the next zero mark
  for (const [i, [number, task, taskMode, target, value]] of BLOCKS.entries()) {
    await parameter(2616, number, DataType.INTEGER16, i);
    await parameter(2617, target, DataType.INTEGER32, i);
    await parameter(2618, VELOCITY, DataType.INTEGER32, i);
    await parameter(2621, task, DataType.INTEGER16, i);
    await parameter(2622, value, DataType.INTEGER32, i);
    await parameter(2623, taskMode, DataType.UNSIGNED16, i);
  }
}

async function reference() {
  await command(controlword, { set: REFERENCE });
  await until(() => is(statusword, REFERENCED), 'bit 14 of 6041h');
  await command(controlword, { clear: REFERENCE });
  console.log('referenced');
}

async function mdi() {
  await command(blocks, { set: MDI | ABSOLUTE });
  await move(100000);
  await reached(100000);
  console.log('MDI: position 100000');

  await move(0);
  await stopShortOf(0, 80000, () => { override.value = 0; return command(blocks, {}); });
  expect(is(motionState, TRAVERSING), 'the task to wait for its override');
  override.value = FULL;
  await command(blocks, {});
  await reached(0);
  console.log('override 0 holds, 100 % goes on: position 0');

  await move(100000);
  await stopShortOf(100000, 80000, () => command(controlword, { clear: NO_STOP }));
  expect(is(motionState, TRAVERSING), 'the task to wait for the end of the stop');
  await command(controlword, { set: NO_STOP });
  await reached(100000);
  console.log('intermediate stop and on: position 100000');
}

async function chain() {
  await command(blocks, { clear: 0xFFFF, set: BLOCKS[0][0] });
  const passed = new Set();
  await start();
  await until(() => {
    if (is(blockState, IN_BLOCKS) && is(blockState, BLOCK)) passed.add(blockState.value & BLOCK);
    return !is(motionState, TRAVERSING) && is(statusword, REACHED) && at(30000);
  }, 'the end of the last block at position 30000');
  expect([...passed].join() === '1,2,3,4', `blocks 1,2,3,4 and not ${[...passed]}`);
  console.log('blocks 1 to 4: position 30000');
}

async function reject() {
  await command(blocks, { clear: 0xFFFF, set: MDI | ABSOLUTE });
  await move(-100000);
  await stopShortOf(-100000, 120000, () => command(controlword, { clear: NO_REJECT }));
  await until(() => !is(motionState, TRAVERSING), 'the end of the task');
  await command(controlword, { set: NO_REJECT });
  console.log('reject: no task is left');
}

(async () => {
  await begin();
  await prepare();
  override.value = FULL;
  await command(mode, { set: TRACKING });
  for (const [word, state] of [[0x043E, 0x21], [ENABLED, 0x27]]) {
    await command(controlword, { clear: 0xFFFF, set: word });
    await until(() => (statusword.value & 0x6F) === state, `state ${state.toString(16)}h`);
  }
  for (const step of [reference, mdi, chain, reject]) await step();
  await command(controlword, { clear: 0xFFFF, set: 0x0406 });
  await until(() => (statusword.value & 0x6F) === 0x21, 'OFF1');
  process.exit(0);
})().catch((error) => { console.error(error.message); process.exit(1); });
