'use strict';
const fs = require('node:fs');
const { Bus } = require('./bus');
const { Control } = require('./control');
const { AxisdError, Ended, Timeout } = require('./errors');
const { Fault } = require('./fault');
const { Folder, Program, find, within } = require('./programs');

const NMT = { start: 1, stop: 2, 'pre-operational': 128, 'reset-node': 129, 'reset-communication': 130 };
const COMPARISONS = {
  lt: (a, b) => a < b, le: (a, b) => a <= b, eq: (a, b) => a === b, ne: (a, b) => a !== b, ge: (a, b) => a >= b, gt: (a, b) => a > b,
};
const KEYS = ['axes', 'config', 'inject', 'seed', 'nodeId', 'bus', 'bitRate', 'time', 'options', 'timeout'];
const WISHES = ['state', 'nmt', 'message', 'gone', 'value', 'frame'];
const STEPS = [[0x06, 'ready-to-switch-on'], [0x07, 'switched-on'], [0x0F, 'operation-enabled']];
const SAMPLE_MS = 5;
const LOOK_AGAIN = 5; // ms
const AXIS_OBJECTS = 0x800;
const HEARTBEAT = 0x700;
const REASONS = 2;

/** Letters and digits alone, so that 'operation-enabled' is 'Operation enabled'. */
const essence = (text) => text.toLowerCase().replace(/[^a-z0-9]/g, '');
const byte = (value) => value.toString(16).toUpperCase().padStart(2, '0');

/** The options of the hub of a private bus; in a time of its own the hub has a bit rate itself. */
function hubOptions({ bitRate, time }) {
  const rate = bitRate ?? (time ? undefined : 0);
  return [...(rate === undefined ? [] : ['--bitrate', `${rate}`]), ...(time ? ['--time', time] : [])];
}

/** A daemon and a bus of its own, from its boot-up to close(). */
class Unit {
  /** Starts one; the keys are those of index.d.ts. */
  static async start(keys = {}) {
    const wrong = Object.keys(keys).find((key) => !KEYS.includes(key));
    if (wrong) throw new TypeError(`Unit.start: expected keys, some of ${KEYS.join(', ')}; got ${wrong}`);
    const ofPrivateBus = ['bitRate', 'time'].find((key) => keys[key] !== undefined);
    if (keys.bus !== undefined && ofPrivateBus) throw new TypeError(`Unit.start: ${ofPrivateBus} is that of a private bus; bus has its own`);
    if (['virtual', 'stepped'].includes(keys.time))
      throw new TypeError(`Unit.start: time: expected real or scaled=K, got ${keys.time}; by it a test lives under with-can --time virtual`);
    const unit = new Unit(keys);
    try {
      await unit.begin(keys);
    } catch (error) {
      await unit.close();
      throw error;
    }
    return unit;
  }

  constructor({ nodeId = 5, seed, timeout = 10000 }) {
    this.nodeId = nodeId;
    this.seed = seed;
    this.timeout = timeout;
    this.events = [];
    this.folder = new Folder();
  }

  /** The result of a method of the control socket. */
  async call(method, params) {
    if (!this.control) throw await this.ended();
    return this.control.call(method, params);
  }

  status() { return this.call('status'); }

  async state(axis = 1) { return (await this.status()).axes[axis - 1].state; }

  /** Why an axis does not turn. */
  async explain(axis = 1) { return (await this.call('explain', { axis })).reasons; }

  /** A parameter: 'p1120', '1/r0063'. */
  async read(parameter) { return (await this.call('parameter.read', { parameters: [parameter] })).parameters[0].value; }

  async write(parameter, value) { await this.call('parameter.write', { parameter, value }); }

  async signal(name) { return (await this.call('signal.read', { signals: [name] })).signals[0].value; }

  /** Sends an NMT command: start, stop, pre-operational, reset-node, reset-communication. */
  nmt(command) {
    if (!NMT[command]) throw new TypeError(`command: expected one of ${Object.keys(NMT).join(', ')}; got "${command}"`);
    return this.bus.send(`000#${byte(NMT[command])}${byte(this.nodeId)}`);
  }

  /** Leads an axis to Operation enabled, where no master does. */
  async switchOn(axis = 1) {
    for (const [value, state] of STEPS) {
      await this.call('object.write', { index: (0x6040 + AXIS_OBJECTS * (axis - 1)).toString(16), value });
      await this.wait({ state, axis });
    }
  }

