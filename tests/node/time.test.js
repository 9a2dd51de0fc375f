'use strict';
// A unit on the bus of the test, in whose virtual time the test itself lives: with-can --private --time virtual -- node --test
const assert = require('node:assert');
const { test } = require('node:test');
const { Unit } = require('axisd');

const HEARTBEAT = 0x705;

test('beats for a minute, exactly', async (t) => {
  const unit = await Unit.start({ bus: process.env.CAN_BUS });
  await unit.watch(t, async () => {
    await unit.call('object.write', { index: '1017', value: 1000 });
    unit.bus.skip();
    const first = await unit.wait({ frame: HEARTBEAT });
    const begin = Date.now();
    let beat = first;
    for (let count = 0; count < 60; ++count) beat = await unit.wait({ frame: HEARTBEAT });
    assert.strictEqual((beat.time - first.time).toFixed(6), '60.000000');
    assert.ok(Math.abs(Date.now() - begin - 60000) <= 1);
  }).finally(() => unit.close());
});
