// fgetc, getc, getchar, their unlocked forms, and what their macros call: __uflow, __underflow. And scanf, fscanf.
#include <cstdarg>
#include <cstdio>

#include "can/preload/calls/exported.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/calls/streams/filling.hpp"

namespace preload {

namespace {

int next_character_locked(FILE* stream) noexcept {
  flockfile(stream);
  const int character = next_character(stream);
  funlockfile(stream);
  return character;
}

}  // namespace

}  // namespace preload

using preload::by_turns;
using preload::may_fill;
using preload::real;

#undef fgetc
#undef getc
#undef getchar
#undef getc_unlocked
#undef getchar_unlocked
#undef fgetc_unlocked

PRELOAD_EXPORT int fgetc(FILE* stream) {
  return by_turns() ? preload::next_character_locked(stream) : real().fgetc(stream);
}

PRELOAD_EXPORT int getc(FILE* stream) {
  return by_turns() ? preload::next_character_locked(stream) : real().fgetc(stream);
}

PRELOAD_EXPORT int getchar() {
  return by_turns() ? preload::next_character_locked(stdin) : real().fgetc(stdin);
}

PRELOAD_EXPORT int getc_unlocked(FILE* stream) {
  return preload::next_character(stream);
}

PRELOAD_EXPORT int fgetc_unlocked(FILE* stream) {
  return preload::next_character(stream);
}

PRELOAD_EXPORT int getchar_unlocked() {
  return preload::next_character(stdin);
}

PRELOAD_EXPORT int __uflow(FILE* stream) {
  return may_fill(stream) ? real().uflow(stream) : EOF;
}

PRELOAD_EXPORT int __underflow(FILE* stream) {
  return may_fill(stream) ? real().underflow(stream) : EOF;
}

// Of these the first wait only is by turns: what they read is taken to come at once.

PRELOAD_EXPORT int __isoc99_fscanf(FILE* stream, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int fields = may_fill(stream) ? real().vfscanf(stream, format, arguments) : EOF;
  va_end(arguments);
  return fields;
}

PRELOAD_EXPORT int __isoc99_scanf(const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int fields = may_fill(stdin) ? real().vfscanf(stdin, format, arguments) : EOF;
  va_end(arguments);
  return fields;
}
