'use strict';

const assert = require('assert');
const { nextEvent } = require('./expect');
const { EVERY_SYNC, EVERY_SECOND_SYNC } = require('./steps_pdo');

const SYNC = 0x080;
const CYCLE = 20000; // us

/** Counts frames in both directions from now on. */
function countFrames(bus) {
  const counts = {};
  const count = ({ id }) => { counts[id] = (counts[id] || 0) + 1; };
  bus.addListener('sent', count);
  bus.addListener('received', count);
  return {
    of: (id) => counts[id] || 0,
    end: () => { bus.removeListener('sent', count); bus.removeListener('received', count); },
  };
}

/** The unit answers in order: what it sent for the SYNCs before is here when the answer is. */
const settle = (unit) => unit.get(0x1001);

async function singleSyncs({ unit, bus }) {
  unit.master.eds.setSyncCobId(SYNC);
  unit.master.eds.setSyncGenerationEnable(true);
  const frames = countFrames(bus);
  for (let i = 0; i < 6; ++i) {
    const answer = unit.frame(EVERY_SYNC);
    unit.master.sync.write();
    await answer;
  }
  await settle(unit);
  frames.end();
  assert.strictEqual(frames.of(EVERY_SYNC), 6, 'TPDOs of transmission type 1');
  assert.strictEqual(frames.of(EVERY_SECOND_SYNC), 3, 'TPDOs of transmission type 2');
  return '6 SYNCs: 6 TPDOs of type 1, 3 of type 2';
}

async function cyclicSyncs({ unit, bus }) {
  const frames = countFrames(bus);
  const positions = new Set();
  const enough = nextEvent(unit.master.pdo, 'pdo', 'ten positions in synchronous TPDOs', ({ cobId, dataObjects }) => {
    if (cobId === EVERY_SYNC) positions.add(dataObjects[0].value);
    return positions.size >= 10;
  });
  unit.master.eds.setSyncCyclePeriod(CYCLE);
  await enough;
  unit.master.eds.setSyncGenerationEnable(false);
  await settle(unit);
  frames.end();
  assert.strictEqual(frames.of(EVERY_SYNC), frames.of(SYNC), 'TPDOs of transmission type 1');
  return `${frames.of(SYNC)} SYNCs every 20 ms, as many TPDOs with ${positions.size} positions of the turning shaft`;
}

module.exports = [
  { name: 'SYNC, one by one', run: singleSyncs },
  { name: 'SYNC, cyclic', run: cyclicSyncs },
];
