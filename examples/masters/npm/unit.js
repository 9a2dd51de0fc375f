'use strict';
// Node 5 as delivered: RPDO 2 and TPDO 2 of its axis.
const { NODE, unit, master, local, start } = require('./master');

const [controlword, target, statusword, actual] = [0x6040, 0x60FF, 0x6041, 0x606C].map(local);
master.eds.addTransmitPdo({ cobId: 0x300 + NODE, transmissionType: 254, dataObjects: [controlword, target] });
master.eds.addReceivePdo({ cobId: 0x280 + NODE, transmissionType: 254, dataObjects: [statusword, actual] });
start();

module.exports = { NODE, unit, master, controlword, target, statusword, actual };
