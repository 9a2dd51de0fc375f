'use strict';

const assert = require('assert');
const { equalHex } = require('./expect');
const { FULL_SPEED } = require('./drive_unit');

const INVALID = 0x80000000;
const NO_RTR = 0x40000000;
const EVENT = 254;

/** COB-IDs outside the predefined connection set, so that nothing passes by being left as it was. */
const COMMAND = 0x325;
const STATUS = 0x2A5;
const EVERY_SYNC = 0x3A5;
const EVERY_SECOND_SYNC = 0x4A5;

/** The unit's PDOs: communication parameter, COB-ID, transmission type, inhibit time (100 us), mapped objects. */
const PDOS = [
  { index: 0x1401, cobId: COMMAND, type: EVENT, mapping: [0x60FF0020, 0x60400010] },
  { index: 0x1801, cobId: STATUS, type: EVENT, inhibit: 200, mapping: [0x606C0020, 0x60410010, 0x60770010] },
  { index: 0x1802, cobId: EVERY_SYNC, type: 1, mapping: [0x60630020, 0x606B0020] },
  { index: 0x1803, cobId: EVERY_SECOND_SYNC, type: 2, mapping: [0x60610008, 0x60410010] },
];
const UNUSED = [0x1400, 0x1402, 0x1403, 0x1800];

async function invalidate(unit, index) {
  const value = await unit.get(index, 1);
  await unit.set(index, 1, (value | INVALID) >>> 0);
}

async function configurePdo(unit, { index, cobId, type, inhibit, mapping }) {
  await invalidate(unit, index);
  await unit.set(index + 0x200, 0, 0);
  for (const [i, entry] of mapping.entries()) await unit.set(index + 0x200, i + 1, entry);
  await unit.set(index + 0x200, 0, mapping.length);
  await unit.set(index, 2, type);
  if (inhibit) await unit.set(index, 3, inhibit);
  await unit.set(index, 1, index < 0x1800 ? cobId : cobId + NO_RTR);
}

async function checkPdo(unit, { index, cobId, type, mapping }) {
  equalHex((await unit.get(index, 1)) & 0x800007FF, cobId, `${index.toString(16)}h:01`);
  assert.strictEqual(await unit.get(index, 2), type);
  for (const [i, entry] of mapping.entries())
    equalHex(await unit.get(index + 0x200, i + 1), entry, `${(index + 0x200).toString(16)}h:0${i + 1}`);
}

async function configure({ unit }) {
  for (const index of UNUSED) await invalidate(unit, index);
  for (const pdo of PDOS) await configurePdo(unit, pdo);
  for (const pdo of PDOS) await checkPdo(unit, pdo);
  return `${PDOS.length} PDOs on 325h, 2A5h, 3A5h, 4A5h, read back`;
}

async function connect({ unit }) {
  for (const { cobId, mapping } of PDOS) {
    const kind = cobId === COMMAND ? 'Transmit' : 'Receive';
    unit.addPdo(kind, cobId, mapping.map((entry) => entry >>> 16));
  }
  unit.master.nmt.startNode(); // the master's own PDOs
  unit.master.nmt.startNode(unit.id);
  return unit.driveState('Switch on disabled');
}

async function switchOn({ unit }) {
  const way = [[0x06, 'Ready to switch on'], [0x07, 'Switched on'], [0x0F, 'Operation enabled']];
  for (const [controlword, state] of way) {
    unit.local(0x6040).value = controlword; // npm canopen sends it at once
    await unit.driveState(state);
  }
  return way.map(([, state]) => state).join(', ');
}

async function turn({ unit }) {
  const speed = () => unit.local(0x606C).value;
  unit.local(0x60FF).value = FULL_SPEED;
  await unit.processData('3000 rpm within 0.1 %', () => Math.abs(speed() - FULL_SPEED) <= FULL_SPEED / 1000);
  const seen = `606Ch ${speed()} in a TPDO for 60FFh ${FULL_SPEED} in an RPDO`;
  const overSdo = await unit.get(0x606C);
  assert.ok(Math.abs(overSdo - FULL_SPEED) <= FULL_SPEED / 100, `606Ch over SDO: ${overSdo}`);
  return seen;
}

async function brake({ unit }) {
  unit.local(0x6040).value = 0x06;
  await unit.driveState('Ready to switch on');
  assert.ok(Math.abs(unit.local(0x606C).value) < FULL_SPEED / 100, `606Ch ${unit.local(0x606C).value}`);
  return 'OFF1 leads to Ready to switch on at standstill';
}

module.exports = {
  EVERY_SYNC,
  EVERY_SECOND_SYNC,
  switchOn,
  turn,
  steps: [
    { name: 'PDO configuration', run: configure },
    { name: 'PDO from the drive', run: connect },
    { name: 'PDO to the drive: switch on', run: switchOn },
    { name: 'PDO to the drive: turn', run: turn },
  ],
  lastSteps: [{ name: 'PDO to the drive: brake', run: brake }],
};
