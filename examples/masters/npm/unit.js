'use strict';
// A master of vcan0 with its view of node 5: the PDOs of its axis, and what its EDS says. The EDS is the first argument of
// the program, if there is one. Needs the npm packages canopen and socketcan.
const { Device, Eds } = require('canopen');
const can = require('socketcan');

const NODE = 5;
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

module.exports = { NODE, unit, master, controlword, target, statusword, actual };
