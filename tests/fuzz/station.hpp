#pragma once

#include <array>
#include <vector>

#include "libcanopen/node/node.hpp"
#include "tests/fuzz/domain.hpp"
#include "tests/fuzz/legal_frames.hpp"
#include "tests/fuzz/upload_watch.hpp"

namespace fuzz {

/// What the application of a Station answers next.
struct Answers {
  bool store = true, restore = true, judged_number = true, judged_text = true;
};

/// A node over table() with everything behind it. Every event is followed by a look at what the node sent and at
/// what it holds; the program ends where CiA 301 or the contract of the library is broken.
class Station final : private canopen::FrameSink, private canopen::Application, private canopen::EntryOwner {
 public:
  explicit Station(const canopen::Policy& policy);

  /// The node is as it was after construction, and has booted.
  void reset();
  /// A frame comes from the bus.
  void receive(const canopen::Frame& frame);
  /// Time passes; every deadline is met, up to a few dozen, or only the end of the time is told.
  void pass(canopen::Duration time, bool meets_deadlines);
  /// Time passes to the next deadline, if there is one.
  void pass_to_deadline();
  /// The application changes a number and tells the node.
  void set(const canopen::Entry& entry, std::int64_t value);
  /// Anything else that the owner of the node may do.
  template <class Action>
  void act(const Action& action) {
    begin();
    action(node_, now_);
    finish(Parameters::MayChange);
  }
  /// Writes every frame and what is told to standard output from now on.
  void trace() noexcept { is_traced_ = true; }
  /// Looks at what only shows in the end: limits, unfinished writes.
  void finish_run();

  canopen::Dictionary& dictionary() noexcept { return dictionary_; }
  const canopen::Node& node() const noexcept { return node_; }
  const LegalFrames& legal() const noexcept { return after_; }
  std::array<Domain, kDomains>& domains() noexcept { return domains_; }
  Answers& answers() noexcept { return answers_; }
  /// The time that the node was told last.
  canopen::TimePoint now() const noexcept { return now_; }
  /// A number that tells runs apart: all that was sent and told since reset().
  std::uint64_t transcript() const noexcept { return transcript_; }

 private:
  static constexpr std::size_t kMostFrames = 512;  ///< that one event may cause

  void send(const canopen::Frame& frame, canopen::Delivery delivery) override;
  void on_nmt_state(canopen::NmtState from, canopen::NmtState to) noexcept override;
  void on_reset(canopen::NmtCommand command) noexcept override { note(0x200 + static_cast<unsigned>(command)); }
  void on_rpdo(std::uint16_t number) noexcept override { note(0x300U + number); }
  void on_sync(std::uint8_t counter) noexcept override { note(0x400U + counter); }
  void on_foreign_frame(std::uint32_t identifier) noexcept override { note(0x500 + identifier); }
  void on_communication_error(canopen::CommunicationError error, std::uint16_t detail) noexcept override;
  void on_communication_recovery(canopen::CommunicationError error, std::uint16_t detail) noexcept override;
  void on_heartbeat(std::uint8_t node_id, canopen::NmtState state) noexcept override;
  void on_time_of_day(const canopen::TimeOfDay& time) noexcept override { note(time.milliseconds ^ time.days); }
  canopen::Result<void> on_store(std::uint8_t sub_index) noexcept override;
  canopen::Result<void> on_restore(std::uint8_t sub_index) noexcept override;
  canopen::Result<void> write(const canopen::Entry& entry, std::int64_t value) override;
  canopen::Result<void> write_text(const canopen::Entry& entry, std::span<const std::uint8_t> text) override;

  void say(const char* who, const canopen::Frame& frame) const;
  void note(std::uint64_t fact) noexcept { transcript_ = (transcript_ ^ fact) * 0x9E3779B97F4A7C15U + 1; }
  enum class Parameters : bool { Stay, MayChange };
  void begin() noexcept;
  void finish(Parameters parameters) noexcept;
  void check_frame(const canopen::Frame& frame) const noexcept;
  bool is_legal(const canopen::Frame& frame, const LegalFrames& legal) const noexcept;
  void check_answers(std::size_t asked, std::size_t at_once, const canopen::Frame& request) noexcept;
  std::size_t server_of(const canopen::Frame& frame) const noexcept;
  void check_subscriptions() const noexcept;
  void check_limits() const noexcept;

  canopen::Dictionary dictionary_;
  canopen::Node node_;
  LegalFramesReader reader_;
  canopen::Duration timeout_;
  canopen::NmtState state_after_reset_;
  LegalFrames before_, after_;
  std::array<Domain, kDomains> domains_{};
  Answers answers_;
  UploadWatch watch_;
  canopen::TimePoint now_{std::chrono::hours{1}};
  canopen::NmtState state_before_ = canopen::NmtState::Initialising;
  std::vector<canopen::Frame> sent_;
  std::uint64_t transcript_ = 0;
  bool is_traced_ = false;
};

}  // namespace fuzz
