#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "can/hub/medium/carrier.hpp"
#include "can/hub/medium/medium.hpp"
#include "can/hub/medium/source.hpp"
#include "can/hub/notices.hpp"
#include "can/hub/trunk/hubs.hpp"
#include "can/hub/trunk/latency.hpp"
#include "can/hub/trunk/lateness.hpp"
#include "can/hub/trunk/message.hpp"
#include "can/hub/trunk/stream.hpp"
#include "can/hub/trunk/under_way.hpp"

namespace hub::trunk {

/// What has become of frames, since the hub began.
struct Figures {
  std::uint64_t sent = 0;      ///< of this hub's members that have passed
  std::uint64_t received = 0;  ///< of other hubs that have passed here
  /// Of this hub's members that were under way when the wire was cut: none of them has passed here, and nobody
  /// knows which of them have elsewhere.
  std::uint64_t dropped = 0;
  std::uint64_t stale = 0;      ///< of other hubs that came too late, which nobody lets pass
  std::uint64_t returned = 0;   ///< of other hubs that had been here before, over a bridge
  std::uint64_t repeated = 0;   ///< of this hub's members that somebody has sent a second time
  std::uint64_t malformed = 0;  ///< messages that were none
  std::uint64_t cuts = 0;       ///< times that the wire was cut
};

/// Joins the medium of this hub with those of others: one wire, over a stream that gives the frames of all hubs
/// one order. A frame of a member passes when it comes back from the stream.
///
/// Every hub sends a beat each 100 ms. Where none of its messages comes back for 500 ms, where a message is
/// missing in the stream or the hub itself stood still for so long, the wire is cut: members are told (on_link),
/// frames that are under way are dropped and counted, and the stream is joined anew, with nothing of what was sent
/// meanwhile. A message that the stream took in more than 500 ms after its hub had last heard from the stream
/// comes from such a hub, and so does what the stream took in behind the return of its hub: it is let pass by
/// nobody.
class Trunk final : public Source, public Carrier {
 public:
  static constexpr canopen::Duration kBeat = std::chrono::milliseconds{100};
  static constexpr canopen::Duration kPatience = kMostLateness;
  /// Frames under way; with more the medium is full.
  static constexpr std::size_t kMostUnderWay = UnderWay::kMost;

  struct Settings {
    std::string url;                             ///< in notices and statistics
    std::string name;                            ///< of this hub, for the others
    std::size_t frames_a_message = kMostFrames;  ///< at most; 1..kMostFrames
  };
  /// The wire is whole or cut: to be passed on to Medium::set_up() and to the members.
  using OnLink = std::function<void(bool up, canopen::TimePoint now)>;

  /// Carries the frames of @p medium, which is cut until the stream is open.
  Trunk(Medium& medium, std::unique_ptr<Stream> stream, Settings settings, OnLink on_link, Notice notice);
  Trunk(const Trunk&) = delete;
  Trunk& operator=(const Trunk&) = delete;
  ~Trunk() override;

  [[nodiscard]] int descriptor() const noexcept override { return stream_->descriptor(); }
  void on_readable(canopen::TimePoint now) noexcept override;
  [[nodiscard]] canopen::TimePoint next_deadline() const noexcept override;
  void on_time(canopen::TimePoint now) noexcept override;
  [[nodiscard]] bool statistics(userbus::MemberStatistics& row) const noexcept override;

  [[nodiscard]] bool has_room() const noexcept override { return !under_way_.full(); }
  void take(const Passage& passage, canopen::TimePoint now) noexcept override;
  void on_detach(const Participant& participant) noexcept override { under_way_.forget(participant); }
  [[nodiscard]] Identity identity() const noexcept override;
  [[nodiscard]] std::string report(std::size_t room) const override;

  [[nodiscard]] bool is_up() const noexcept { return phase_ == Phase::Up; }
  [[nodiscard]] const Figures& figures() const noexcept { return figures_; }
  [[nodiscard]] const Hubs& hubs() const noexcept { return hubs_; }
  [[nodiscard]] std::size_t under_way() const noexcept { return under_way_.count(); }
  /// From taking a frame until it passes.
  [[nodiscard]] const Latency& latency() const noexcept { return latency_; }
  [[nodiscard]] const Settings& settings() const noexcept { return settings_; }

 private:
  /// No stream; open, but the first beat has not come back; frames pass.
  enum class Phase : std::uint8_t { Closed, Joining, Up };

  [[nodiscard]] bool stood_still(canopen::TimePoint now) noexcept;
  void join(canopen::TimePoint now) noexcept;
  void come_up(canopen::TimePoint now) noexcept;
  void cut(std::string_view reason, canopen::TimePoint now) noexcept;
  void read(canopen::TimePoint now) noexcept;
  void take_message(const Stream::Message& message, canopen::TimePoint now) noexcept;
  void take_own(const Reader& reader, const Stream::Message& message, bool is_stale,
                canopen::TimePoint now) noexcept;
  [[nodiscard]] bool has_been_here(const Reader& reader) const noexcept;
  void take_foreign(const Reader& reader, const Stream::Message& message, bool is_stale,
                    canopen::TimePoint now) noexcept;
  bool pass(const Reader& reader, std::size_t number, std::int64_t time_ns, canopen::TimePoint now) noexcept;
  void tell_news(const Hubs::Outcome& outcome, canopen::TimePoint now) noexcept;
  [[nodiscard]] Header header(Kind kind, std::uint32_t origin) const noexcept;
  void publish(std::span<const std::byte> message) noexcept;
  void finish_message() noexcept;
  void flush() noexcept;
  void beat(canopen::TimePoint now) noexcept;
  void miss_own(canopen::TimePoint now) noexcept;

  Medium& medium_;
  std::unique_ptr<Stream> stream_;
  Settings settings_;
  OnLink on_link_;
  Notices notices_;
  Phase phase_ = Phase::Closed;
  std::uint32_t epoch_ = 0;
  std::uint64_t counter_ = 1;       ///< number of the next frame
  std::uint64_t sequence_ = 0;      ///< of the last message of the stream; 0: none since it was opened
  std::int64_t seen_ = 0;           ///< its time stamp
  std::int64_t returned_seen_ = 0;  ///< the same as it was in the last message of this hub that came back
  canopen::TimePoint heard_{};      ///< when a message of this hub came back
  canopen::TimePoint looked_{};     ///< when the hub was last seen to run
  canopen::TimePoint next_beat_{};
  bool has_more_ = false;         ///< messages that have come in and were not taken yet
  bool is_failure_told_ = false;  ///< that the first beat does not come back
  Writer writer_;                 ///< frames that are sent at the end of the turn
  bool is_unsent_ = false;        ///< the stream has taken a message that it has not sent yet
  UnderWay under_way_;
  Hubs hubs_;
  Figures figures_;
  Latency latency_;
};

}  // namespace hub::trunk
