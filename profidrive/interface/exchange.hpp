#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "drive/object/drive_object.hpp"
#include "profidrive/interface/monitoring.hpp"
#include "profidrive/interface/sign_of_life.hpp"
#include "profidrive/telegram/telegram_wiring.hpp"

namespace profidrive {

/// Bit 10 of STW1.
inline constexpr std::uint16_t kControlByPlc = 1U << 10;

/// What a drive object without control by PLC (bit 10 of STW1) makes of the words that come (p2037).
enum class WithoutControl : std::uint8_t {
  Freeze = 0,  ///< they stay as they were, but for the sign of life
  FreezeWithSignOfLife = 1,
  TakeAll = 2
};

/// The process data of one drive object on IF1.
class Exchange {
 public:
  static constexpr std::size_t kMostWords = drive::If1Image::kReceivedWords;
  using Words = std::array<std::uint16_t, kMostWords>;

  explicit Exchange(drive::DriveObject& object) noexcept;

  drive::DriveObject& object() const noexcept { return *object_; }
  /// What p0922 and p2079 have selected.
  const Selection& selection() const noexcept { return selection_; }
  void select(const Selection& selection) noexcept;
  /// Parameter @p number of the drive object has value @p value: p2037, p2044, p2045 and p0925 are known here.
  void follow(std::uint16_t number, double value) noexcept;
  /// All of them are as the drive object has them.
  void follow_parameters() noexcept;
  /// p2044.
  unit::Duration fault_delay() const noexcept { return fault_delay_; }
  /// p0925.
  std::uint16_t tolerance() const noexcept { return tolerance_; }

  /// Words @p first and following come.
  void receive(std::span<const std::uint16_t> words, std::size_t first) noexcept;
  bool has_new() const noexcept { return has_new_; }
  /// A cycle begins: what has come acts.
  void take() noexcept;
  /// A cycle ends: what is sent is what the drive object has put out, with bits 8 and 12 to 15 of the words that
  /// have them. @p synchronised: the clock of the unit is.
  void sample(bool synchronised) noexcept;

  /// As they act, as far as the drive object has them.
  std::span<const std::uint16_t> received() const noexcept {
    return std::span{object_->if1().received}.first(received_words_);
  }
  /// As of the last sample().
  std::span<const std::uint16_t> sent() const noexcept { return std::span{sent_}.first(sent_words_); }
  /// The sign of life in the words that have come last, if there is one that counts now.
  std::optional<unsigned> received_sign_of_life() const noexcept;

  Monitoring monitoring;
  SignOfLife sign_of_life;
  bool connection_lost = false;  ///< A01925

 private:
  bool is_frozen() const noexcept;
  std::optional<std::size_t> place_of(double source) const noexcept;

  drive::DriveObject* object_;
  std::size_t received_words_;
  std::size_t sent_words_;
  Selection selection_{};
  std::optional<std::size_t> sign_of_life_sent_;
  std::optional<std::size_t> synchronised_sent_;
  std::optional<std::size_t> sign_of_life_received_;  ///< by p2045
  WithoutControl without_control_ = WithoutControl::Freeze;
  unit::Duration fault_delay_{};
  std::uint16_t tolerance_ = 0;
  bool has_new_ = false;
  Words pending_{};
  Words sent_{};
};

}  // namespace profidrive
