'use strict';

const { EventEmitter } = require('events');
const { socketcan } = require('./packages');

const SHOWN_ON_FAILURE = 40;

const hex = (number, digits) => number.toString(16).toUpperCase().padStart(digits, '0');

/** A frame as candump prints it. */
function candump(name, { id, data }) {
  const bytes = [...data].map((byte) => ` ${hex(byte, 2)}`).join('');
  return `${name}  ${hex(id, 3)}  [${data.length}]${bytes}`;
}

/** Opens a raw channel, or says how to get the interface. */
function openChannel(name) {
  try {
    return socketcan.createRawChannel(name);
  } catch (error) {
    throw new Error(`${name}: ${error.message}; make it with scripts/vcan-setup.sh, or run this in scripts/vcan-vm`);
  }
}

/**
 * A SocketCAN interface: what its device sends goes out, what comes in goes to the device and then, as the events
 * 'sent' and 'received', to whoever listens.
 */
class CanBus extends EventEmitter {
  constructor(name, { verbose = false } = {}) {
    super();
    this.name = name;
    this.verbose = verbose;
    this.history = [];
    this.tamper = (frame) => frame; // a test may change or drop (null) what its master sends
    this.channel = openChannel(name);
  }

  /** Connects the device of npm canopen. */
  attach(device) {
    device.addListener('message', (message) => {
      const frame = this.tamper(message);
      if (!frame) return;
      this._note('>', frame);
      this.channel.send({ id: frame.id, ext: false, rtr: false, data: frame.data });
      this.emit('sent', frame);
    });
    this.channel.addListener('onMessage', (frame) => {
      this._note('<', frame);
      device.receive(frame);
      this.emit('received', frame);
    });
    this.channel.start();
  }

  /** The last frames in both directions, for the message of a failure. */
  lastFrames() {
    return this.history.slice(-SHOWN_ON_FAILURE);
  }

  _note(direction, frame) {
    const line = `${direction} ${candump(this.name, frame)}`;
    this.history.push(line);
    if (this.history.length > 2 * SHOWN_ON_FAILURE) this.history.splice(0, SHOWN_ON_FAILURE);
    if (this.verbose) console.log(`  ${line}`);
  }
}

module.exports = { CanBus, hex };
