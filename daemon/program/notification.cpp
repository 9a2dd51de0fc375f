#include "daemon/program/notification.hpp"

#include <systemd/sd-daemon.h>

#include "daemon/base/node_text.hpp"

namespace axisd {

void Notification::on_condition(const Instance& instance, Condition condition) noexcept {
  const std::lock_guard guard{mutex_};
  const bool is_on_bus = condition == Condition::Ready || condition == Condition::UpAgain;
  is_on_bus ? static_cast<void>(on_bus_.insert(&instance)) : static_cast<void>(on_bus_.erase(&instance));
  bool is_now_ready = false;
  if (!is_ready_) {
    told_.insert(&instance);
    is_now_ready = is_ready_ = told_.size() == units_ && !on_bus_.empty();
  }
  tell(instance, condition, is_now_ready);
}

void Notification::tell(const Instance& instance, Condition condition, bool is_now_ready) const {
  const char* const ready = is_now_ready ? "READY=1\n" : "";
  const char* const bus = instance.bus_name().c_str();
  if (units_ > 1) {
    sd_notifyf(0, "%sSTATUS=%zu of %zu units on their bus", ready, on_bus_.size(), units_);
  } else if (condition == Condition::Down) {
    sd_notifyf(0, "STATUS=%s is down", bus);
  } else if (condition == Condition::Off) {
    sd_notify(0, "STATUS=switched off");
  } else {
    sd_notifyf(0, "%sSTATUS=%s on %s", ready, node_text(instance.device().node_id()).c_str(), bus);
  }
}

void Notification::on_stopping() noexcept {
  sd_notify(0, "STOPPING=1\nSTATUS=");
}

}  // namespace axisd
