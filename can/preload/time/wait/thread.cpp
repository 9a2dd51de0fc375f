#include "can/preload/time/wait/thread.hpp"

#include <sys/mman.h>

#include "can/preload/time/base/hidden.hpp"

namespace preload {

namespace {

constexpr size_t kThreadsOfBlock = 64;

struct Block {
  Block* other = nullptr;
  Thread threads[kThreadsOfBlock];
};

/// There is always one, for programs of few threads.
constinit Block first_block;

[[gnu::tls_model("initial-exec")]] thread_local Thread* own;

Thread* free_one(Block& block) noexcept {
  for (Thread& thread : block.threads)
    if (thread.place == Place::Free) return &thread;
  return nullptr;
}

}  // namespace

void ThreadList::append(Thread& thread) noexcept {
  thread.previous = last_;
  thread.following = nullptr;
  (last_ == nullptr ? first_ : last_->following) = &thread;
  last_ = &thread;
}

void ThreadList::remove(Thread& thread) noexcept {
  (thread.previous == nullptr ? first_ : thread.previous->following) = thread.following;
  (thread.following == nullptr ? last_ : thread.following->previous) = thread.previous;
}

Thread* new_thread() noexcept {
  Thread* found = nullptr;
  Block* block = &first_block;
  while ((found = free_one(*block)) == nullptr && block->other != nullptr) block = block->other;
  if (found == nullptr) {
    void* const room = mmap(nullptr, sizeof(Block), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (room == MAP_FAILED) return nullptr;
    block->other = static_cast<Block*>(room);  // zeros: all of its threads are free
    found = block->other->threads;
  }
  found->place = Place::Running;
  found->handle = 0;
  found->id = 0;
  found->go = 0;
  if (found->bell == Thread::kNoBellToBeHad) found->bell = Thread::kNoBell;
  found->holds_signals = false;
  found->patience = Patience{};
  found->stay = userbus::Stay{};
  return found;
}

void free_thread(Thread& thread) noexcept {
  thread.place = Place::Free;
}

void forget_threads_but(const Thread* self) noexcept {
  for (Block* block = &first_block; block != nullptr; block = block->other)
    for (Thread& thread : block->threads) {
      if (&thread != self) thread.place = Place::Free;
      if (const int bell = thread.bell.exchange(Thread::kNoBell); bell > 0) close_hidden(bell);
    }
}

void for_each_thread(void (*visit)(Thread&, void*), void* argument) noexcept {
  for (Block* block = &first_block; block != nullptr; block = block->other)
    for (Thread& thread : block->threads)
      if (thread.place != Place::Free) visit(thread, argument);
}

Thread* own_thread() noexcept {
  return own;
}

void set_own_thread(Thread* thread) noexcept {
  own = thread;
}

}  // namespace preload
