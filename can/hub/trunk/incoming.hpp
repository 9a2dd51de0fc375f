#pragma once

#include <cstdint>

#include "can/hub/medium/medium.hpp"
#include "can/hub/notices.hpp"
#include "can/hub/trunk/hubs.hpp"
#include "can/hub/trunk/message.hpp"
#include "can/hub/trunk/report.hpp"

namespace hub::trunk {

/// What comes of other hubs: their frames, and who they are.
class Incoming {
 public:
  /// What becomes of the frames of a message.
  enum class Gate : std::uint8_t {
    Open,    ///< they pass
    Closed,  ///< this hub is cut from the bus: it misses them
    Stale,   ///< nobody lets them pass
  };

  /// All of them outlive this.
  Incoming(Medium& medium, Notices& notices, Figures& figures) noexcept
      : medium_{medium}, notices_{notices}, figures_{figures} {}

  /// Takes a message of another hub, whose frames have passed at @p time_ns (CLOCK_REALTIME); true if that hub is
  /// on the bus anew.
  bool take(const Reader& reader, std::int64_t time_ns, Gate gate, canopen::TimePoint now) noexcept;
  /// Says who has gone silent.
  void tell_gone(canopen::TimePoint now) noexcept;
  /// Nobody has gone silent until @p now: nothing could be heard.
  void forgive(canopen::TimePoint now) noexcept { hubs_.forgive(now); }

  [[nodiscard]] const Hubs& hubs() const noexcept { return hubs_; }

 private:
  void meet(const Reader& reader, const Hubs::Outcome& outcome, canopen::TimePoint now) noexcept;
  [[nodiscard]] bool pass(const Reader& reader, std::size_t number, std::int64_t time_ns,
                          canopen::TimePoint now) noexcept;

  Medium& medium_;
  Notices& notices_;
  Figures& figures_;
  Hubs hubs_;
};

}  // namespace hub::trunk
