'use strict';
// Commissions the axis of node 5: rating plate in, motor and load measured, saved, turned; with the npm packages canopen
// and socketcan: node commission.js [EDS]
const { DataType } = require('canopen');
const { NODE, master, controlword, target, statusword, actual } = require('./unit');

const AXIS = 2, RPM_1000 = 69905067;                      // drive object; increments/s
const PLATE = { 304: 330, 305: 5.6, 307: 2.293, 310: 200, 311: 3000, 316: 1.37, 322: 7200, 323: 28 };
const ROTOR_INERTIA = 0.00151;                            // p0341, of the data sheet
const FOUND = { 316: 'Nm/A, torque constant', 342: 'x the motor inertia turn', 350: 'Ohm, stator resistance',
  356: 'mH, inductance', 1460: 'Nms/rad, speed controller', 1462: 'ms, its integral time' };

const write = (index, data, dataType, subIndex = 0) =>
  master.sdo.download({ serverId: NODE, index, subIndex, data, dataType, timeout: 5000 });
const number = (parameter, value) => write(0x2000 + parameter, value, DataType.INTEGER16);
const read = (parameter, dataType) =>
  master.sdo.upload({ serverId: NODE, index: 0x2000 + parameter, dataType, timeout: 5000 });
const until = (holds) => new Promise((done) => {
  const look = () => holds() && (master.pdo.removeListener('pdo', look), done());
  master.pdo.on('pdo', look);
  look();
});
const command = (word, state) => {
  controlword.value = word;
  return until(() => (statusword.value & 0x6F) === state);
};
const switchOn = async () => {                            // shutdown, switch on, enable operation
  for (const [word, state] of [[0x06, 0x21], [0x07, 0x23], [0x0F, 0x27]]) await command(word, state);
};

async function measure(parameter) {
  await number(parameter, 1);                             // A07991 or A07980 until it has been done
  await switchOn();                                       // the measurement leads now
  await until(() => (statusword.value & 0x4F) !== 0x07);  // at its end the pulses go off
  if (await read(parameter, DataType.INTEGER16) !== 0) throw new Error(`p${parameter} was not done`);
}

(async () => {
  await write(0x41B6, AXIS, DataType.UNSIGNED16);         // p8630: parameters of the axis
  await number(10, 3);                                    // p0010: commissioning of the motor
  for (const [parameter, value] of Object.entries(PLATE)) await write(0x2000 + +parameter, value, DataType.REAL32);
  await number(340, 1);                                   // calculates what follows from the plate
  await write(0x2000 + 341, ROTOR_INERTIA, DataType.REAL32);
  await number(340, 3);                                   // and the control with it
  await number(10, 0);
  master.nmt.startNode();
  master.nmt.startNode(NODE);
  await measure(1910);                                    // at standstill
  await measure(1960);                                    // turning
  for (const [parameter, what] of Object.entries(FOUND))
    console.log((await read(+parameter, DataType.REAL32)).toPrecision(3), what);
  await write(0x1010, Buffer.from('save'), undefined, 1);
  await switchOn();
  target.value = RPM_1000;
  await until(() => Math.abs(actual.value - RPM_1000) < RPM_1000 / 500);
  console.log('turns');
  await command(0x06, 0x21);                              // OFF1
  process.exit(0);
})().catch((error) => { console.error(error.message); process.exit(1); });
