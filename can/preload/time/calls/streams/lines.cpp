// fdopen, fgets, getline, getdelim, fread, their unlocked forms, and what a fortified program calls in their
// place.
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "can/preload/calls/exported.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/calls/streams/filling.hpp"
#include "can/preload/time/turn/touch.hpp"

namespace preload {

namespace {

char* read_line(char* line, int room, FILE* stream) noexcept {
  int size = 0;
  int character = 0;
  while (size < room - 1 && character != '\n' && (character = next_character(stream)) != EOF)
    line[size++] = static_cast<char>(character);
  if (size == 0 || ferror_unlocked(stream) != 0) return nullptr;
  line[size] = '\0';
  return line;
}

/// Room for @p size bytes at @p line.
bool make_room_for(char*& line, size_t& room, size_t size) noexcept {
  constexpr size_t kLeast = 120;
  if (line != nullptr && room >= size) return true;
  const size_t more = size < kLeast ? kLeast : 2 * size;
  auto* const moved = static_cast<char*>(realloc(line, more));
  if (moved == nullptr) return false;
  line = moved;
  room = more;
  return true;
}

ssize_t read_until(char** line, size_t* room, int delimiter, FILE* stream) noexcept {
  if (line == nullptr || room == nullptr) {
    errno = EINVAL;
    return -1;
  }
  size_t size = 0;
  for (int character = -1; character != delimiter;) {
    if (!make_room_for(*line, *room, size + 2)) return -1;
    character = next_character(stream);
    if (character == EOF) break;
    (*line)[size++] = static_cast<char>(character);
  }
  if (size == 0) return -1;
  (*line)[size] = '\0';
  return static_cast<ssize_t>(size);
}

/// Takes what is in the stream's buffer at once.
size_t read_bytes(char* data, size_t size, FILE* stream) noexcept {
  size_t done = 0;
  while (done < size) {
    const int character = next_character(stream);
    if (character == EOF) break;
    data[done++] = static_cast<char>(character);
    const auto buffered = static_cast<size_t>(stream->_IO_read_end - stream->_IO_read_ptr);
    const size_t part = buffered < size - done ? buffered : size - done;
    memcpy(data + done, stream->_IO_read_ptr, part);
    stream->_IO_read_ptr += part;
    done += part;
  }
  return done;
}

/// Holds the lock of a stream.
class StreamLock {
 public:
  explicit StreamLock(FILE* stream) noexcept : stream_{stream} { flockfile(stream); }
  StreamLock(const StreamLock&) = delete;
  StreamLock& operator=(const StreamLock&) = delete;
  ~StreamLock() { funlockfile(stream_); }

 private:
  FILE* stream_;
};

}  // namespace

}  // namespace preload

using preload::may_wait_within;
using preload::real;
using preload::StreamLock;

/// What is written to the stream goes past write(2).
PRELOAD_EXPORT FILE* fdopen(int descriptor, const char* mode) noexcept {
  if (preload::by_turns() && (mode[0] != 'r' || strchr(mode, '+') != nullptr)) preload::expect_unseen_writes();
  return real().fdopen(descriptor, mode);
}

PRELOAD_EXPORT char* fgets(char* line, int room, FILE* stream) {
  if (room <= 0 || !may_wait_within(stream)) return real().fgets(line, room, stream);
  const StreamLock lock{stream};
  return preload::read_line(line, room, stream);
}

PRELOAD_EXPORT char* fgets_unlocked(char* line, int room, FILE* stream) {
  return fgets(line, room, stream);
}

PRELOAD_EXPORT ssize_t getdelim(char** line, size_t* room, int delimiter, FILE* stream) {
  if (!may_wait_within(stream)) return real().getdelim(line, room, delimiter, stream);
  const StreamLock lock{stream};
  return preload::read_until(line, room, delimiter, stream);
}

PRELOAD_EXPORT ssize_t __getdelim(char** line, size_t* room, int delimiter, FILE* stream) {
  return getdelim(line, room, delimiter, stream);
}

PRELOAD_EXPORT ssize_t getline(char** line, size_t* room, FILE* stream) {
  return getdelim(line, room, '\n', stream);
}

PRELOAD_EXPORT size_t fread(void* data, size_t size, size_t count, FILE* stream) {
  if (size == 0 || count == 0 || !may_wait_within(stream)) return real().fread(data, size, count, stream);
  const StreamLock lock{stream};
  return preload::read_bytes(static_cast<char*>(data), size * count, stream) / size;
}

PRELOAD_EXPORT size_t fread_unlocked(void* data, size_t size, size_t count, FILE* stream) {
  return fread(data, size, count, stream);
}

// The C library's own checks end the program if `least` is too small.

PRELOAD_EXPORT char* __fgets_chk(char* line, size_t least, int room, FILE* stream) {
  if (room > 0 && static_cast<size_t>(room) > least) abort();
  return fgets(line, room, stream);
}

PRELOAD_EXPORT size_t __fread_chk(void* data, size_t least, size_t size, size_t count, FILE* stream) {
  if (size != 0 && least / size < count) abort();
  return fread(data, size, count, stream);
}
