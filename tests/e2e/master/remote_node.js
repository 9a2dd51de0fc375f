'use strict';

const assert = require('assert');
const { Device, DataType } = require('./packages').canopen;
const { PATIENCE, nextEvent } = require('./expect');

const MASTER_ID = 126;
const HEARTBEAT_PATIENCE = 1000; // ms, of the master's heartbeat consumer

/** NMT states as heartbeats carry them. */
const STATE = { 0: 'boot-up', 4: 'Stopped', 5: 'Operational', 127: 'Pre-operational' };

/** The master of npm canopen, seen from what it wants of one remote node. */
class RemoteNode {
  constructor(bus, id) {
    this.bus = bus;
    this.id = id;
    this.master = new Device({ id: MASTER_ID });
    this.master.eds.addSdoClientParameter(id, 0x600 + id, 0x580 + id);
    this.master.eds.addHeartbeatConsumer(id, HEARTBEAT_PATIENCE);
    this.master.eds.addEmcyConsumer(0x080 + id);
    bus.attach(this.master);
    this.master.start();
  }

  /** Uploads an object; `dataType` as EDS files number them, absent: the bytes. */
  read(index, subIndex = 0, dataType = undefined, how = {}) {
    return this.master.sdo.upload({ serverId: this.id, index, subIndex, dataType, timeout: PATIENCE, ...how });
  }

  /** Downloads a value of `dataType`, or bytes. */
  write(index, subIndex, data, dataType = undefined, how = {}) {
    return this.master.sdo.download({
      serverId: this.id, index, subIndex, data, dataType, timeout: PATIENCE, ...how });
  }

  /** Fails unless the transfer is refused with this abort code. */
  async refused(transfer, code, what) {
    const error = await transfer.then(() => null, (reason) => reason);
    assert.ok(error, `${what}: was accepted`);
    const seen = typeof error.code === 'number' ? `${error.code.toString(16)}h` : error.message;
    assert.strictEqual(seen, `${code.toString(16)}h`, `${what}: ${seen} instead of ${code.toString(16)}h`);
  }

  /** Waits until the heartbeat consumer reports this NMT state as new. */
  state(name) {
    return nextEvent(this.master.nmt, 'heartbeat', `a heartbeat "${name}"`,
      ({ deviceId, state }) => deviceId === this.id && STATE[state] === name);
  }

  /** Waits for a frame of this identifier; any, or one whose bytes satisfy `matches`. */
  frame(id, matches = () => true) {
    return nextEvent(this.bus, 'received', `a frame ${id.toString(16)}h`, (f) => f.id === id && matches(f.data));
  }

  /** Waits for an emergency message with this error code. */
  emergency(code) {
    return nextEvent(this.master.emcy, 'emergency', `an EMCY ${code.toString(16)}h`, ({ em }) => em.code === code);
  }
}

module.exports = { RemoteNode, DataType };
