#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "libcanopen/base/time.hpp"

namespace hub {

class Participant;
struct Identity;
struct Passage;

/// What takes the frames of a Medium to those of other hosts: a frame has passed, here and elsewhere, when it
/// comes back (Medium::pass()), and all media get their frames back in one order.
class Carrier {
 public:
  Carrier() = default;
  Carrier(const Carrier&) = delete;
  Carrier& operator=(const Carrier&) = delete;
  virtual ~Carrier() = default;

  /// False while as many frames are under way as may be, of all or of station @p number: Medium::go_on() tells
  /// when that has changed.
  [[nodiscard]] virtual bool has_room(std::uint32_t number) const noexcept = 0;
  /// Takes @p passage along; only while its station has_room().
  virtual void take(const Passage& passage, canopen::TimePoint now) noexcept = 0;
  /// @p participant leaves: what is under way of it passes without a sender.
  virtual void on_detach(const Participant& participant) noexcept = 0;
  /// What has become of frames, and who else is on the bus: JSON, at most @p room bytes.
  [[nodiscard]] virtual std::string report(std::size_t room) const = 0;
  /// As whom an Interference knows who has sent what comes from other hosts.
  [[nodiscard]] virtual Identity identity() const noexcept = 0;
};

}  // namespace hub
