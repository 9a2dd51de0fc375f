#include "service/mailbox.hpp"

#include <cerrno>
#include <system_error>
#include <utility>

#include <sys/eventfd.h>

#include "os/clock.hpp"

namespace axisd {

Mailbox::Mailbox() : waiting_{::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)} {
  if (!waiting_) throw std::system_error{errno, std::generic_category(), "eventfd"};
}

void Mailbox::post(Job job) {
  const std::lock_guard guard{mutex_};
  jobs_.push_back(std::move(job));
  if (jobs_.size() == 1) ::eventfd_write(waiting_.get(), 1);
  os::note_handed_over();
}

bool Mailbox::do_one() noexcept {
  Job job;
  bool more = false;
  {
    const std::lock_guard guard{mutex_};
    if (jobs_.empty()) return false;
    job = std::move(jobs_.front());
    jobs_.pop_front();
    more = !jobs_.empty();
    eventfd_t none = 0;
    if (!more) ::eventfd_read(waiting_.get(), &none);
  }
  job();
  return more;
}

}  // namespace axisd
