'use strict';

const assert = require('assert');
const { equalHex } = require('./expect');
const { switchOn, turn } = require('./steps_pdo');

const FAULT = 7860;
const DRIVE_OBJECT = 2;
const GENERIC_AND_MANUFACTURER = 0x81;
const ACKNOWLEDGE = 0x80;

async function inject({ unit, program }) {
  const emergency = unit.emergency(0x1000);
  await program.request('fault.inject', { axis: 1, number: FAULT });
  const { cobId, em } = await emergency;
  equalHex(cobId, 0x080 + unit.id, 'COB-ID');
  equalHex(em.register, GENERIC_AND_MANUFACTURER, 'error register');
  assert.deepStrictEqual([em.info.readUInt16LE(0), em.info[2]], [FAULT, DRIVE_OBJECT], 'fault and drive object');
  await unit.driveState('Fault');
  return `code 1000h, register 81h, F0${FAULT} on drive object ${DRIVE_OBJECT}; the drive is in Fault`;
}

async function errorField({ unit }) {
  equalHex(await unit.get(0x1001), GENERIC_AND_MANUFACTURER, '1001h');
  assert.strictEqual(await unit.get(0x1003, 0), 1, '1003h:00');
  equalHex(await unit.get(0x1003, 1), (DRIVE_OBJECT << 16) | 0x1000, '1003h:01');
  assert.strictEqual(await unit.get(0x1003, 2), 1, 'faults of the axis in 1003h:02');
  equalHex(await unit.get(0x1003, 3), (FAULT << 16) | 0x1000, '1003h:03');
  return '1001h 81h, 1003h:01 00021000h, 1003h:03 1EB41000h';
}

async function acknowledge({ unit }) {
  const emergency = unit.emergency(0);
  unit.local(0x6040).value = ACKNOWLEDGE;
  await emergency;
  await unit.driveState('Switch on disabled');
  assert.strictEqual(await unit.get(0x1003, 0), 0, '1003h:00');
  equalHex(await unit.get(0x1001), 0, '1001h');
  return 'EMCY 0000h, Switch on disabled, 1003h is empty';
}

async function turnAgain(context) {
  await switchOn(context);
  return turn(context);
}

module.exports = [
  { name: 'EMCY of an injected fault', run: inject },
  { name: 'error register and error field', run: errorField },
  { name: 'acknowledgement by the controlword', run: acknowledge },
  { name: 'PDO to the drive: turn again', run: turnAgain },
];
