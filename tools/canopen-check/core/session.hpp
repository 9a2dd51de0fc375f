#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "libcanopen/base/nmt_state.hpp"
#include "tools/canopen-check/core/wire.hpp"

namespace conformance {

/// What a frame has to be.
using Condition = std::function<bool(const canopen::Frame&)>;

/// True for data frames of 11 bits under @p identifier.
[[nodiscard]] Condition under(std::uint32_t identifier);

/// The traffic of one check: everything sent and received is kept, in order.
class Session {
 public:
  /// Tests the node @p node_id (1..127) over @p wire.
  Session(Wire& wire, std::uint8_t node_id) : wire_{&wire}, node_id_{node_id} {}

  [[nodiscard]] std::uint8_t node_id() const noexcept { return node_id_; }
  /// @p function plus the node-ID, an identifier of the predefined connection set.
  [[nodiscard]] std::uint32_t identifier(std::uint32_t function) const noexcept { return function + node_id_; }
  [[nodiscard]] canopen::TimePoint now() const { return wire_->now(); }
  [[nodiscard]] bool carries_remote_frames() const { return wire_->carries_remote_frames(); }

  /// Sends @p frame; false, and nothing sent, once the session has ended.
  bool send(const canopen::Frame& frame);
  /// Sends an NMT command to the node.
  bool command(canopen::NmtCommand command) { return command_to(node_id_, command); }
  /// Sends an NMT command to @p node_id; 0 is every node.
  bool command_to(std::uint8_t node_id, canopen::NmtCommand command);
  /// The next frame of another station, at @p until the latest; nothing at once when the session has ended.
  std::optional<TimedFrame> next(canopen::TimePoint until);
  /// The first frame within @p patience that fulfils @p condition; others are passed over, but kept.
  std::optional<TimedFrame> wait_for(const Condition& condition, canopen::Duration patience);
  /// The first @p count frames that fulfil @p condition, or fewer if @p span passes before.
  std::vector<TimedFrame> collect_first(std::size_t count, const Condition& condition, canopen::Duration span);
  /// Every frame that fulfils @p condition during @p span.
  std::vector<TimedFrame> collect(const Condition& condition, canopen::Duration span);
  /// Lets @p span pass.
  void pass(canopen::Duration span);
  /// Takes what waits already.
  void drain();
  /// From now on no reset command is sent.
  void forbid_resets() noexcept { resets_ = false; }
  /// The last emergency message under the identifier of the predefined connection set.
  [[nodiscard]] const std::optional<canopen::Frame>& emergency() const noexcept { return emergency_; }

  /// A place in the traffic, for since().
  [[nodiscard]] std::size_t mark() const noexcept { return frames_.size(); }
  /// The traffic from @p mark on, at most kMostFrames of it.
  [[nodiscard]] std::span<const TimedFrame> since(std::size_t mark) const noexcept;
  /// Takes up traffic of before once more, as evidence.
  void recall(std::span<const TimedFrame> frames) { frames_.insert(frames_.end(), frames.begin(), frames.end()); }
  /// Forgets the traffic.
  void forget() noexcept { frames_.clear(); }

  /// True when the bus went down or the user interrupts: nothing is sent or received then, and no time passes.
  [[nodiscard]] bool ended() const { return !wire_->up() || (wire_->interrupted() && !cleaning_); }
  [[nodiscard]] bool bus_is_up() const { return wire_->up(); }
  [[nodiscard]] bool interrupted() const { return wire_->interrupted(); }
  /// From now on an interruption does not end the session: what was changed is restored.
  void clean_up(bool cleaning) noexcept { cleaning_ = cleaning; }

 private:
  static constexpr std::size_t kMostFrames = 200'000;

  /// What comes until a point in time, and what waited then; a bus on which there is always something to take ends
  /// it too.
  class Window {
   public:
    Window(Session& session, canopen::TimePoint until) : session_{&session}, until_{until} {}
    [[nodiscard]] std::optional<TimedFrame> next();

   private:
    static constexpr unsigned kMostLate = 10'000;

    Session* session_;
    canopen::TimePoint until_;
    unsigned late_ = 0;  ///< frames taken behind that point
  };

  void keep(const TimedFrame& frame);

  Wire* wire_;
  std::uint8_t node_id_;
  bool cleaning_ = false;
  bool resets_ = true;
  std::optional<canopen::Frame> emergency_{};
  std::vector<TimedFrame> frames_;
};

}  // namespace conformance
