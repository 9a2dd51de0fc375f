'use strict';
// The master of bench/time_cost.py: turns the axes of node 5 on vcan0 and sends a SYNC every 100 ms.
// hour.js AXES SECONDS; prints JSON. Needs the npm packages canopen and socketcan.
const { Device } = require('canopen');
const can = require('socketcan');

const NODE = 5, PERIOD = 100, TIMEOUT = 5000;             // ms
const OBJECTS_OF_AXIS = 0x800, PDOS_OF_AXIS = 0x40;
const INVALID = 0xC0000000, NO_REMOTE_FRAME = 0x40000000, SYNCHRONOUS = 1;
// What the predefined connection set gives to PDOs of a node: one TPDO of each axis has one of these.
const IDENTIFIERS = [0x180, 0x280, 0x380, 0x480, 0x200, 0x300, 0x400, 0x500];
const [axes, seconds] = process.argv.slice(2).map(Number);

const master = new Device({ id: 126 });
master.eds.addSdoClientParameter(NODE, 0x600 + NODE, 0x580 + NODE);
const channel = can.createRawChannel('vcan0');
const heard = { syncs: 0, pdos: 0, frames: 0 };
const send = (id, bytes) => channel.send({ id, data: Buffer.from(bytes) });
const pause = (ms) => new Promise((done) => setTimeout(done, ms));

async function write(index, subIndex, size, value) {
  const data = Buffer.alloc(size);
  data.writeUIntLE(value, 0, size);
  await master.sdo.download({ serverId: NODE, index, subIndex, data, timeout: TIMEOUT });
}

async function mapAll() {
  for (const [direction, identifier] of [[0x1400, 0x200], [0x1800, 0x180]])
    for (let number = 0; number < 4; ++number)
      await write(direction + number, 1, 4, INVALID + identifier + 0x100 * number + NODE);
  for (let axis = 0; axis < axes; ++axis) {
    const communication = 0x1800 + PDOS_OF_AXIS * axis;
    await write(communication, 2, 1, SYNCHRONOUS);
    await write(communication, 1, 4, NO_REMOTE_FRAME + IDENTIFIERS[axis] + NODE);
  }
}

async function turnAll() {
  for (const word of [0x06, 0x07, 0x0F]) {
    for (let axis = 0; axis < axes; ++axis) await write(0x6040 + OBJECTS_OF_AXIS * axis, 0, 2, word);
    await pause(500);
  }
  for (let axis = 0; axis < axes; ++axis)
    await write(0x60FF + OBJECTS_OF_AXIS * axis, 0, 4, 70000000 + 1000000 * axis);
}

(async () => {
  channel.addListener('onMessage', (frame) => {
    ++heard.frames;
    if (frame.id !== 0x580 + NODE && frame.id !== 0x700 + NODE && frame.id !== 0x080 + NODE) ++heard.pdos;
    master.receive(frame);
  });
  master.addListener('message', (frame) => channel.send(frame));
  channel.start();
  master.start();
  await mapAll();
  send(0, [1, NODE]);
  await turnAll();
  const begin = Date.now();
  const timer = setInterval(() => {
    if (Date.now() - begin < 1000 * seconds) { send(0x080, []); ++heard.syncs; return; }
    clearInterval(timer);
    console.log(JSON.stringify({ ...heard, milliseconds: Date.now() - begin }));
    process.exit(0);
  }, PERIOD);
})().catch((error) => { console.error(error.message); process.exit(1); });
