#pragma once

#include <cstddef>

#include "daemon/instance/instance.hpp"

namespace axisd {

/// Tells systemd, if it has started the program, how the units are.
class Notification final : public InstanceListener {
 public:
  /// READY=1 is told when so many @p instances are ready.
  explicit Notification(std::size_t instances) noexcept : awaited_{instances} {}

  void on_condition(const Instance& instance, Condition condition) noexcept override;
  /// The program is about to end.
  static void on_stopping() noexcept;

 private:
  std::size_t awaited_;
};

}  // namespace axisd
