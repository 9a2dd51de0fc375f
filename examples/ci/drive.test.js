'use strict';
// Tests of a CANopen master (npm canopen) against a simulated drive, each on a bus of its own: with-can -- node --test
const assert = require('node:assert');
const { spawn } = require('node:child_process');
const { once } = require('node:events');
const fs = require('node:fs');
const { after, before, test } = require('node:test');
const { Device } = require('canopen');
const can = require('socketcan');

const NODE = 5;
const folder = fs.mkdtempSync('/tmp/drive-');
process.env.CAN_BUS = `${folder}/bus`; // where the CAN sockets of this process lead

const channel = can.createRawChannel('vcan0');
const master = new Device({ id: 126 });
let drive;

before(async () => {
  master.eds.addSdoClientParameter(NODE, 0x600 + NODE, 0x580 + NODE);
  const bootUp = new Promise((done) => {
    channel.addListener('onMessage', ({ id }) => id === 0x700 + NODE && done());
  });
  master.addListener('message', (frame) => channel.send(frame));
  channel.addListener('onMessage', (frame) => master.receive(frame));
  channel.start();
  master.start();
  drive = spawn('axisd', ['--interface', `unix:${folder}/bus`, '--node-id', `${NODE}`, '--control', 'none',
    '--state-directory', folder], { stdio: 'ignore' });
  await bootUp;
});

after(async () => {
  channel.stop();
  drive.kill();
  const [status] = await once(drive, 'exit');
  assert.strictEqual(status, 0);
  fs.rmSync(folder, { recursive: true, force: true });
});

test('the device type is that of a drive', async () => {
  const type = await master.sdo.upload({ serverId: NODE, index: 0x1000, dataType: 7, timeout: 1000 });
  assert.strictEqual(type, 0xFFFF0192);
});

test('the statusword cannot be written', async () => {
  const write = master.sdo.download({ serverId: NODE, index: 0x6041, data: 1, dataType: 6, timeout: 1000 });
  await assert.rejects(write, ({ code }) => code === 0x06010002);
});
