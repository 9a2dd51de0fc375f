'use strict';
// The control socket of a unit (docs/reference/control.md): a line of JSON each way.
const { EventEmitter, once } = require('node:events');
const net = require('node:net');
const { Refused } = require('./errors');
const { within } = require('./programs');

/** A connection. Emits `event` and `sample` when it has subscribed to them, and `end`. */
class Control extends EventEmitter {
  static async connect(path, timeout, ended) {
    const control = new Control(net.connect(path), timeout, ended);
    await once(control.socket, 'connect');
    return control;
  }

  constructor(socket, timeout, ended) {
    super();
    this.setMaxListeners(0);
    this.socket = socket;
    this.timeout = timeout;
    this.ended = ended;
    this.number = 0;
    this.asked = new Map();
    let rest = '';
    socket.setEncoding('utf8');
    socket.on('data', (text) => {
      const lines = (rest + text).split('\n');
      rest = lines.pop();
      lines.forEach((line) => this.take(JSON.parse(line)));
    });
    socket.on('error', () => {});
    socket.on('close', () => {
      this.isClosed = true;
      this.asked.forEach(async ({ fail }) => fail(await this.ended()));
      this.emit('end');
    });
  }

  /** The result of a method; rejects with Refused, Ended, Timeout. */
  async call(method, params = {}) {
    if (this.isClosed) throw await this.ended();
    this.number += 1;
    const id = this.number;
    const answer = new Promise((done, fail) => { this.asked.set(id, { method, done, fail }); });
    this.socket.write(`${JSON.stringify({ id, method, params })}\n`);
    return within(this.timeout, answer, () => `${method}: the unit has not answered within ${this.timeout} ms`)
      .finally(() => this.asked.delete(id));
  }

  close() { this.socket.destroy(); }

  take(line) {
    if (line.event) this.emit('event', line.event);
    if (line.sample) this.emit('sample', line.sample);
    const asked = this.asked.get(line.id);
    if (!asked) return;
    const { error, result } = line;
    if (error) asked.fail(new Refused(`${asked.method}: ${error.message}`, error.code, { ...error, ...error.details }));
    else asked.done(result);
  }
}

module.exports = { Control };
