'use strict';

const { parseArgs } = require('util');

/**
 * Runs steps ({ name, run }) in their order, each with the context; prints one line a step with what `run` saw. The
 * first failure ends the run, for the later steps build on the earlier; false then.
 */
async function runSteps(steps, context) {
  for (const { name, run } of steps) {
    try {
      console.log(`ok      ${name}: ${await run(context)}`);
    } catch (error) {
      console.log(`FAILED  ${name}: ${error.message.split('\n')[0]}`);
      console.log(error.stack);
      console.log(['last frames (> sent, < received):', ...context.bus.lastFrames(), ''].join('\n'));
      if (context.program) console.log(`the program wrote:\n${context.program.output}`);
      return false;
    }
  }
  console.log(`${steps.length} steps passed`);
  return true;
}

/** The values of `--name value` and `--flag` in the command line. Ends the program if one is unknown or missing. */
function options(known) {
  try {
    const { values } = parseArgs({ options: known });
    const missing = Object.keys(known).find((name) => values[name] === undefined);
    if (missing) throw new Error(`--${missing} is missing`);
    return values;
  } catch (error) {
    console.error(error.message);
    process.exit(2);
  }
}

module.exports = { runSteps, options };
