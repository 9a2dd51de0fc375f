'use strict';

const path = require('path');
const { createRequire } = require('module');

const FOLDER = path.join(__dirname, '../../../build/master/'); // where scripts/setup.sh puts the packages

function load(name) {
  try {
    return createRequire(FOLDER)(name);
  } catch (error) {
    console.error(`the npm package ${name} cannot be loaded from ${FOLDER}: run scripts/setup.sh`);
    throw error;
  }
}

module.exports = { canopen: load('canopen'), socketcan: load('socketcan') };
