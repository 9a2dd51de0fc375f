'use strict';

const fs = require('fs');
const net = require('net');
const os = require('os');
const path = require('path');
const { nextEvent } = require('./expect');
const { Program } = require('./program');

/** Short ramps, and friction enough for the motor to coast to rest soon. */
const AXIS = { load: { friction: { coulomb: 2 } }, parameters: { p1120: 1, p1121: 1 } };

/** The built axisd, with a folder of its own for its state and its control socket. */
class Axisd {
  constructor(program, { canInterface, nodeId }) {
    this.folder = fs.mkdtempSync(path.join(os.tmpdir(), 'axisd-master-'));
    this.socket = path.join(this.folder, 'control.sock');
    const file = path.join(this.folder, 'axisd.json');
    fs.writeFileSync(file, JSON.stringify({ axes: [AXIS] }));
    // Under with-can the daemon joins the bus of the master's sockets by itself.
    const served = process.env.CAN_BUS ? `unix:${process.env.CAN_BUS}` : canInterface;
    this.program = new Program([program, '--interface', served, '--node-id', `${nodeId}`, '--config', file,
      '--state-directory', path.join(this.folder, 'state'), '--control', this.socket]);
  }

  get output() { return this.program.output; }

  /** One request over the control socket; resolves with its result. */
  async request(method, params) {
    const socket = net.connect(this.socket);
    const answer = nextEvent(socket, 'data', `the answer to ${method}`);
    socket.on('error', (error) => { this.program.output += `control socket: ${error.message}\n`; });
    socket.write(`${JSON.stringify({ id: 1, method, params })}\n`);
    const { result, error } = JSON.parse(await answer);
    socket.destroy();
    if (error) throw new Error(`${method}: ${error.message}`);
    return result;
  }

  end() { return this.program.end(); }

  /** Ends it if it still runs, and removes its folder. */
  cleanUp() {
    this.program.kill();
    fs.rmSync(this.folder, { recursive: true, force: true });
  }
}

module.exports = { Axisd };
