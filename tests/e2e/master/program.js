'use strict';

const { spawn } = require('child_process');
const { nextEvent } = require('./expect');

/** A program beside the test, with its output and its errors in one text. It ends with the test, however that ends. */
class Program {
  constructor(words, environment = {}) {
    this.output = '';
    this.process = spawn('setpriv', ['--pdeathsig', 'KILL', ...words], {
      stdio: ['ignore', 'pipe', 'pipe'],
      env: { ...process.env, ...environment },
    });
    for (const stream of [this.process.stdout, this.process.stderr])
      stream.on('data', (text) => { this.output += text; });
    this.process.on('exit', (status, signal) => { this.output += `(ended: ${signal || `status ${status}`})\n`; });
    this.process.on('error', (error) => { this.output += `${words[0]}: ${error.message}\n`; });
  }

  /** Sends SIGTERM and resolves with the exit status; null: a signal ended it. */
  async end() {
    if (this.process.exitCode !== null || this.process.signalCode !== null) return this.process.exitCode;
    const ended = nextEvent(this.process, 'exit', `the end of ${this.process.spawnargs.join(' ')}`);
    this.process.kill('SIGTERM');
    return ended;
  }

  kill() {
    this.process.kill('SIGKILL');
  }
}

module.exports = { Program };
