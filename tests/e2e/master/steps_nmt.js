'use strict';

const assert = require('assert');
const { nextEvent, equalHex } = require('./expect');

const HEARTBEAT = 50; // ms
const COMMUNICATION_FAULT = 0x1001; // error code of F08701

const setHeartbeat = (unit, milliseconds) => unit.set(0x1017, 0, milliseconds);

async function bootUp({ bootUp: frame }) {
  const { id, data } = await frame;
  assert.deepStrictEqual([...data], [0]);
  return `${id.toString(16)}h with 00`;
}

async function heartbeat({ unit }) {
  const came = unit.state('Pre-operational');
  await setHeartbeat(unit, HEARTBEAT);
  await came;
  const ended = nextEvent(unit.master.nmt, 'timeout', 'the end of the heartbeat');
  await setHeartbeat(unit, 0);
  await ended;
  const cameAgain = unit.state('Pre-operational');
  await setHeartbeat(unit, HEARTBEAT);
  await cameAgain;
  return 'comes with 1017h = 50, ends with 0, comes again with 50';
}

async function start({ unit }) {
  const operational = unit.state('Operational');
  unit.master.nmt.startNode(unit.id);
  await operational;
  return 'Operational';
}

async function stop({ unit }) {
  const stopped = unit.state('Stopped');
  unit.master.nmt.stopNode(unit.id);
  await stopped;
  return 'Stopped';
}

async function noSdoWhileStopped({ unit }) {
  const TIMEOUT = 0x05040000; // the master's own
  await unit.refused(unit.read(0x1000, 0, undefined, { timeout: 300 }), TIMEOUT, 'upload in Stopped');
  return 'no answer';
}

async function preOperational({ unit }) {
  const reached = unit.state('Pre-operational');
  unit.master.nmt.enterPreOperational(unit.id);
  await reached;
  equalHex(await unit.get(0x1003, 3), (8701 << 16) | COMMUNICATION_FAULT, '1003h:03'); // no EMCY leaves in Stopped
  await unit.acknowledge();
  return 'Pre-operational, F08701 in 1003h, acknowledged';
}

async function backFromOperational(context) {
  await start(context);
  const { unit } = context;
  const emergency = unit.emergency(COMMUNICATION_FAULT);
  const reached = unit.state('Pre-operational');
  unit.master.nmt.enterPreOperational(unit.id);
  await reached;
  const { em } = await emergency;
  assert.strictEqual(em.info.readUInt16LE(0), 8701, 'fault number');
  await unit.acknowledge();
  return 'Pre-operational, EMCY of F08701, acknowledged';
}

async function reset(unit, command) {
  const booted = unit.state('boot-up');
  unit.master.nmt[command](unit.id);
  await booted;
  assert.strictEqual(await unit.get(0x1017), 0, '1017h after the reset');
  return 'boot-up message, 1017h is 0 again';
}

async function resetCommunication({ unit }) {
  await unit.set(0x1801, 5, 250);
  const seen = await reset(unit, 'resetCommunication');
  assert.strictEqual(await unit.get(0x1801, 5), 0, '1801h:05 after the reset');
  return seen;
}

async function resetNode({ unit }) {
  const reached = unit.state('Pre-operational');
  await setHeartbeat(unit, HEARTBEAT);
  await reached;
  return reset(unit, 'resetNode');
}

module.exports = [
  { name: 'boot-up message', run: bootUp },
  { name: 'heartbeat', run: heartbeat },
  { name: 'NMT start', run: start },
  { name: 'NMT stop', run: stop },
  { name: 'SDO in Stopped', run: noSdoWhileStopped },
  { name: 'NMT pre-operational', run: preOperational },
  { name: 'NMT pre-operational from Operational', run: backFromOperational },
  { name: 'NMT reset communication', run: resetCommunication },
  { name: 'NMT reset node', run: resetNode },
];
