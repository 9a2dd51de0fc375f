// select, pselect.
#include <cerrno>
#include <cstring>

#include "can/preload/calls/exported.hpp"
#include "can/preload/calls/failed.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/instant.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/wait/look.hpp"

namespace preload {

namespace {

/// The three sets of select(2), which are changed in place.
struct Sets {
  int end;
  fd_set* readable;
  fd_set* writable;
  fd_set* exceptional;
};

/// What select(2) is asked for, so that it can be asked again.
class Asked {
 public:
  explicit Asked(const Sets& sets) noexcept : sets_{sets} {
    size_t at = 0;
    for (fd_set* const set : {sets.readable, sets.writable, sets.exceptional})
      copies_[at++] = set == nullptr ? fd_set{} : *set;
    for (int descriptor = 0; descriptor < sets.end; ++descriptor) add(descriptor);
  }

  [[nodiscard]] const pollfd* descriptors() const noexcept { return descriptors_; }
  [[nodiscard]] nfds_t count() const noexcept { return count_; }

  /// Asks the kernel, with @p limit of its time.
  int ask(const timespec* limit, const sigset_t* mask) noexcept {
    size_t at = 0;
    for (fd_set* const set : {sets_.readable, sets_.writable, sets_.exceptional}) {
      if (set != nullptr) *set = copies_[at];
      ++at;
    }
    return real().pselect(sets_.end, sets_.readable, sets_.writable, sets_.exceptional, limit, mask);
  }

 private:
  void add(int descriptor) noexcept {
    constexpr short kEvents[] = {POLLIN, POLLOUT, POLLPRI};
    short events = 0;
    for (size_t i = 0; i < sizeof kEvents / sizeof *kEvents; ++i)
      if (FD_ISSET(descriptor, &copies_[i])) events = static_cast<short>(events | kEvents[i]);
    if (events != 0) descriptors_[count_++] = {descriptor, events, 0};
  }

  Sets sets_;
  fd_set copies_[3];
  pollfd descriptors_[FD_SETSIZE];
  nfds_t count_ = 0;
};

constexpr timespec kNoTimeToSelect{};

int select_for(const Sets& sets, int64_t deadline, const sigset_t* mask) noexcept {
  Asked asked{sets};
  Wait wait{};
  wait.descriptors = asked.descriptors();
  wait.count = asked.count();
  wait.deadline = deadline;
  wait.mask = mask;
  return look_until(
      wait, [&asked, mask] { return asked.ask(&kNoTimeToSelect, mask); },
      [&asked, mask](int64_t until) {
        const timespec limit = timespec_of(machine_left(until));
        return asked.ask(until == kNoInstant ? nullptr : &limit, mask);
      });
}

}  // namespace

}  // namespace preload

using preload::by_machine;
using preload::present;
using preload::real;

PRELOAD_EXPORT int select(int end, fd_set* readable, fd_set* writable, fd_set* exceptional, timeval* limit) {
  if (by_machine() || end > FD_SETSIZE) return real().select(end, readable, writable, exceptional, limit);
  if (limit != nullptr && (limit->tv_sec < 0 || limit->tv_usec < 0)) return preload::failed(EINVAL);
  const int64_t deadline =
      limit == nullptr ? preload::kNoInstant : preload::after(present(), preload::ns_of(*limit));
  const int ready = preload::select_for({end, readable, writable, exceptional}, deadline, nullptr);
  if (limit != nullptr && ready >= 0) {
    const int64_t left = deadline - present();
    *limit = preload::timeval_of(left > 0 ? left : 0);
  }
  return ready;
}

PRELOAD_EXPORT int pselect(int end, fd_set* readable, fd_set* writable, fd_set* exceptional, const timespec* limit,
                           const sigset_t* mask) {
  if (by_machine() || end > FD_SETSIZE) return real().pselect(end, readable, writable, exceptional, limit, mask);
  if (limit != nullptr && !preload::is_valid(*limit)) return preload::failed(EINVAL);
  const int64_t deadline = preload::after(present(), preload::ns_of_limit(limit));
  return preload::select_for({end, readable, writable, exceptional}, deadline, mask);
}
