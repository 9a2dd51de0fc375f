#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "farm/agent/plan/orders.hpp"
#include "farm/agent/plan/process.hpp"

namespace farm::agent {

/// The hubs of the buses on which there are units of this host.
class Hubs {
 public:
  /// One that runs already, with @p bit_rate.
  void on_found(const std::string& bus, std::uint32_t bit_rate, canopen::TimePoint now);
  void on_started(const std::string& bus, canopen::TimePoint now);
  /// It has ended, or could not be started, for the reason @p why.
  void on_ended(const std::string& bus, const std::string& why, canopen::TimePoint now);

  /// Orders that those of @p wanted run, each with its bit rate, and no others but those of @p in_use.
  void advance(const std::map<std::string, std::uint32_t>& wanted, const std::set<std::string>& in_use,
               canopen::TimePoint now, Orders& orders);
  /// When a pause is over; kNever without any.
  [[nodiscard]] canopen::TimePoint due() const noexcept { return due_; }

  [[nodiscard]] bool is_on(const std::string& bus) const;
  /// Why that of @p bus does not run; empty if it does, or begins to.
  [[nodiscard]] std::string problem(const std::string& bus) const;
  [[nodiscard]] bool are_off() const;

 private:
  struct Hub {
    Process process;
    std::uint32_t bit_rate = 0;
  };

  std::map<std::string, Hub> hubs_;
  canopen::TimePoint due_ = canopen::kNever;
};

}  // namespace farm::agent
