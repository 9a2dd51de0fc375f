'use strict';

const assert = require('assert');
const { Eds } = require('./packages').canopen;
const { until } = require('./expect');
const { RemoteNode } = require('./remote_node');

/** CiA 402 states: which bits of the statusword tell, and what they are. */
const DRIVE_STATES = {
  'Switch on disabled': { mask: 0x4F, bits: 0x40 },
  'Ready to switch on': { mask: 0x6F, bits: 0x21 },
  'Switched on': { mask: 0x6F, bits: 0x23 },
  'Operation enabled': { mask: 0x6F, bits: 0x27 },
  Fault: { mask: 0x4F, bits: 0x08 },
};

/** Increments/s at 3000 rpm. */
const FULL_SPEED = 0x0C800000;

/** A remote node whose names and data types come from its EDS file, with PDOs between it and the master. */
class DriveUnit extends RemoteNode {
  constructor(bus, id, edsFile) {
    super(bus, id);
    this.eds = Eds.fromFile(edsFile);
  }

  /** The object's description in the EDS. */
  entry(index, subIndex = 0) {
    const entry = this.eds.getEntry(index);
    return entry.subNumber ? entry.at(subIndex) : entry;
  }

  /** Uploads an object in its data type. */
  get(index, subIndex = 0) {
    return this.read(index, subIndex, this.entry(index, subIndex).dataType);
  }

  /** Downloads a value in the object's data type. */
  set(index, subIndex, value) {
    return this.write(index, subIndex, value, this.entry(index, subIndex).dataType);
  }

  /** The master's own copy of a process object: what it sends in its TPDOs, and what came in its RPDOs. */
  local(index) {
    const { parameterName, dataType } = this.entry(index);
    return this.master.eds.getEntry(index) || this.master.eds.addEntry(index, { parameterName, dataType });
  }

  /** Gives the master a PDO (kind: 'Receive' or 'Transmit') of these objects. */
  addPdo(kind, cobId, indices) {
    const dataObjects = indices.map((index) => this.local(index));
    this.master.eds[`add${kind}Pdo`]({ cobId, transmissionType: 254, dataObjects }); // 255 would never leave
  }

  /** Waits until what the PDOs brought satisfies `holds`. */
  processData(what, holds) {
    return until(this.master.pdo, 'pdo', what, holds);
  }

  /** Waits until the statusword in the PDOs stands for this CiA 402 state. */
  async driveState(name) {
    const { mask, bits } = DRIVE_STATES[name];
    await this.processData(name, () => (this.local(0x6041).value & mask) === bits);
    return name;
  }

  /** Acknowledges all faults by 1003h:00, and fails if one is left. */
  async acknowledge() {
    await this.set(0x1003, 0, 0);
    assert.strictEqual(await this.get(0x1003, 0), 0, 'errors that are left in 1003h');
  }
}

module.exports = { DriveUnit, FULL_SPEED };
