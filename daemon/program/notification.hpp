#pragma once

#include <cstddef>
#include <mutex>
#include <set>

#include "daemon/instance/instance.hpp"

namespace axisd {

/// Tells systemd, if it has started the program, how the units are: READY=1 when every unit whose bus is up has
/// sent its boot-up message, and at least one has. Any thread may tell of its units.
class Notification final : public InstanceListener {
 public:
  /// Of so many @p units.
  explicit Notification(std::size_t units) noexcept : units_{units} {}

  void on_condition(const Instance& instance, Condition condition) noexcept override;
  /// The program is about to end.
  static void on_stopping() noexcept;

 private:
  void tell(const Instance& instance, Condition condition, bool is_now_ready) const;

  std::mutex mutex_;
  std::size_t units_;
  std::set<const Instance*> told_;  ///< how they are, until READY=1
  std::set<const Instance*> on_bus_;
  bool is_ready_ = false;
};

}  // namespace axisd
