#pragma once

#include <vector>

#include "libcanopen/base/export.hpp"
#include "libcanopen/node/context.hpp"
#include "libcanopen/sdo/command.hpp"

namespace canopen {

/// One SDO server (CiA 301, 7.2.4): expedited and segmented transfer, one at a time. Every request gets its answer
/// within the call; a refusal is an abort frame.
class CANOPEN_EXPORT SdoServer {
 public:
  /// @p timer is the number of its timer in the context's queue.
  SdoServer(Context& context, std::size_t timer);

  /// Listens to @p request and answers under @p response from now on; 0 and 0: the server does not exist.
  void connect(Identifier request, Identifier response) noexcept;
  /// What it listens to, 0 if it does not exist.
  Identifier request_identifier() const noexcept { return request_identifier_; }
  /// What it answers under, 0 if it does not exist.
  Identifier response_identifier() const noexcept { return response_identifier_; }

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
  std::size_t timer_;
  Identifier request_identifier_ = 0;
  Identifier response_identifier_ = 0;

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
