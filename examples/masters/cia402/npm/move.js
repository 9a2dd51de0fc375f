'use strict';
// Homes the axis of node 5, which has "profile": "cia402", and positions it: node move.js [EDS]
const { TARGET, mode, target, statusword, shownMode, read, write, until, command, begin } = require('./axis');

const REVOLUTION = 65536;                                 // position units, as delivered
const POSITION = 1, HOMING = 6;                           // modes
const INDEX_POSITIVE = 34;                                // homing method: the next index in positive direction
const ENABLE = 0x0F, START = 0x10;                        // 6040h
const REACHED = 1 << 10, ACKNOWLEDGED = 1 << 12, ATTAINED = 1 << 12, ERROR = 1 << 13; // 6041h

const is = (bits) => (statusword.value & bits) === bits;

async function select(wanted) {
  mode.value = wanted;
  command(ENABLE);
  await until(() => shownMode.value === wanted, `mode ${wanted}`);
}

async function home() {
  await write(0x6098, INDEX_POSITIVE);
  await write(0x6099, REVOLUTION, 2);
  await select(HOMING);
  command(ENABLE | START);
  await until(() => !is(REACHED), 'the start of homing');
  await until(() => is(ERROR) || is(ATTAINED | REACHED), 'the end of homing');
  if (is(ERROR)) throw new Error('homing has failed');
  command(ENABLE);
  console.log('homed');
}

async function move(revolutions) {
  target.value = revolutions * REVOLUTION;
  command(ENABLE | START, TARGET);
  await until(() => is(ACKNOWLEDGED), 'bit 12 of 6041h');
  command(ENABLE, TARGET);
  await until(() => !is(ACKNOWLEDGED) && is(REACHED), `position ${revolutions}`);
  console.log('position', (await read(0x6064) / REVOLUTION).toFixed(2));
}

(async () => {
  console.log('device', await read(0x1008));
  await write(0x6081, 10 * REVOLUTION);
  begin();
  for (const [word, state] of [[0x06, 0x21], [0x07, 0x23], [ENABLE, 0x27]]) {
    command(word);
    await until(() => (statusword.value & 0x6F) === state, `state ${state.toString(16)}h`);
  }
  await home();
  await select(POSITION);
  for (const revolutions of [10, -2]) await move(revolutions);
  command(0x06);
  await until(() => (statusword.value & 0x6F) === 0x21, 'Ready to switch on');
  process.exit(0);
})().catch((error) => { console.error(error.message); process.exit(1); });
