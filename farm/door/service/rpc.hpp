#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "control/protocol.hpp"
#include "farm/door/service/outlets.hpp"
#include "farm/door/service/roster.hpp"
#include "farm/link/messages.hpp"
#include "gateway/units/daemons.hpp"

namespace farm {

/// Answers the requests to units, by asking their daemons.
class Rpc {
 public:
  /// Longest request (bytes).
  static constexpr std::size_t kLongest = 65536;
  /// Most requests of all units that are under way.
  static constexpr std::size_t kMostUnderWay = 8192;

  /// Requests to a unit since it was first asked.
  struct Count {
    std::uint64_t requests = 0;
    std::uint64_t errors = 0;
    std::chrono::nanoseconds time{};  ///< from request to answer, all together
    std::string last_error{};
  };
  /// With whom it works; all of them outlive it.
  struct Parts {
    Messages& messages;
    const gateway::Daemons& daemons;
    const Roster& roster;
    Outlets& outlets;
  };

  /// For the host called @p host; @p read_only: whatever changes a unit is refused.
  Rpc(const Parts& parts, std::string host, bool read_only)
      : parts_{parts}, host_{std::move(host)}, read_only_{read_only} {}

  /// Answers @p message to @p unit.
  void take(const UnitName& unit, const Message& message);
  [[nodiscard]] const std::map<UnitName, Count>& counts() const noexcept { return *counts_; }

 private:
  struct Asked;

  void answer(const Asked& asked, const gateway::Answer& told) const;
  void refuse(const Asked& asked, control::ErrorCode code, std::string message) const;
  void carry_out(const Asked& asked, control::Request request);
  void serve_outlet(const Asked& asked, const control::Request& request);
  void forward(const Asked& asked, const Reached& reached, control::Request& request);
  [[nodiscard]] nlohmann::json unit_list(const Reached& reached) const;

  Parts parts_;
  std::string host_;
  bool read_only_;
  /// Shared so that who answers when the door has closed sees it.
  std::shared_ptr<std::map<UnitName, Count>> counts_ = std::make_shared<std::map<UnitName, Count>>();
  std::shared_ptr<std::size_t> under_way_ = std::make_shared<std::size_t>(0);
};

}  // namespace farm