  /** Injects a fault, an object as in docs/reference/faults.md. */
  async inject(kind, keys = {}) {
    const fault = this.withSeed({ kind, ...keys });
    return new Fault(this, (await this.call('inject.add', fault)).id, fault);
  }

  /** The faults that are loaded. */
  async faults() { return (await this.faultRows()).map((row) => new Fault(this, row.id, row.fault)); }

  async faultRows() { return (await this.call('inject.list')).faults; }

  async removeFault(id) { await this.call('inject.remove', { id }); }

  /** Takes all faults back; how many there were. */
  async removeFaults() { return (await this.call('inject.remove')).removed; }

  /** Waits for one thing: state, nmt, message, gone, value (with lt, le, eq, ne, ge, gt) or frame (with data, where). */
  async wait(wish) {
    const wanted = WISHES.filter((name) => wish[name] !== undefined);
    if (wanted.length !== 1) throw new TypeError(`wait: expected one of ${WISHES.join(', ')}; got ${wanted.join(', ') || 'none'}`);
    const { timeout = this.timeout, axis = 1 } = wish;
    if (wish.frame !== undefined) return this.bus.waitFor(wish.frame, { data: wish.data, where: wish.where, timeout });
    if (wish.value !== undefined) return this.waitForValue(wish, timeout);
    if (wish.nmt !== undefined) {
      return this.waitFor(`NMT state ${wish.nmt}`, async () => (await this.status()).nmt_state, (seen) => essence(seen) === essence(wish.nmt),
        (event) => event.kind === 'nmt' && essence(event.state) === essence(wish.nmt), timeout);
    }
    if (wish.state !== undefined) {
      return this.waitFor(`state ${wish.state} of axis ${axis}`, () => this.state(axis), (seen) => essence(seen) === essence(wish.state),
        (event) => event.kind === 'drive-state' && event.axis === axis && essence(event.state) === essence(wish.state), timeout);
    }
    const code = wish.message ?? wish.gone;
    const isActive = wish.message !== undefined;
    return this.waitFor(isActive ? code : `the end of ${code}`,
      async () => (await this.call('fault.list')).messages.map((message) => message.code).join(' ') || 'no message',
      (seen) => seen.split(' ').includes(code) === isActive, (event) => event.name === code && event.active === isActive, timeout);
  }

  /** The last frames, the state of the unit, and the faults that are injected. */
  async report() {
    const [status, explanation, { faults }] = await Promise.all([this.status(), this.call('explain'), this.call('inject.list')]);
    return [
      `frames of ${this.bus.path}:`, this.bus.report(), `unit ${this.nodeId}: NMT state ${status.nmt_state}`,
      ...status.axes.flatMap((axis, at) => [
        `axis ${axis.axis}: ${axis.state}, controlword ${axis.controlword}, statusword ${axis.statusword}`,
        ...axis.faults.map(({ number, text }) => `  F${`${number}`.padStart(5, '0')} ${text}`),
        ...explanation.axes[at].reasons.slice(0, REASONS).map((reason) => `  ${reason}`)]),
      ...faults.map((row) => `injected ${row.id}: ${JSON.stringify(row.fault)}: ${row.state}, ${row.hits} hits, ${row.opportunities} opportunities`),
    ].join('\n');
  }

  /** Has the report written as a diagnostic of a test of node:test that fails: `await unit.watch(t, body)`. */
  async watch(t, body) {
    try {
      return await body(this);
    } catch (error) {
      t.diagnostic(await this.report().catch(({ message }) => message));
      throw error;
    }
  }

  /** Ends the daemon and its bus. */
  async close() {
    this.control?.close();
    this.eventSource?.close();
    this.control = undefined;
    await this.daemon?.end();
    this.daemon = undefined;
    await this.bus?.close();
    await this.folder.remove();
  }

