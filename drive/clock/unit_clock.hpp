#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "drive/messages/time_stamp.hpp"

namespace drive {

/// The clock of the unit: the operating time as it is told, and beside it UTC while p3100 = 1. UTC begins at 0 and
/// goes on with the operating time; what sets it is a correction of that.
class UnitClock {
 public:
  /// p3103: where UTC comes from.
  enum class Method : std::uint8_t {
    PingSnap = 0,  ///< a snap (p3101) says when the last ping (p3104) was
    Simple = 2,    ///< p3101 says what time it is
    Host = 4,      ///< NTP: the clock of the program around is the answer
  };
  /// What has become of a time that came.
  enum class Correction : std::uint8_t {
    None,    ///< it was not taken
    Within,  ///< the clock was set for the first time, or by p3109 at most
    Beyond,  ///< by more than that
  };
  struct Settings {
    using Block = UnitClock;

    double tolerance = 0.1;  ///< p3109 (s)
  };
  /// A moment as parameters have it.
  enum Part : std::size_t { kMillisecondsOfTheDay, kDays, kParts };

  /// So long after the ping a snap is taken (ms).
  static constexpr Uptime kSnapTime = 5000;
  /// So often the clock of the program around is asked (ms).
  static constexpr Uptime kHostPeriod = 64'000;

  /// The operating time is @p now (ms).
  void tell(Uptime now) noexcept { line_.now = now; }
  /// The operating time counts anew from @p now (ms); UTC goes on.
  void continue_at(Uptime now) noexcept;
  /// What messages are stamped with.
  const TimeLine& line() const noexcept { return line_; }

  /// Whether there is UTC (p3100).
  bool is_utc() const noexcept { return line_.utc_ahead.has_value(); }
  /// Whether it has been set since it began.
  bool is_synchronised() const noexcept { return synchronised_; }
  Method method() const noexcept { return method_; }

  /// p3100: UTC begins at 0, or there is none any more. What was known of it is forgotten.
  void run_utc(bool runs) noexcept;
  /// p3103: what has come for another method is forgotten.
  void choose(Method method) noexcept;
  /// The edge of p3104: what a snap is relative to.
  void ping() noexcept;
  /// p3101: the days, or the milliseconds of the day, which set the clock.
  Correction give(Part part, std::uint32_t value) noexcept;
  /// Part @p part of p3101 as last given.
  std::uint32_t given(Part part) const noexcept { return given_[part]; }
  /// Whether the clock of the program around is to be asked.
  bool asks_host() const noexcept { return line_.now >= host_due_; }
  /// What that clock says; nothing: it does not know.
  Correction answer(std::optional<UtcTime> host) noexcept;

  /// How far the clock was set on by the last correction, the first time not counted, and by the last one beyond
  /// the tolerance (ms; r3108).
  std::int32_t last_deviation() const noexcept { return last_deviation_; }
  std::int32_t last_violation() const noexcept { return last_violation_; }
  /// What the clock was before the last correction beyond the tolerance, and after it (r3107).
  UtcTime violated() const noexcept { return violated_; }
  UtcTime violated_by() const noexcept { return violated_by_; }

  Settings settings{};

 private:
  static constexpr Uptime kNever = std::numeric_limits<Uptime>::max();

  Correction set(UtcTime utc) noexcept;
  Correction snap(UtcTime utc) noexcept;
  void plan_question() noexcept;

  TimeLine line_{};
  Method method_ = Method::PingSnap;
  bool synchronised_ = false;
  std::array<std::uint32_t, kParts> given_{};
  std::optional<Uptime> ping_{};  // when it came, until a snap has come
  Uptime host_due_ = kNever;
  std::int32_t last_deviation_ = 0;
  std::int32_t last_violation_ = 0;
  UtcTime violated_ = 0;
  UtcTime violated_by_ = 0;
};

}  // namespace drive
