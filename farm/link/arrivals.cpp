#include "farm/link/arrivals.hpp"

#include <cerrno>
#include <system_error>
#include <utility>

#include <sys/eventfd.h>

namespace farm {

Arrivals::Arrivals() : waiting_{::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)} {
  if (!waiting_) throw std::system_error{errno, std::generic_category(), "eventfd"};
}

void Arrivals::put(std::uint64_t subscription, nats::Message message) {
  const std::scoped_lock lock{mutex_};
  arrivals_.push_back({subscription, std::move(message)});
  if (arrivals_.size() == 1) ::eventfd_write(waiting_.get(), 1);
}

std::vector<Arrivals::Arrival> Arrivals::take() {
  eventfd_t none = 0;
  const std::scoped_lock lock{mutex_};
  ::eventfd_read(waiting_.get(), &none);
  return std::exchange(arrivals_, {});
}

}  // namespace farm
