'use strict';

/* Reads objects of node 5 by the npm packages canopen and socketcan: master.js EDS */

const { Device } = require('canopen');
const can = require('socketcan');

const NODE = 5;
const channel = can.createRawChannel('vcan0');
const master = new Device({ id: 126 });
master.eds.addSdoClientParameter(NODE, 0x600 + NODE, 0x580 + NODE);
master.addListener('message', (frame) => channel.send(frame));
channel.addListener('onMessage', (frame) => master.receive(frame));
channel.start();
master.start();

async function main() {
  for (let round = 0; round < 5; ++round) {
    for (const [index, subIndex] of [[0x1000, 0], [0x1018, 1]]) {
      await master.sdo.upload({ serverId: NODE, index, subIndex, timeout: 1000 });
    }
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
  channel.stop();
}

main().then(() => process.exit(0), (error) => {
  console.error(error);
  process.exit(1);
});
