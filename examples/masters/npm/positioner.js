'use strict';
// Node 5 with "positioner": true and "positioner_wiring": "mdi": the words of its PDOs.
const { DataType } = require('canopen');
const { NODE, master, local, start } = require('./master');

const AXIS = 2;                                           // drive object
const PATIENCE = 20000;                                   // ms, for what has to come
const GAP = 10;                                           // ms between two frames of one PDO: the unit takes one every 4 ms

const [controlword, blocks, mode, override] = [0x6040, 0x5800, 0x5801, 0x5802].map(local);
const [position, velocity] = [0x5820, 0x5821].map(local);
const [acceleration, deceleration] = [0x5803, 0x5804].map(local);
const [statusword, blockState, motionState, overrideState] = [0x6041, 0x5810, 0x5811, 0x5812].map(local);
const [actualPosition, actualVelocity] = [0x5830, 0x606C].map(local);
const RECEIVED = [[controlword, blocks, mode, override], [position, velocity], [acceleration, deceleration]];
const SENT = [[statusword, blockState, motionState, overrideState], [actualPosition, actualVelocity]];
const CONTROL = 0x200 + NODE, SETPOINTS = 0x300 + NODE, SHARES = 0x400 + NODE;
RECEIVED.forEach((dataObjects, i) =>                      // 255: leave when the program sends them
  master.eds.addTransmitPdo({ cobId: CONTROL + 0x100 * i, transmissionType: 255, dataObjects }));
SENT.forEach((dataObjects, i) =>
  master.eds.addReceivePdo({ cobId: 0x180 + NODE + 0x100 * i, transmissionType: 254, dataObjects }));
start();

const signed = (word) => word << 16 >> 16;                // the free words are INTEGER16
const pause = (time) => new Promise((done) => setTimeout(done, time));
const send = async (cobId) => { master.pdo.write(cobId); await pause(GAP); };

/** Resolves as soon as @p holds of what the unit sends; @p what says what was waited for in vain. */
const until = (holds, what) => new Promise((done, fail) => {
  const end = (how, value) => { master.pdo.removeListener('pdo', look); clearTimeout(timer); how(value); };
  const look = () => holds() && end(done);
  const timer = setTimeout(() => end(fail, new Error(`waited in vain for ${what}`)), PATIENCE);
  master.pdo.on('pdo', look);
  look();
});

/** Parameter @p number of the axis. */
const parameter = (number, value, dataType, index = 0) => master.sdo.download({ serverId: NODE,
  index: 0x2000 + number, subIndex: index, data: value, dataType, timeout: 5000 });

/** Sets and clears bits of the controlword, POS_STW1 or POS_STW2, and sends them. */
async function command(word, { set = 0, clear = 0 }) {
  word.value = word === controlword ? word.value & ~clear | set : signed(word.value & ~clear | set);
  await send(CONTROL);
}

/** MDI velocity (1000 LU/min) and target (LU), accelerations at 100 %. */
async function setpoints(target, speed) {
  [position.value, velocity.value, acceleration.value, deceleration.value] = [target, speed, 0x4000, 0x4000];
  await Promise.all([send(SETPOINTS), send(SHARES)]);
}

/** Opens the window to the parameters of the axis and makes the unit Operational. */
async function begin() {
  await master.sdo.download({ serverId: NODE, index: 0x41B6, data: AXIS, dataType: DataType.UNSIGNED16, timeout: 5000 });
  master.nmt.startNode();
  master.nmt.startNode(NODE);
}

module.exports = { DataType, controlword, blocks, mode, override, statusword, blockState, motionState, actualPosition,
  actualVelocity, begin, command, parameter, setpoints, until };
