#pragma once

#include <vector>

#include "libcanopen/node/context.hpp"
#include "libcanopen/node/policy.hpp"
#include "libcanopen/sdo/command.hpp"

namespace canopen {

/// One SDO server (CiA 301, 7.2.4): expedited and segmented transfer, one at a time. Every request gets its answer
/// within the call; a refusal is an abort frame.
class SdoServer {
 public:
  /// Answers requests under @p response_identifier; @p timer is the number of its timer in the context's queue.
  SdoServer(Context& context, const Policy& policy, std::uint32_t response_identifier, std::size_t timer);

  /// A data frame of the client. A frame that is not eight bytes long is ignored.
  void on_frame(const Frame& frame) noexcept;
  /// A half-finished transfer was silent for too long: aborts it with ProtocolTimedOut.
  void on_timer() noexcept;
  /// Forgets a half-finished transfer without a word (NMT state change).
  void forget() noexcept;

 private:
  enum class Transfer : std::uint8_t { None, Upload, Download };

  void initiate_upload(const Frame& frame) noexcept;
  void initiate_download(const Frame& frame) noexcept;
  void upload_segment(sdo::Command command) noexcept;
  void download_segment(const Frame& frame) noexcept;

  Result<const Entry*> find(sdo::Address at) noexcept;
  Result<void> commit(const Entry& entry, std::span<const std::uint8_t> data, std::uint64_t word) noexcept;
  void begin(Transfer transfer, std::size_t size) noexcept;
  void end() noexcept;
  bool continues(Transfer transfer, sdo::Command command) noexcept;
  void acknowledge_download() noexcept;
  void abort(sdo::Address at, AbortCode code) noexcept;
  void send(const Frame& frame) noexcept { context_.sink.send(frame, Delivery::Ordered); }

  Context& context_;
  const Policy& policy_;
  std::uint32_t response_identifier_;
  std::size_t timer_;

  Transfer transfer_ = Transfer::None;
  std::uint8_t toggle_ = 0;      ///< expected in the next segment: 0 or 10h
  bool size_announced_ = false;  ///< of a download
  sdo::Address address_;
  const Entry* entry_ = nullptr;
  std::size_t size_ = 0;  ///< upload: bytes in all; download: bytes announced
  std::size_t done_ = 0;
  TimePoint last_request_{};
  std::vector<std::uint8_t> buffer_;  ///< the value on its way, so that no half value is ever seen
};

}  // namespace canopen
