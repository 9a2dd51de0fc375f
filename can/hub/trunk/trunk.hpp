#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "can/hub/medium/carrier.hpp"
#include "can/hub/medium/medium.hpp"
#include "can/hub/medium/source.hpp"
#include "can/hub/notices.hpp"
#include "can/hub/trunk/arbitration.hpp"
#include "can/hub/trunk/incoming.hpp"
#include "can/hub/trunk/lateness.hpp"
#include "can/hub/trunk/lease/lease.hpp"
#include "can/hub/trunk/message.hpp"
#include "can/hub/trunk/outgoing.hpp"
#include "can/hub/trunk/report.hpp"
#include "can/hub/trunk/stream.hpp"

namespace hub::trunk {

/// Joins the medium of this hub with those of others: one wire, over a stream that gives the frames of all hubs
/// one order. A frame of a member passes when it comes back from the stream.
///
/// Every hub sends a beat each 100 ms. Where none of its messages comes back for 500 ms, where a message is
/// missing in the stream or the hub itself stood still for so long, the wire is cut: members are told (on_link),
/// frames that are under way are dropped and counted, and the stream is joined anew, with nothing of what was sent
/// meanwhile. A message that the stream took in more than 500 ms after its hub had last heard from the stream
/// comes from such a hub, and so does what the stream took in behind the return of its hub: it is let pass by
/// nobody.
///
/// On a bus with a bit rate a hub asks the arbiter, one of the hubs, for its frames, and they pass when that
/// grants them (Arbitration). While there is no arbiter the wire is cut. A hub that is to run at another bit rate
/// than those that are on the bus does not join.
class Trunk final : public Source, public Carrier {
 public:
  static constexpr canopen::Duration kBeat = std::chrono::milliseconds{100};
  static constexpr canopen::Duration kPatience = kMostLateness;
  /// A hub that did not join waits until it has heard nothing for so long of those that it does not go with.
  static constexpr canopen::Duration kRefusal = std::chrono::milliseconds{1000};
  /// Frames under way; with more the medium is full.
  static constexpr std::size_t kMostUnderWay = UnderWay::kMost;

  struct Settings {
    std::string url;                             ///< in notices and statistics
    std::string name;                            ///< of this hub, for the others
    std::size_t frames_a_message = kMostFrames;  ///< at most; 1..kMostFrames
    std::uint32_t bit_rate = 0;                  ///< of the bus (bit/s); 0: frames take no time
  };
  /// The wire is whole or cut: to be passed on to Medium::set_up() and to the members.
  using OnLink = std::function<void(bool up, canopen::TimePoint now)>;

  /// Carries the frames of @p medium, which is cut until the stream is open. @p lease is that of the arbiter, if
  /// the bus has a bit rate.
  Trunk(Medium& medium, std::unique_ptr<Stream> stream, Settings settings, OnLink on_link, Notice notice,
        std::unique_ptr<Lease> lease = nullptr);
  Trunk(const Trunk&) = delete;
  Trunk& operator=(const Trunk&) = delete;
  ~Trunk() override;

  [[nodiscard]] int descriptor() const noexcept override { return stream_->descriptor(); }
  void on_readable(canopen::TimePoint now) noexcept override;
  [[nodiscard]] canopen::TimePoint next_deadline() const noexcept override;
  void on_time(canopen::TimePoint now) noexcept override;
  [[nodiscard]] bool statistics(userbus::MemberStatistics& row) const noexcept override {
    row = row_of(*this);
    return true;
  }

  [[nodiscard]] bool has_room(std::uint32_t station) const noexcept override {
    return outgoing_.has_room(station);
  }
  void take(const Passage& passage, canopen::TimePoint now) noexcept override;
  void on_detach(const Participant& participant) noexcept override { outgoing_.forget(participant); }
  [[nodiscard]] Identity identity() const noexcept override {
    Identity who;
    settings_.url.copy(who.name.data(), who.name.size() - 1);
    return who;
  }
  [[nodiscard]] std::string report(std::size_t room) const override {
    return report_of(*this, medium_.lost(), room);
  }

  [[nodiscard]] bool is_up() const noexcept { return phase_ == Phase::Up; }
  [[nodiscard]] const Figures& figures() const noexcept { return figures_; }
  [[nodiscard]] const Hubs& hubs() const noexcept { return incoming_.hubs(); }
  [[nodiscard]] std::size_t under_way() const noexcept { return outgoing_.under_way(); }
  /// From taking a frame until it passes.
  [[nodiscard]] const Latency& latency() const noexcept { return outgoing_.latency(); }
  [[nodiscard]] const Settings& settings() const noexcept { return settings_; }
  /// nullptr if the bus has no bit rate.
  [[nodiscard]] const Arbitration* arbitration() const noexcept { return arbitration_.get(); }

 private:
  /// No stream; open, but the first beat, and with a bit rate the arbiter's answer, has not come back; frames
  /// pass; others run the bus at another bit rate.
  enum class Phase : std::uint8_t { Closed, Joining, Up, Refused };

  [[nodiscard]] bool stood_still(canopen::TimePoint now) noexcept;
  void open(canopen::TimePoint now) noexcept;
  void join(canopen::TimePoint now) noexcept;
  void come_up(canopen::TimePoint now) noexcept;
  void drop(std::string_view reason, canopen::TimePoint now) noexcept;
  void cut(std::string_view reason, canopen::TimePoint now) noexcept;
  void part(std::string_view reason, canopen::TimePoint now) noexcept;
  void read(canopen::TimePoint now) noexcept;
  void take_message(const Stream::Message& message, canopen::TimePoint now) noexcept;
  void meet_other_bus(const Reader& reader, canopen::TimePoint now) noexcept;
  void refuse(const Reader& reader, canopen::TimePoint now) noexcept;
  [[nodiscard]] bool is_obeyed(const Reader& reader, bool is_stale, canopen::TimePoint now) noexcept;
  void follow(const Header& header, canopen::TimePoint now) noexcept;
  void take_own(const Reader& reader, const Stream::Message& message, bool is_stale,
                canopen::TimePoint now) noexcept;
  void take_foreign(const Reader& reader, const Stream::Message& message, bool is_stale,
                    canopen::TimePoint now) noexcept;
  void answer(const Header& header, canopen::TimePoint now) noexcept;
  void beat(canopen::TimePoint now) noexcept;
  void arbitrate(canopen::TimePoint now) noexcept;
  void miss_own(canopen::TimePoint now) noexcept;

  Medium& medium_;
  std::unique_ptr<Stream> stream_;
  Settings settings_;
  OnLink on_link_;
  Notices notices_;
  std::unique_ptr<Arbitration> arbitration_;  ///< nullptr: the bus has no bit rate
  Figures figures_;
  Outgoing outgoing_;
  Incoming incoming_;
  Phase phase_ = Phase::Closed;
  bool was_up_ = false;
  std::uint64_t sequence_ = 0;   ///< of the last message of the stream; 0: none since it was opened
  canopen::TimePoint heard_{};   ///< when a message that this hub has sent came back
  canopen::TimePoint looked_{};  ///< when the hub was last seen to run
  canopen::TimePoint next_beat_{};
  canopen::TimePoint refused_until_{};
  std::int64_t joined_at_ = 0;    ///< time stamp of the first beat of the epoch; 0: it has not come back
  bool is_failure_told_ = false;  ///< that the first beat does not come back
  bool has_more_ = false;         ///< messages that have come in and were not taken yet
};

}  // namespace hub::trunk
