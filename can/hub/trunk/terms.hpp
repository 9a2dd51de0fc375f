#pragma once

#include <cstdint>

#include "can/hub/trunk/message.hpp"

namespace hub::trunk {

/// Which arbiter is obeyed. It is decided by what is in the stream alone, so that all hubs decide the same: an
/// arbiter whose term is the highest that was announced, until one of its messages is late.
class Terms {
 public:
  enum class Verdict : std::uint8_t {
    Obey,
    Ignore,  ///< it comes from a hub that is the arbiter no more
    Begin,   ///< a new arbiter, from this message on
    End,     ///< there is no arbiter from this message on, the message included
  };

  /// Judges the next message of an arbiter in the stream; @p is_stale: its sender had not heard from the stream
  /// for too long.
  Verdict judge(const Header& header, bool is_stale) noexcept {
    const bool is_new = header.term > term_ && header.kind == Kind::ArbiterBeat;
    if (!is_new && (header.term != term_ || is_over_)) return Verdict::Ignore;
    if (is_new) {
      term_ = header.term;
      arbiter_ = header.hub;
    }
    is_over_ = is_stale;
    if (is_stale) return Verdict::End;
    return is_new ? Verdict::Begin : Verdict::Obey;
  }
  /// The stream is another one, of which nothing is known.
  void forget() noexcept { *this = {}; }

  /// The highest one that was announced; 0 = none.
  [[nodiscard]] std::uint32_t term() const noexcept { return term_; }
  /// Hub whose term that is, 0 = none.
  [[nodiscard]] std::uint32_t arbiter() const noexcept { return is_over_ ? 0 : arbiter_; }

 private:
  std::uint32_t term_ = 0;
  std::uint32_t arbiter_ = 0;
  bool is_over_ = false;
};

}  // namespace hub::trunk
