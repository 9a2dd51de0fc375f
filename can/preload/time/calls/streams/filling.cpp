#include "can/preload/time/calls/streams/filling.hpp"

#include <sys/stat.h>

#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/wait/readiness.hpp"

namespace preload {

namespace {

bool is_empty(const FILE* stream) noexcept {
  return stream->_IO_read_ptr >= stream->_IO_read_end;
}

void set_error(FILE* stream) noexcept {
  constexpr int kError = 0x20;  // _IO_ERR_SEEN
  stream->_flags |= kError;
}

}  // namespace

bool may_wait_within(FILE* stream) noexcept {
  struct stat status {};
  if (!by_turns() || fileno_unlocked(stream) < 0) return false;
  return fstat(fileno_unlocked(stream), &status) == 0 && !S_ISREG(status.st_mode);
}

bool may_fill(FILE* stream) noexcept {
  if (!by_turns() || !is_empty(stream) || !may_wait_within(stream) || feof_unlocked(stream)) return true;
  if (may_read(fileno_unlocked(stream))) return true;
  set_error(stream);
  return false;
}

int next_character(FILE* stream) noexcept {
  return may_fill(stream) ? real().getc_unlocked(stream) : EOF;
}

}  // namespace preload
