'use strict';
// A master of vcan0 with its view of node 5, which its EDS describes: the first argument of the program, if there is one.
// Needs the npm packages canopen and socketcan. Map PDOs to objects of local(), then start().
const { Device, Eds } = require('canopen');
const can = require('socketcan');

const NODE = 5;
const unit = Eds.fromFile(process.argv[2] || `${__dirname}/../../../eds/axisd.eds`);
const master = new Device({ id: 126 });
master.eds.addSdoClientParameter(NODE, 0x600 + NODE, 0x580 + NODE);
master.eds.addEmcyConsumer(0x080 + NODE);
const local = (index) => master.eds.addEntry(index, {
  parameterName: unit.getEntry(index).parameterName, dataType: unit.getEntry(index).dataType });

function start() {
  const channel = can.createRawChannel('vcan0');
  master.addListener('message', (frame) => channel.send(frame));
  channel.addListener('onMessage', (frame) => master.receive(frame));
  channel.start();
  master.start();
  master.emcy.on('emergency', ({ em }) => console.log('EMCY', em.code.toString(16), 'fault', em.info.readUInt16LE(0)));
}

module.exports = { NODE, unit, master, local, start };
