'use strict';
// A bus in user space: its hub, unless that runs already, and candump, which reads it.
const { execFile } = require('node:child_process');
const { EventEmitter } = require('node:events');
const { AxisdError, Refused } = require('./errors');
const { Fault } = require('./fault');
const { Program, find, within } = require('./programs');

const KEPT_FRAMES = 100000;
const TOLD_FRAMES = 20;
const LOOK_AGAIN = 5; // ms
const LINE = /^\((\d+\.\d+)\) \S+ ([0-9A-F]+)#(R\d?|[0-9A-F]*)$/;

/** A frame: `id`, `data` (Buffer), `extended`, `remote`, `time` (s since 1970). */
class Frame {
  constructor(line) {
    const [, time, id, data] = LINE.exec(line);
    this.id = parseInt(id, 16);
    this.extended = id.length > 3;
    this.remote = data.startsWith('R');
    this.data = Buffer.from(this.remote ? '' : data, 'hex');
    this.time = Number(time);
    this.text = `${id}#${data}`;
  }

  /** As cansend takes it: 185#3716. */
  toString() { return this.text; }
}

const hex = (id) => `${id.toString(16).toUpperCase().padStart(3, '0')}h`;

/** The bus of a unit. Emits `frame`. */
class Bus extends EventEmitter {
  /** Starts candump, with `hubOptions` the hub before it; ends with close(). */
  static async start(path, hubOptions, timeout) {
    const bus = new Bus(path, timeout);
    try {
      if (hubOptions) {
        bus.hub = new Program([find('canhub'), '--path', path, ...hubOptions]);
        await bus.hub.expect(/^canhub: ready/, timeout);
      }
      bus.reader = new Program([find('with-can'), '--bus', path, '--', find('candump'), '-L', 'vcan0']);
      bus.reader.on('output', (line) => LINE.test(line) && bus.take(new Frame(line)));
      await bus.readerHasJoined();
    } catch (error) {
      await bus.close();
      throw error;
    }
    return bus;
  }

  constructor(path, timeout) {
    super();
    this.setMaxListeners(0);
    this.path = path;
    this.timeout = timeout;
    this.frames = [];
    this.next = 0;
  }

  /** Sends a frame as cansend takes it: '205#0F00'. */
  send(frame) {
    return new Promise((done, fail) => {
      execFile(find('with-can'), ['--bus', this.path, '--', find('cansend'), 'vcan0', `${frame}`], (error, _, said) => {
        if (error) fail(new AxisdError(said.trim() || error.message));
        else done();
      });
    });
  }

  /** The next frame under `id` whose bytes begin with `data` (hexadecimal) and for which `where` holds; those before it are passed over. */
  async waitFor(id, { data = '', where = () => true, timeout = this.timeout } = {}) {
    const wanted = Buffer.from(data.replace(/\s/g, ''), 'hex');
    const accepts = (frame) => (id === undefined || frame.id === id) && frame.data.subarray(0, wanted.length).equals(wanted) && where(frame);
    const begin = this.next;
    const look = () => {
      while (this.next < this.frames.length) {
        const frame = this.frames[this.next];
        this.next += 1;
        if (accepts(frame)) return frame;
      }
      return undefined;
    };
    const found = look();
    if (found) return found;
    let take;
    const frame = new Promise((done, fail) => {
      take = () => { const got = look(); if (got) done(got); };
      this.on('frame', take);
      const server = this.hub ?? this.reader;
      server.hasEnded.then(() => fail(server.ended()));
    });
    return within(timeout, frame, () => {
      const seen = this.frames.slice(begin).slice(-TOLD_FRAMES).join(' ');
      return `a frame${id === undefined ? '' : ` ${hex(id)}`}${data ? ` with ${data}` : ''} has not come within ${timeout} ms; `
        + `${seen ? `seen last: ${seen}` : 'nothing came'}`;
    }).finally(() => this.off('frame', take));
  }

  /** Injects a fault of the bus (docs/reference/bus-faults.md): inject('bus.drop', { id: '0x185', times: 1 }). */
  async inject(kind, keys = {}) {
    const fault = { kind, ...keys };
    return new Fault(this, Number(await this.ask('--inject', JSON.stringify(fault))), fault);
  }

  /** The faults of the bus. */
  async faults() { return (await this.faultRows()).map((row) => new Fault(this, row.id, row.fault)); }

  async faultRows() { return JSON.parse(await this.ask('--injected', '--json')).faults; }

  async removeFault(id) { await this.ask('--take-back', `${id}`); }

  /** What canhub says of a running hub. */
  ask(...words) {
    return new Promise((done, fail) => {
      execFile(find('canhub'), ['--path', this.path, ...words], (error, text, said) => {
        if (error) fail(new Refused(said.trim().replace(/^canhub: /, '') || error.message, 'bad-parameter', {}));
        else done(text);
      });
    });
  }

  /** Passes over all frames so far. */
  skip() { this.next = this.frames.length; }

  /** The last frames, a line each: seconds since the first one, and the frame. */
  report(count = 20) {
    return this.frames.slice(-count).map((frame) => `${(frame.time - this.frames[0].time).toFixed(6).padStart(10)}  ${frame}`).join('\n');
  }

  async close() {
    await this.reader?.end();
    await this.hub?.end();
  }

  take(frame) {
    this.frames.push(frame);
    if (this.frames.length > KEPT_FRAMES) {
      this.frames.shift();
      this.next = Math.max(this.next - 1, 0);
    }
    this.emit('frame', frame);
  }

  /** Nothing tells that candump is there but the list of members. */
  async readerHasJoined() {
    const isThere = (text) => text.split('\n').some((row) => {
      const [, pid, interfaceName] = row.split(/\s+/);
      return Number(pid) === this.reader.process.pid && interfaceName === 'vcan0';
    });
    const end = Date.now() + this.timeout;
    for (;;) {
      const members = await this.ask('--status');
      if (isThere(members)) return;
      if (this.reader.how) throw this.reader.ended();
      if (Date.now() > end) throw new AxisdError(`candump has not joined the bus within ${this.timeout} ms`);
      await new Promise((done) => { setTimeout(done, LOOK_AGAIN); });
    }
  }
}

module.exports = { Bus, Frame };
