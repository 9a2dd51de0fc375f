#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "can/hub/faults/late_frames.hpp"
#include "can/hub/faults/loaded_fault.hpp"
#include "can/hub/medium/medium.hpp"

namespace hub::faults {

/// The faults of a bus. While there are none the medium knows nothing of them.
///
/// Every frame of the wire is shown to all faults in the order of their numbers, error frames to those alone that
/// cut the line. The sender hears its frame as it was sent, whatever becomes of it.
class Faults final : private Interference {
 public:
  /// Faults that there may be at a time.
  static constexpr std::size_t kMost = 64;

  /// Of @p medium, whose names are @p interfaces; both outlive this.
  Faults(Medium& medium, Interfaces& interfaces) noexcept : medium_{medium}, interfaces_{interfaces} {}
  Faults(const Faults&) = delete;
  Faults& operator=(const Faults&) = delete;
  ~Faults() override;

  /// Loads the fault that @p said is, an object or a text of words; its number, or one line that says what is
  /// wrong. std::bad_alloc.
  tl::expected<std::uint32_t, std::string> inject(const nlohmann::json& said, canopen::TimePoint now);
  /// All that are loaded, those that are over included, with what has come of them.
  [[nodiscard]] nlohmann::json list(canopen::TimePoint now);
  /// Takes back fault @p number, or all; how many that were. Frames that are late come nevertheless.
  std::size_t take_back(std::optional<std::uint32_t> number) noexcept;
  /// Late frames that found no room.
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_; }

 private:
  class Hearers;

  void on_end(const Passage& passage, const Identity& sender, canopen::TimePoint end) noexcept override;
  void on_detach(const Participant& participant) noexcept override;
  [[nodiscard]] canopen::TimePoint next_deadline() const noexcept override;
  void on_time(canopen::TimePoint now) noexcept override;

  void find_cuts(canopen::TimePoint now) noexcept;
  [[nodiscard]] bool is_parted(const can_frame& frame, const Identity& one, const Identity& other) const noexcept;
  void hand_out(const Passage& passage, const Fate& fate, const Identity& sender, canopen::TimePoint end) noexcept;
  void give_others(const Identity& sender) noexcept;
  void keep(const Passage& passage, const Fate& fate, const Identity& sender, canopen::TimePoint end) noexcept;
  void release(canopen::TimePoint now) noexcept;
  [[nodiscard]] std::uint32_t wanted_bit_rate() const noexcept;

  Medium& medium_;
  Interfaces& interfaces_;
  std::vector<std::unique_ptr<LoadedFault>> faults_;
  std::uint32_t last_number_ = 0;
  std::uint32_t own_bit_rate_ = 0;        ///< that of the bus without faults
  bool at_work_ = false;                  ///< the medium asks this
  std::vector<const LoadedFault*> cuts_;  ///< that hold for the frame that is being handed out
  LateFrames late_;
  std::uint64_t lost_ = 0;
  Passage given_;           ///< what others than the sender hear
  bool repeating_ = false;  ///< the next end is that of given_, a second time
};

}  // namespace hub::faults
