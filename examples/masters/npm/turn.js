'use strict';
// Turns the axis of node 5 to 3000 rpm and stops it again: node turn.js [EDS], with the npm packages canopen and socketcan
const { Device, Eds } = require('canopen');
const can = require('socketcan');

const NODE = 5, RPM_3000 = 209715200;                     // increments/s
const unit = Eds.fromFile(process.argv[2] || `${__dirname}/../../../eds/axisd.eds`);
const master = new Device({ id: 126 });
master.eds.addSdoClientParameter(NODE, 0x600 + NODE, 0x580 + NODE);
master.eds.addEmcyConsumer(0x080 + NODE);
const local = (index) => master.eds.addEntry(index, {
  parameterName: unit.getEntry(index).parameterName, dataType: unit.getEntry(index).dataType });
const [controlword, target, statusword, actual] = [0x6040, 0x60FF, 0x6041, 0x606C].map(local);
master.eds.addTransmitPdo({ cobId: 0x300 + NODE, transmissionType: 254, dataObjects: [controlword, target] });
master.eds.addReceivePdo({ cobId: 0x280 + NODE, transmissionType: 254, dataObjects: [statusword, actual] });

const channel = can.createRawChannel('vcan0');
master.addListener('message', (frame) => channel.send(frame));
channel.addListener('onMessage', (frame) => master.receive(frame));
channel.start();
master.start();
master.emcy.on('emergency', ({ em }) => console.log('EMCY', em.code.toString(16), 'fault', em.info.readUInt16LE(0)));

const read = (name) => master.sdo.upload({ serverId: NODE, timeout: 1000,
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
