'use strict';
const { AxisdError, Timeout } = require('./errors');

const LOOK_AGAIN = 10; // ms: nothing tells that a count has changed

/** A fault that was injected into a unit or its bus, `holder` (docs/reference/faults.md). */
class Fault {
  constructor(holder, id, fault) {
    this.holder = holder;
    this.id = id;
    this.kind = fault.kind;
    this.fault = fault;
  }

  /** Its row of inject.list: state, hits, opportunities, hit_at. */
  async row() {
    const row = (await this.holder.faultRows()).find(({ id }) => id === this.id);
    if (!row) throw new AxisdError(`fault ${this.id} (${this.kind}) is no longer there`);
    return row;
  }

  /** How often it has struck. */
  async hits() { return (await this.row()).hits; }

  /** waiting, active or over. */
  async state() { return (await this.row()).state; }

  /** Resolves when it has struck so often; rejects with Timeout. */
  async wait(hits = 1, timeout = this.holder.timeout) {
    const end = Date.now() + timeout;
    for (let row = await this.row(); row.hits < hits; row = await this.row()) {
      if (Date.now() >= end) throw new Timeout(`hit ${hits} of fault ${this.id} has not come within ${timeout} ms; it is ${row.state}, ${row.hits} hits`);
      await new Promise((done) => { setTimeout(done, LOOK_AGAIN); });
    }
  }

  /** Takes it back. */
  async remove() { await this.holder.removeFault(this.id); }
}

module.exports = { Fault };
