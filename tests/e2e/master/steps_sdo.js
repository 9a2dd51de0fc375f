'use strict';

const assert = require('assert');
const { equalHex } = require('./expect');
const { DataType } = require('./remote_node');

const TARGET_VELOCITY = 0x60FF;
const WRONG_LENGTH = 0x06070010;

/** What each request must be refused with: [what, the transfer, abort code]. */
const REFUSALS = [
  ['upload of an object that is not there', (unit) => unit.read(0x1F00, 0), 0x06020000],
  ['upload of a sub-index that is not there', (unit) => unit.read(0x1018, 5), 0x06090011],
  ['download to a read-only object', (unit) => unit.write(0x1000, 0, 1, DataType.UNSIGNED32), 0x06010002],
  ['download of a value above the limit', (unit) => unit.set(0x605D, 0, 4), 0x06090031],
  ['download of a value below the limit', (unit) => unit.set(0x605D, 0, -2), 0x06090032],
  ['download of too few bytes', (unit) => unit.write(TARGET_VELOCITY, 0, Buffer.from([1, 2])), WRONG_LENGTH],
  ['mapping of a PDO that is valid', (unit) => unit.set(0x1A00, 1, 0x606C0020), 0x08000022],
];

async function uploadIdentity({ unit }) {
  equalHex(await unit.get(0x1000), 0xFFFF0192, '1000h');
  const identity = await Promise.all([1, 2, 3, 4].map((sub) => unit.get(0x1018, sub)));
  equalHex(identity[0], 0x06000053, '1018h:01');
  equalHex(identity[1], 0x5000, '1018h:02');
  return `1000h FFFF0192h, 1018h ${identity.map((value) => `${value.toString(16)}h`).join(' ')}`;
}

async function download({ unit }) {
  for (const value of [123456789, -1, 0]) {
    await unit.set(TARGET_VELOCITY, 0, value);
    assert.strictEqual(await unit.get(TARGET_VELOCITY), value, '60FFh read back');
  }
  return '60FFh takes 123456789, -1 and 0';
}

async function uploadStrings({ unit }) {
  const segmented = unit.frame(0x580 + unit.id, (data) => (data[0] & 0xE2) === 0x40);
  assert.strictEqual(await unit.get(0x1008), 'SINAMICS');
  await segmented;
  assert.strictEqual(await unit.get(0x6504), 'SIEMENS');
  return `1008h "SINAMICS", 100Ah "${await unit.get(0x100A)}"`;
}

async function downloadTooLong({ unit }) {
  await unit.refused(unit.write(TARGET_VELOCITY, 0, Buffer.from('too long')), WRONG_LENGTH, '8 bytes to 60FFh');
  assert.strictEqual(await unit.get(TARGET_VELOCITY), 0, '60FFh after the refusal');
  return '8 bytes to 60FFh: 06070010h, and the value stays';
}

async function refusals({ unit }) {
  const codes = [];
  for (const [what, transfer, code] of REFUSALS) {
    await unit.refused(transfer(unit), code, what);
    codes.push(`${code.toString(16).padStart(8, '0').toUpperCase()}h`);
  }
  equalHex(await unit.get(0x1000), 0xFFFF0192, '1000h after the refusals');
  return codes.join(' ');
}

module.exports = [
  { name: 'SDO expedited upload', run: uploadIdentity },
  { name: 'SDO expedited download', run: download },
  { name: 'SDO segmented upload', run: uploadStrings },
  { name: 'SDO segmented download, refused', run: downloadTooLong },
  { name: 'SDO abort codes', run: refusals },
];
