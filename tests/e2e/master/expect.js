'use strict';

const assert = require('assert');

/** How long (ms) to wait for what should come at once; software emulation is slow. */
const PATIENCE = 20000;

/**
 * Waits for an event of which `matches` is true and resolves with what it carried. Call it before the action that
 * causes the event, await it afterwards.
 */
function nextEvent(emitter, event, what, matches = () => true) {
  const wait = new Promise((resolve, reject) => {
    const done = (settle, value) => {
      clearTimeout(timer);
      emitter.removeListener(event, listener);
      settle(value);
    };
    const listener = (value) => matches(value) && done(resolve, value);
    const timer = setTimeout(() => done(reject, new Error(`${what}: did not come`)), PATIENCE);
    emitter.addListener(event, listener);
  });
  wait.catch(() => {}); // an earlier failure of the step may leave it alone
  return wait;
}

/** Waits until `holds` returns true, which is asked now and after every event. */
function until(emitter, event, what, holds) {
  return holds() ? Promise.resolve() : nextEvent(emitter, event, what, () => holds());
}

/** Fails unless the two numbers are equal, and prints them in hexadecimal. */
function equalHex(actual, expected, what) {
  const text = (number) => `${number.toString(16).toUpperCase()}h`;
  assert.ok(actual === expected, `${what}: ${text(actual)} instead of ${text(expected)}`);
}

module.exports = { PATIENCE, nextEvent, until, equalHex };
