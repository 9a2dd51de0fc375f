'use strict';
// Turns the axis of node 5 to 3000 rpm and stops it again: node turn.js [EDS], with the npm packages canopen and socketcan
const { NODE, unit, master, controlword, target, statusword, actual } = require('./unit');

const RPM_3000 = 209715200;                               // increments/s

const read = (name) => master.sdo.upload({ serverId: NODE, timeout: 2000,
  index: unit.findEntry(name)[0].index, dataType: unit.findEntry(name)[0].dataType });
const until = (holds) => new Promise((done) => master.pdo.on('pdo', () => holds() && done()));

(async () => {
  console.log('device', await read('Manufacturer Device Name'), await read('Manufacturer Software Version'));
  master.nmt.startNode();                                 // the PDOs of the master
  master.nmt.startNode(NODE);                             // those of the unit
  for (const [word, state] of [[0x06, 0x21], [0x07, 0x23], [0x0F, 0x27]]) {
    controlword.value = word;                             // shutdown, switch on, enable operation
    await until(() => (statusword.value & 0x6F) === state);
  }
  target.value = RPM_3000;
  await until(() => Math.abs(actual.value - RPM_3000) < RPM_3000 / 1000);
  console.log('actual velocity', await read('Velocity Actual Value'));
  controlword.value = 0x06;                               // OFF1: ramp down
  await until(() => (statusword.value & 0x6F) === 0x21);
  process.exit(0);
})();
