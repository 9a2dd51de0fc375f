'use strict';

/** Anything that this package throws by itself. */
class AxisdError extends Error {
  get name() { return this.constructor.name; }
}

/** A program was not found. */
class Missing extends AxisdError {}

/** A daemon or hub has ended although it is needed; the message has the last lines of its log. */
class Ended extends AxisdError {}

/** The unit has refused a request; `code` as in docs/reference/control.md, `details` what else the answer has. */
class Refused extends AxisdError {
  constructor(message, code, details) {
    super(message);
    this.code = code;
    this.details = details;
  }
}

/** Something has not come in time; the message says what was awaited and what was seen last. */
class Timeout extends AxisdError {}

module.exports = { AxisdError, Missing, Ended, Refused, Timeout };
