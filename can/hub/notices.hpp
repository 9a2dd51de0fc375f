#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "can/connection/message_limit.hpp"
#include "libcanopen/base/time.hpp"

namespace hub {

/// Takes one line for the operator.
using Notice = std::function<void(std::string_view line)>;

/// What one neighbour of the hub has to say to the operator: lines that begin with its name, and no more of them
/// than bus::MessageLimit lets through.
class Notices {
 public:
  Notices(std::string name, Notice notice) : name_{std::move(name)}, notice_{std::move(notice)} {}

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  /// Says @p what, unless too much has been said.
  void tell(std::string_view what, canopen::TimePoint now) noexcept;
  /// When on_time() is wanted.
  [[nodiscard]] canopen::TimePoint due() const noexcept { return limit_.due(); }
  /// Says how many lines were left out, if any were.
  void on_time(canopen::TimePoint now) noexcept;

 private:
  void tell_left_out(canopen::TimePoint now);

  std::string name_;
  Notice notice_;
  bus::MessageLimit limit_;
};

}  // namespace hub
