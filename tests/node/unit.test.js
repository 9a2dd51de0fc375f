'use strict';
// The package of Node: node --test, with NODE_PATH at the folder that has it.
const assert = require('node:assert');
const { spawn } = require('node:child_process');
const { once } = require('node:events');
const fs = require('node:fs');
const path = require('node:path');
const { test } = require('node:test');
const { Ended, Refused, Timeout, Unit } = require('axisd');

/** A test with a unit of its own. */
const withUnit = (name, keys, body) => test(name, async (t) => {
  const unit = await Unit.start(keys);
  try {
    await unit.watch(t, body);
  } finally {
    await unit.close();
  }
});

withUnit('answers on its bus', {}, async (unit) => {
  assert.strictEqual(`${await unit.bus.waitFor()}`, '705#00');
  await unit.bus.send('605#4000100000000000');
  assert.strictEqual(`${await unit.wait({ frame: 0x585 })}`, '585#430010009201FFFF');
  assert.strictEqual(process.env.CAN_BUS, unit.bus.path);
});

withUnit('turns and trips', { axes: [{ parameters: { p1120: 0.5 } }] }, async (unit) => {
  await unit.nmt('start');
  await unit.wait({ nmt: 'operational' });
  await unit.switchOn();
  await unit.bus.send('305#0F000000800C');
  assert.ok(await unit.wait({ value: '1/speed', ge: 2990 }) >= 2990);
  await unit.call('fault.inject', { axis: 1, number: 7860 });
  await unit.wait({ message: 'F07860' });
  await unit.wait({ state: 'fault' });
  await unit.call('fault.ack', { axis: 1 });
  await unit.wait({ gone: 'F07860' });
  assert.strictEqual(await unit.read('1/p1120'), 0.5);
});

withUnit('misbehaves on demand', { axes: 2, nodeId: 9, seed: 7 }, async (unit) => {
  assert.strictEqual((await unit.status()).axes.length, 2);
  const fault = await unit.inject('sdo.abort', { code: '0x08000000', object: '0x1000', times: 1 });
  await unit.bus.send('609#4000100000000000');
  assert.strictEqual(`${await unit.wait({ frame: 0x589 })}`, '589#8000100000000008');
  await fault.wait(1);
  assert.strictEqual(await fault.state(), 'over');
  await fault.remove();
  assert.deepStrictEqual(await unit.faults(), []);
  await assert.rejects(unit.inject('sdo.abrot'), (error) => error instanceof Refused && /expected sdo.deaf/.test(error.message));
  assert.strictEqual((await unit.inject('sdo.silent', { probability: 0.5 })).fault.seed, 7);
  assert.match(await unit.report(), /boot|709#00[^]*injected 2: .*"kind":"sdo.silent"/);
});

withUnit('loses an answer on its bus', {}, async (unit) => {
  const fault = await unit.bus.inject('bus.drop', { id: '0x585', times: 1 });
  await unit.bus.send('605#4000100000000000');
  await fault.wait(1);
  assert.strictEqual(await fault.state(), 'over');
  await unit.bus.send('605#4000100000000000');
  await unit.wait({ frame: 0x585 });
  await fault.remove();
  assert.deepStrictEqual(await unit.bus.faults(), []);
  await assert.rejects(unit.bus.inject('bus.drip'), (error) => error instanceof Refused && /expected bus.drop/.test(error.message));
});

withUnit('is there without its boot-up', { inject: [{ kind: 'boot-up.missing' }] }, async (unit) => {
  assert.deepStrictEqual(unit.bus.frames, []);
  assert.strictEqual(await (await unit.faults())[0].hits(), 1);
});

withUnit('tells what it has awaited and what it saw', {}, async (unit) => {
  if (unit.bus.frames.length === 0) await once(unit.bus, 'frame'); // its boot-up
  await assert.rejects(unit.wait({ state: 'operation-enabled', timeout: 10 }), (error) => error instanceof Timeout
    && /^state operation-enabled of axis 1 has not come within 10 ms; seen last: Switch on disabled; axis 1: /.test(error.message));
  await assert.rejects(unit.wait({ frame: 0x199, timeout: 10 }),
    { message: 'a frame 199h has not come within 10 ms; seen last: 705#00' });
  await assert.rejects(unit.wait({}), /expected one of state, nmt, message, gone, value, frame; got none/);
  assert.throws(() => unit.nmt('fly'), /expected one of start, stop,/);
});

test('says in one line why it does not start', async () => {
  await assert.rejects(Unit.start({ config: { axis: 1 } }), /^AxisdError: configuration: \/axis: unknown key, expected one of/);
  await assert.rejects(Unit.start({ axles: 1 }), /expected keys, some of axes, .* got axles/);
  await assert.rejects(Unit.start({ time: 'stepped' }), /expected real or scaled=K, got stepped/);
  await assert.rejects(Unit.start({ bus: '/nowhere', bitRate: 125000 }), /bitRate is that of a private bus/);
});

withUnit('tells the log of a daemon that has ended', {}, async (unit) => {
  unit.daemon.process.kill('SIGKILL');
  await assert.rejects(unit.wait({ nmt: 'stopped' }), (error) => error instanceof Ended && /^axisd was ended by SIGKILL; its log: /.test(error.message));
});

test('leaves nothing, whatever ends its process', async () => {
  const script = `const { Unit } = require('axisd');
    Unit.start().then((unit) => console.log(unit.daemon.process.pid, unit.bus.hub.process.pid, unit.folder.path));`;
  const child = spawn(process.execPath, ['-e', script], { stdio: ['ignore', 'pipe', 'inherit'] });
  const [text] = await once(child.stdout.setEncoding('utf8'), 'data');
  const [daemon, hub, folder] = text.trim().split(' ');
  const isThere = (pid) => { // one that has ended stays as Z until somebody asks
    try {
      return !/\) Z/.test(fs.readFileSync(`/proc/${pid}/stat`, 'utf8'));
    } catch {
      return false;
    }
  };
  assert.ok(isThere(daemon) && isThere(hub) && fs.existsSync(path.join(folder, 'bus')));
  child.kill('SIGKILL');
  const end = Date.now() + 20000;
  while (isThere(daemon) || isThere(hub) || fs.existsSync(folder)) {
    assert.ok(Date.now() < end, 'something is left');
    await new Promise((done) => { setTimeout(done, 10); });
  }
});
