#pragma once

#include <cstdint>
#include <optional>

#include "cia402/modes/profile/set_point.hpp"

namespace cia402 {

/// The handshake of profile position (CiA 402-2): a place for the set-point that is positioned to, one for the
/// next.
class SetPointPlaces {
 public:
  /// What became of a write of the controlword.
  enum class Taken : std::uint8_t { None, Running, Waiting };

  /// A write of the controlword, which was @p former before: bit 4 from 0 to 1 gives a set-point, but not while
  /// halt is set, nor while the last one is acknowledged; a set-point that changes immediately takes the place of
  /// both even where only the waiting one holds the acknowledgement.
  Taken controlword(std::uint16_t word, std::uint16_t former, const ProfilePositionSettings& settings) noexcept;
  /// The running set-point is reached.
  void reach() noexcept;
  /// The waiting set-point becomes the running one.
  void advance() noexcept;
  /// No set-point, no acknowledgement.
  void clear() noexcept;

  const std::optional<SetPoint>& running() const noexcept { return running_; }
  const std::optional<SetPoint>& waiting() const noexcept { return waiting_; }
  /// Set-point acknowledge (6041h bit 12).
  bool acknowledges() const noexcept { return acknowledges_; }

 private:
  bool takes(std::uint16_t word, std::uint16_t former) const noexcept;
  void release(bool falls) noexcept;

  std::optional<SetPoint> running_{};
  std::optional<SetPoint> waiting_{};
  SetPoint::Response response_ = SetPoint::Response::PlaceFree;  // of the last one
  bool acknowledges_ = false;
  bool new_set_point_ = false;  // bit 4
};

}  // namespace cia402
