#include "daemon/instance/memory/state_writer.hpp"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <system_error>

#include <sys/eventfd.h>
#include <unistd.h>

#include "os/clock.hpp"
#include "os/no_signals.hpp"

namespace axisd {
namespace {

os::Descriptor open_eventfd() {
  os::Descriptor descriptor{::eventfd(1, EFD_CLOEXEC | EFD_NONBLOCK | EFD_SEMAPHORE)};
  if (!descriptor) throw std::system_error{errno, std::generic_category(), "eventfd"};
  return descriptor;
}

}  // namespace

StateWriter::StateWriter(std::size_t longest) : ended_{open_eventfd()} {
  for (Job& job : jobs_) job.content.reserve(longest);
  const os::NoSignals none;
  thread_ = std::thread{[this] { work(); }};
}

StateWriter::~StateWriter() {
  {
    const std::scoped_lock lock{mutex_};
    stopping_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void StateWriter::begin(Place place, const StateFile& file, std::span<const std::byte> content,
                        Durability durability, bool makes_room) noexcept {
  {
    const std::scoped_lock lock{mutex_};
    Job& job = jobs_[static_cast<std::size_t>(place)];
    assert(job.state == State::Free && content.size() <= job.content.capacity());
    job.file = &file;
    job.content.assign(content.begin(), content.end());
    job.durability = durability;
    job.makes_room = makes_room;
    job.state = State::Waiting;
    // it takes no time of the unit's, however long the disk needs
    if (os::stands_while_acting()) end(job, write(job));
  }
  changed_.notify_all();
}

std::optional<StateWriter::Ended> StateWriter::take_ended() noexcept {
  eventfd_t none = 0;
  ::eventfd_read(ended_.get(), &none);
  const std::scoped_lock lock{mutex_};
  auto* const job = std::ranges::find(jobs_, State::Ended, &Job::state);
  if (job == jobs_.end()) return std::nullopt;
  job->state = State::Free;
  return Ended{static_cast<Place>(job - jobs_.begin()), job->outcome};
}

void StateWriter::finish() noexcept {
  std::unique_lock lock{mutex_};
  changed_.wait(lock, [this] { return next_job() == nullptr; });
}

StateWriter::Job* StateWriter::next_job() noexcept {
  auto* const job = std::ranges::find(jobs_, State::Waiting, &Job::state);
  return job == jobs_.end() ? nullptr : job;
}

void StateWriter::work() noexcept {
  std::unique_lock lock{mutex_};
  while (true) {
    changed_.wait(lock, [this] { return stopping_ || next_job() != nullptr; });
    Job* const job = next_job();
    if (job == nullptr) return;
    lock.unlock();
    const auto outcome = write(*job);
    lock.lock();
    end(*job, outcome);
  }
}

tl::expected<void, WriteFailure> StateWriter::write(const Job& job) noexcept {
  if (job.makes_room)
    if (const auto room = job.file->make_room(); !room) return room;
  return job.file->write(job.content, job.durability);
}

/// With the mutex.
void StateWriter::end(Job& job, const tl::expected<void, WriteFailure>& outcome) noexcept {
  job.outcome = outcome;
  job.state = State::Ended;
  changed_.notify_all();
  ::eventfd_write(ended_.get(), 1);
  os::note_handed_over();
}

}  // namespace axisd
