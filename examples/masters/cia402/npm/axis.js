'use strict';
// Node 5 with "profile": "cia402": a master of vcan0, the PDOs that the program sends and takes, and what it waits for. The EDS
// is the first argument of the program, if there is one. Needs the npm packages canopen and socketcan.
const { Device, Eds } = require('canopen');
const can = require('socketcan');

const NODE = 5;
const PATIENCE = 20000;                                   // ms, for what has to come
const unit = Eds.fromFile(process.argv[2] || `${__dirname}/../../../../eds/axisd-cia402.eds`);
const master = new Device({ id: 126 });
master.eds.addSdoClientParameter(NODE, 0x600 + NODE, 0x580 + NODE);
master.eds.addEmcyConsumer(0x080 + NODE);
const local = (index) => master.eds.addEntry(index, {
  parameterName: unit.getEntry(index).parameterName, dataType: unit.getEntry(index).dataType });

// As delivered: RPDO 2 and 3, TPDO 2 and 3. Type 255: they leave when the program sends them.
const [controlword, mode, target] = [0x6040, 0x6060, 0x607A].map(local);
const [statusword, shownMode, position] = [0x6041, 0x6061, 0x6064].map(local);
const MODE = 0x300 + NODE, TARGET = 0x400 + NODE;
master.eds.addTransmitPdo({ cobId: MODE, transmissionType: 255, dataObjects: [controlword, mode] });
master.eds.addTransmitPdo({ cobId: TARGET, transmissionType: 255, dataObjects: [controlword, target] });
master.eds.addReceivePdo({ cobId: 0x280 + NODE, transmissionType: 254, dataObjects: [statusword, shownMode] });
master.eds.addReceivePdo({ cobId: 0x380 + NODE, transmissionType: 254, dataObjects: [statusword, position] });

const channel = can.createRawChannel('vcan0');
master.addListener('message', (frame) => channel.send(frame));
channel.addListener('onMessage', (frame) => master.receive(frame));
channel.start();
master.start();
master.emcy.on('emergency', ({ em }) => console.log('EMCY', em.code.toString(16)));

/** An object of the unit over SDO, by its index and sub-index. */
const entry = (index, subIndex) => (subIndex === undefined ? unit.getEntry(index) : unit.getEntry(index)[subIndex]);
const read = (index) => master.sdo.upload({ serverId: NODE, timeout: 2000, index, dataType: entry(index).dataType });
const write = (index, data, subIndex) => master.sdo.download({ serverId: NODE, timeout: 2000, index, subIndex, data,
  dataType: entry(index, subIndex).dataType });

/** Resolves as soon as @p holds of what the unit sends; @p what says what was waited for in vain. */
const until = (holds, what) => new Promise((done, fail) => {
  const end = (how, value) => { master.pdo.removeListener('pdo', look); clearTimeout(timer); how(value); };
  const look = () => holds() && end(done);
  const timer = setTimeout(() => end(fail, new Error(`waited in vain for ${what}`)), PATIENCE);
  master.pdo.on('pdo', look);
  look();
});

/** Sends the controlword, with the mode or with the target. */
function command(word, cobId = MODE) {
  controlword.value = word;
  master.pdo.write(cobId);
}

function begin() {
  master.nmt.startNode();                                 // the PDOs of the master
  master.nmt.startNode(NODE);                             // those of the unit
}

module.exports = { TARGET, mode, target, statusword, shownMode, position, read, write, until, command, begin };