  async begin({ axes = 1, config = {}, inject = [], bus, bitRate, time, options = [] }) {
    this.bus = await Bus.start(bus ?? this.folder.file('bus'), bus ? undefined : hubOptions({ bitRate, time }), this.timeout);
    const configuration = { axes: Array.isArray(axes) ? axes : Array.from({ length: axes }, () => ({})), ...config };
    if (inject.length) configuration.inject = inject.map((fault) => this.withSeed(fault));
    fs.writeFileSync(this.folder.file('axisd.json'), JSON.stringify(configuration));
    this.controlPath = this.folder.file('control');
    this.daemon = new Program([find('axisd'), '--config', this.folder.file('axisd.json'), '--interface', `unix:${this.bus.path}`,
      '--node-id', `${this.nodeId}`, '--control', this.controlPath, '--state-directory', this.folder.file('state'), ...options]);
    const bootUp = this.bootUp();
    await this.started(inject.length > 0);
    // Written before the notice, but candump tells it in its own time.
    if (!inject.length) await within(this.timeout, bootUp, () => 'the boot-up has not come');
    this.control = await this.connect();
    this.eventSource = await this.connect();
    this.eventSource.on('event', (event) => this.events.push(event));
    await this.eventSource.call('events.subscribe');
    process.env.CAN_BUS = this.bus.path; // where the CAN sockets of this process lead, if it runs under with-can
  }

  /** Resolves with the next boot-up message. */
  bootUp() {
    return new Promise((done) => {
      const look = (frame) => {
        if (frame.id !== HEARTBEAT + this.nodeId) return;
        this.bus.off('frame', look);
        done();
      };
      this.bus.on('frame', look);
    });
  }

  /** Resolves when it is ready; where faults may keep the boot-up back, when its node has left Initialising. */
  async started(maySilent) {
    const ready = this.daemon.expect(/^axisd: ready/, this.timeout).catch((error) => {
      const line = this.daemon.lines.at(-1);
      if (error instanceof Ended && this.daemon.status === 2 && line)
        throw new AxisdError(line.replace(/^axisd: /, '').replace(`${this.folder.file('axisd.json')}: `, 'configuration: '));
      throw error;
    });
    if (!maySilent) return ready;
    let isOver = false;
    const look = async () => {
      while (!isOver) {
        await new Promise((done) => { setTimeout(done, LOOK_AGAIN); });
        const control = await this.connect().catch(() => undefined);
        const status = await control?.call('status').catch(() => undefined);
        control?.close();
        if (status && status.nmt_state !== 'Initialising') return;
      }
    };
    return Promise.race([ready, look()]).finally(() => { isOver = true; ready.catch(() => {}); });
  }

  connect() { return Control.connect(this.controlPath, this.timeout, () => this.ended()); }

  /** The error that says why the daemon no longer answers; its log is complete when it has ended. */
  async ended() {
    const { control, daemon } = this;
    if (!daemon || (!control && !daemon.how)) return new Ended(`the unit with node-ID ${this.nodeId} was closed`);
    await within(this.timeout, daemon.hasEnded, () => '').catch(() => {});
    return daemon.ended();
  }

  withSeed(fault) { return fault.probability !== undefined && this.seed !== undefined ? { seed: this.seed, ...fault } : fault; }

  /** Resolves when what is `seen` holds, or with an event from now on that is the one. */
  async waitFor(what, see, holds, isIt, timeout) {
    let take;
    let end;
    const events = this.eventSource;
    const come = new Promise((done, fail) => {
      take = (event) => isIt(event) && done();
      end = async () => fail(await this.ended());
      events.on('event', take).on('end', end);
    });
    come.catch(() => {});
    try {
      if (holds(await see())) return;
      await within(timeout, come, () => what);
    } catch (error) {
      if (!(error instanceof Timeout)) throw error;
      const { axes } = await this.call('explain');
      throw new Timeout(`${what} has not come within ${timeout} ms; seen last: ${await see()}`
        + axes.map(({ axis, reasons }) => `; axis ${axis}: ${reasons[0]}`).join(''));
    } finally {
      events.off('event', take).off('end', end);
    }
  }

  async waitForValue(wish, timeout) {
    const [name, compare] = Object.entries(COMPARISONS).find(([key]) => wish[key] !== undefined) ?? [];
    if (!name) throw new TypeError(`wait: expected for a value one of ${Object.keys(COMPARISONS).join(', ')}`);
    let value = await this.signal(wish.value);
    if (compare(value, wish[name])) return value;
    const samples = await this.connect();
    try {
      const come = new Promise((done, fail) => {
        samples.on('sample', ({ values }) => { [value] = values; if (compare(value, wish[name])) done(value); });
        samples.once('end', async () => fail(await this.ended()));
      });
      come.catch(() => {});
      await samples.call('samples.subscribe', { signals: [wish.value], period_ms: SAMPLE_MS });
      return await within(timeout, come, () => `${wish.value} ${name} ${wish[name]} has not come within ${timeout} ms; it was ${value} last`);
    } finally {
      samples.close();
    }
  }
}

module.exports = { Unit };
