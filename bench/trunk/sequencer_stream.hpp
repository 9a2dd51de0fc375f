#pragma once

#include <string_view>

#include "bench/trunk/byte_queue.hpp"
#include "can/hub/trunk/stream.hpp"
#include "os/descriptor.hpp"

namespace bench {

/// The stream that `sequencer` serves. A connection that is given up is not made anew: what was measured does not
/// count then.
class SequencerStream final : public hub::trunk::Stream {
 public:
  /// Connects to @p place ("ADDRESS:PORT"); throws std::system_error.
  explicit SequencerStream(std::string_view place);

  [[nodiscard]] int descriptor() const noexcept override { return socket_.get(); }
  [[nodiscard]] State advance() noexcept override;
  [[nodiscard]] bool receive(Message& message) noexcept override;
  void publish(std::span<const std::byte> bytes) noexcept override;
  void flush() noexcept override;
  void reopen() noexcept override { state_ = State::Opening; }
  [[nodiscard]] std::string take_problem() override { return {}; }

 private:
  os::Descriptor socket_;
  ByteQueue asked_;
  ByteQueue given_;
  std::size_t received_ = 0;  ///< bytes of the message that receive() gave last
  State state_ = State::Open;
};

}  // namespace bench
