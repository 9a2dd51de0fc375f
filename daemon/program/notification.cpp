#include "daemon/program/notification.hpp"

#include <systemd/sd-daemon.h>

namespace axisd {

void Notification::on_condition(const Instance& instance, Condition condition) noexcept {
  const char* const bus = instance.bus_name().c_str();
  if (condition == Condition::Down) {
    sd_notifyf(0, "STATUS=%s is down", bus);
    return;
  }
  const bool is_last = condition == Condition::Ready && --awaited_ == 0;
  sd_notifyf(0, "%sSTATUS=node %d on %s", is_last ? "READY=1\n" : "", int{instance.device().node_id()}, bus);
}

void Notification::on_stopping() noexcept {
  sd_notify(0, "STOPPING=1\nSTATUS=");
}

}  // namespace axisd
