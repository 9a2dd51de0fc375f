#pragma once

#include <cstdint>
#include <memory>

#include "can/hub/notices.hpp"
#include "can/hub/trunk/arbiter.hpp"
#include "can/hub/trunk/lease/candidate.hpp"
#include "can/hub/trunk/lease/lease.hpp"
#include "can/hub/trunk/stream.hpp"
#include "can/hub/trunk/terms.hpp"

namespace hub::trunk {

/// What a hub of a bus with a bit rate does beside sending and receiving: it knows whom to obey, seeks to become
/// the arbiter while there is none, and is it if it has gained the lease.
class Arbitration {
 public:
  using Verdict = Terms::Verdict;

  /// @p stream, @p notices outlive this; @p hub is this hub's number, @p bit_rate in bit/s.
  Arbitration(Stream& stream, std::unique_ptr<Lease> lease, Notices& notices, std::uint32_t hub,
              std::uint32_t bit_rate);
  Arbitration(const Arbitration&) = delete;
  Arbitration& operator=(const Arbitration&) = delete;
  ~Arbitration() = default;

  /// The stream has been opened, and nothing has come from it.
  void begin(canopen::TimePoint now) noexcept;
  /// This hub is the arbiter no more; the stream is open still if @p is_open.
  void step_down(bool is_open) noexcept;

  /// Judges the next message of an arbiter in the stream (Terms::judge()).
  Verdict judge(const Header& header, bool is_stale, canopen::TimePoint now) noexcept;
  /// The hub of @p header is in that epoch.
  void on_beat(const Header& header) noexcept;
  /// An arbiter takes the requests that have come in and lets pass what has come to its end; @p seen is the time
  /// stamp of the last message of the stream (ns).
  void turn(std::int64_t seen, canopen::TimePoint now) noexcept;
  /// Seeks the lease; true if this hub has become the arbiter, and is to say so.
  [[nodiscard]] bool seek(canopen::TimePoint now) noexcept;

  [[nodiscard]] bool is_arbiter() const noexcept { return own_term_ != 0; }
  /// That this hub is the arbiter in; else that which it obeys.
  [[nodiscard]] std::uint32_t term() const noexcept { return is_arbiter() ? own_term_ : terms_.term(); }
  /// Number of the hub that is obeyed, 0 = none.
  [[nodiscard]] std::uint32_t arbiter() const noexcept { return terms_.arbiter(); }
  /// When there is no arbiter any more, unless something comes of it before.
  [[nodiscard]] canopen::TimePoint quiet_at() const noexcept { return candidate_.quiet_at(); }
  /// When turn() is wanted, or seek(), where this hub @p may_seek.
  [[nodiscard]] canopen::TimePoint next_deadline(bool may_seek) const noexcept;

  /// Frames that wait here for the bus.
  [[nodiscard]] std::size_t waiting() const noexcept { return arbiter_.waiting(); }
  /// Requests that were none.
  [[nodiscard]] std::uint64_t malformed() const noexcept { return malformed_; }

 private:
  void take_request(std::span<const std::byte> bytes, std::int64_t seen, canopen::TimePoint now) noexcept;
  void publish(Header header, std::int64_t seen, const Arbiter::Granted* granted) noexcept;

  Stream& stream_;
  std::unique_ptr<Lease> lease_;
  Notices& notices_;
  Terms terms_;
  Candidate candidate_;
  Arbiter arbiter_;
  std::uint32_t own_term_ = 0;  ///< 0: it is not the arbiter
  bool has_more_ = false;       ///< requests that have come in and were not taken yet
  bool is_unsent_ = false;      ///< the stream has taken a message that it has not sent yet
  std::uint64_t malformed_ = 0;
};

}  // namespace hub::trunk
