#include "can/userbus/time.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <dirent.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include "can/userbus/name.hpp"
#include "can/userbus/request.hpp"

namespace userbus {

namespace {

constexpr char kScaled[] = "scaled=";

/// A decimal number of at most kLongest characters; libc's depend on the locale.
bool read_number(const char* text, size_t size, double& number) noexcept {
  constexpr size_t kLongest = 12;
  constexpr double kTen = 10;
  if (size == 0 || size > kLongest) return false;
  double place = 0;  // of the next digit behind the point; 0: before the point
  bool has_digit = false;
  number = 0;
  for (size_t i = 0; i < size; ++i) {
    if (text[i] == '.' && place == 0) {
      place = 1 / kTen;
      continue;
    }
    if (text[i] < '0' || text[i] > '9') return false;
    has_digit = true;
    const double digit = text[i] - '0';
    number = place == 0 ? kTen * number + digit : number + digit * place;
    place /= kTen;
  }
  return has_digit;
}

bool equals(const char* text, size_t size, const char* word) noexcept {
  return strlen(word) == size && memcmp(text, word, size) == 0;
}

/// The first descriptor from @p lowest on that is a connection of kind Clock; -1: there is none.
int first_clock(int lowest) noexcept {
  DIR* const folder = opendir("/proc/self/fd");
  if (folder == nullptr) return -1;
  int found = -1;
  while (const dirent* const entry = readdir(folder)) {
    const int descriptor = atoi(entry->d_name);
    Name name{};
    if (entry->d_name[0] == '.' || descriptor < lowest || !name_of(descriptor, name)) continue;
    if (name.kind == Kind::Clock && (found < 0 || descriptor < found)) found = descriptor;
  }
  closedir(folder);
  return found;
}

}  // namespace

bool read_time(const char* text, size_t size, TimeWish& wish) noexcept {
  for (const TimeMode mode : {TimeMode::Real, TimeMode::Virtual, TimeMode::Stepped}) {
    if (!equals(text, size, kTimeNames[static_cast<size_t>(mode)])) continue;
    wish = {mode, 1};
    return true;
  }
  constexpr size_t kPrefix = sizeof kScaled - 1;
  if (size <= kPrefix || memcmp(text, kScaled, kPrefix) != 0) return false;
  double scale = 0;
  if (!read_number(text + kPrefix, size - kPrefix, scale)) return false;
  wish = {TimeMode::Scaled, scale};
  return scale >= kSlowestScale && scale <= kQuickestScale;
}

JoinedClock join_clock(const Path& path, const char* hub, uint32_t flags, int process, bool inherited) noexcept {
  const Joined joined = join(path, hub, Kind::Clock, inherited ? 0 : SOCK_CLOEXEC);
  if (joined.descriptor < 0) return {.descriptor = -1, .error = joined.error};
  const TimeMessage message{.word = TimeMessage::Word::Join, .flags = flags, .process = process};
  if (tell_time(joined.descriptor, message)) return {.descriptor = joined.descriptor, .error = JoinError::None};
  close(joined.descriptor);
  return {.descriptor = -1, .error = JoinError::NotServed};
}

int inherited_clock() noexcept {
  const int clock = first_clock(0);
  if (clock < 0) return -1;
  for (int other = 0; (other = first_clock(clock + 1)) >= 0;) close(other);
  return clock;
}

const TimePage* map_time(int descriptor) noexcept {
  int passed = -1;
  const Answer answer = ask(descriptor, Operation::Time, 0, nullptr, 0, nullptr, 0, &passed);
  if (answer.error != 0 || passed < 0) {
    // an older hub knows nothing of time
    errno = answer.error == EINVAL || answer.error == EOPNOTSUPP ? 0 : answer.error;
    return nullptr;
  }
  const void* const page = mmap(nullptr, kTimePageSize, PROT_READ, MAP_SHARED, passed, 0);
  close(passed);
  return page == MAP_FAILED ? nullptr : static_cast<const TimePage*>(page);
}

void unmap_time(const TimePage* page) noexcept {
  munmap(const_cast<TimePage*>(page), kTimePageSize);
}

bool tell_time(int descriptor, const TimeMessage& message) noexcept {
  iovec part{const_cast<TimeMessage*>(&message), sizeof message};
  msghdr header{};
  header.msg_iov = &part;
  header.msg_iovlen = 1;
  ssize_t sent = 0;
  do sent = sendmsg(descriptor, &header, MSG_NOSIGNAL);
  while (sent < 0 && errno == EINTR);
  return sent == sizeof message;
}

TurnOutcome take_turn(int descriptor, bool waits, TimeTurn& turn) noexcept {
  iovec part{&turn, sizeof turn};
  msghdr header{};
  header.msg_iov = &part;
  header.msg_iovlen = 1;
  ssize_t size = 0;
  do size = recvmsg(descriptor, &header, waits ? 0 : MSG_DONTWAIT);
  while (size < 0 && errno == EINTR);
  if (size == sizeof turn) return TurnOutcome::Turn;
  return size < 0 && errno == EAGAIN ? TurnOutcome::None : TurnOutcome::Gone;
}

}  // namespace userbus
