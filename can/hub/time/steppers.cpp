#include "can/hub/time/steppers.hpp"

#include <algorithm>
#include <cstdint>
#include <new>
#include <utility>

#include <poll.h>
#include <sys/socket.h>

#include "can/userbus/protocol.hpp"

namespace hub {

using canopen::TimePoint;

/// One of them, while it waits.
class Steppers::Stepper final : public Watch {
 public:
  Stepper(Poll& poll, TimePoint goal) noexcept : poll_{poll}, goal_{goal} {}
  Stepper(const Stepper&) = delete;
  Stepper& operator=(const Stepper&) = delete;
  ~Stepper() override {
    if (reply_) poll_.remove(reply_.get(), *this);
  }

  void begin(os::Descriptor reply) noexcept {
    constexpr std::uint32_t kHangUpAlone = 0;
    reply_ = std::move(reply);
    pollfd present{reply_.get(), 0, 0};  // whoever has gone already does not have time go on before that is told
    has_gone_ = !poll_.add(reply_.get(), kHangUpAlone, *this) || poll(&present, 1, 0) != 0;
  }
  void on_events(std::uint32_t) noexcept override {
    has_gone_ = true;
    poll_.remove(reply_.get(), *this);
  }
  void answer(TimePoint now) const noexcept {
    struct [[gnu::packed]] {
      userbus::Reply header;
      std::int64_t now_ns;
    } const reply{{.error = 0, .value = 0, .size = sizeof(std::int64_t)}, now.time_since_epoch().count()};
    send(reply_.get(), &reply, sizeof reply, MSG_DONTWAIT | MSG_NOSIGNAL);
  }
  [[nodiscard]] TimePoint goal() const noexcept { return has_gone_ ? canopen::kNever : goal_; }
  [[nodiscard]] bool has_gone() const noexcept { return has_gone_; }

 private:
  Poll& poll_;
  TimePoint goal_;
  os::Descriptor reply_;
  bool has_gone_ = false;
};

Steppers::Steppers(Poll& poll) noexcept : poll_{poll} {}

Steppers::~Steppers() = default;

bool Steppers::add(TimePoint goal, os::Descriptor& reply) noexcept {
  std::erase_if(waiting_, [](const auto& stepper) { return stepper->has_gone(); });
  try {
    waiting_.push_back(std::make_unique<Stepper>(poll_, goal));
  } catch (const std::bad_alloc&) {
    return false;
  }
  waiting_.back()->begin(std::move(reply));
  return true;
}

TimePoint Steppers::next_goal() const noexcept {
  TimePoint next = canopen::kNever;
  for (const auto& stepper : waiting_) next = std::min(next, stepper->goal());
  return next;
}

bool Steppers::answer(TimePoint now) noexcept {
  return std::erase_if(waiting_, [now](const auto& stepper) {
           if (stepper->goal() > now) return false;
           stepper->answer(now);
           return true;
         }) != 0;
}

}  // namespace hub
