'use strict';
// Simulated drive units for tests: const { Unit } = require('axisd'). See docs/how-to/fixtures.md.
module.exports = {
  ...require('./lib/errors'),
  ...require('./lib/bus'),
  ...require('./lib/fault'),
  ...require('./lib/unit'),
};
