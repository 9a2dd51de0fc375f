#include "can/preload/time/wait/poll_set.hpp"

#include <cstring>

#include <sys/mman.h>

#include "can/preload/time/base/real.hpp"
#include "can/preload/time/wait/descriptors.hpp"

namespace preload {

bool PollSet::make_room(nfds_t count) noexcept {
  if (count <= room_) return true;
  const nfds_t room = 2 * count;
  void* const more =
      mmap(nullptr, room * sizeof(pollfd), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (more == MAP_FAILED) return false;
  memcpy(more, entries_, room_ * sizeof(pollfd));
  if (entries_ != few_) munmap(entries_, room_ * sizeof(pollfd));
  entries_ = static_cast<pollfd*>(more);
  room_ = room;
  return true;
}

void PollSet::gather(const ThreadList& waiting) noexcept {
  count_ = 0;
  for (const Thread* thread = waiting.first(); thread != nullptr; thread = thread->following) {
    const nfds_t count = thread->wait.count;
    if (count == 0 || !make_room(count_ + count + 1)) continue;
    memcpy(entries_ + 1 + count_, thread->wait.descriptors, count * sizeof(pollfd));
    count_ += count;
  }
  for (nfds_t i = 1; i <= count_; ++i) entries_[i].revents = 0;
}

void PollSet::leave_out_bus() noexcept {
  for (nfds_t i = 1; i <= count_; ++i)
    if (is_known_on_bus(entries_[i].fd)) entries_[i].fd = -1;
}

int PollSet::look() noexcept {
  return count_ == 0 ? 0 : real().poll(entries_ + 1, count_, 0);
}

Thread* PollSet::first_ready(const ThreadList& waiting) const noexcept {
  const pollfd* entry = entries_ + 1;
  for (Thread* thread = waiting.first(); thread != nullptr; thread = thread->following)
    for (nfds_t i = 0; i < thread->wait.count; ++i, ++entry) {
      if (entry > entries_ + count_) return nullptr;
      if (entry->revents != 0) return thread;
    }
  return nullptr;
}

pollfd* PollSet::with_socket(int socket) noexcept {
  entries_[0] = {.fd = socket, .events = POLLIN, .revents = 0};
  return entries_;
}

bool PollSet::is_outside_ready() const noexcept {
  bool outside = false;
  for (nfds_t i = 1; i <= count_; ++i)
    if (entries_[i].revents != 0 && !is_on_bus(entries_[i].fd)) outside = true;
  return outside;
}

}  // namespace preload
