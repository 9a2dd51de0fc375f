#pragma once

#include <array>
#include <vector>

#include "libcanopen/sdo/command.hpp"
#include "libcanopen/sdo/domain_locks.hpp"
#include "libcanopen/sdo/download_sink.hpp"
#include "libcanopen/sdo/upload_source.hpp"
#include "libcanopen/service/context.hpp"
#include "libcanopen/service/sdo_answer_counters.hpp"

namespace canopen {

/// One SDO server (CiA 301, 7.2.4): expedited, segmented and block transfer, one transfer at a time. Every request
/// gets its answer within the call, unless the owner of what is written puts it off; a refusal is an abort frame.
class alignas(64) SdoServer {
 public:
  /// @p timer is the number of its timer in the context's queue, @p position its own one in @p locks, @p number
  /// that of its object: 0 for 1200h.
  SdoServer(Context& context, std::size_t timer, sdo::DomainLocks& locks, std::size_t position,
            std::uint8_t number);

  /// Listens to @p request and answers under @p response from now on; 0 and 0: the server does not exist. False if
  /// nothing changes, otherwise the transfer that it had is forgotten.
  bool connect(Identifier request, Identifier response) noexcept;
  /// What it listens to, 0 if it does not exist.
  Identifier request_identifier() const noexcept { return request_identifier_; }
  /// What it answers under, 0 if it does not exist.
  Identifier response_identifier() const noexcept { return identifier_of(answer_); }

  /// A data frame of the client. A frame that is not eight bytes long is ignored.
  void on_frame(const Frame& frame) noexcept;
  /// The same where the view of the context says what the server shows.
  void on_viewed_frame(const Frame& frame) noexcept;
  /// A half-finished transfer has been silent: confirms a sub-block of a download early, once, after half the time
  /// that the policy allows; aborts the transfer with ProtocolTimedOut after all of it. Segments out of order are
  /// heard, but do not keep a block download alive.
  void on_timer() noexcept;
  /// Answers a write whose answer was put off, if the client still waits for it.
  void answer_deferred(const Result<void>& result) noexcept;
  /// Forgets a half-finished transfer without a word (NMT state change).
  void forget() noexcept { end(); }
  const SdoAnswerCounters& answers() const noexcept { return answers_; }

 private:
  /// What the server waits for; from BlockDownload on a frame is not taken for a request by its first byte alone.
  enum class Phase : std::uint8_t {
    Idle,                ///< the first request of a transfer
    Upload,              ///< a request for a segment
    Download,            ///< a segment
    BlockUploadStart,    ///< the start of a block upload
    BlockUploadConfirm,  ///< the confirmation of the sub-block that was sent
    BlockUploadEnd,      ///< the confirmation of the end
    BlockDownloadEnd,    ///< the end of a block download
    BlockDownload,       ///< a segment of a sub-block: the first byte is a sequence number
    Deferred,            ///< nothing: the owner of what was written gives the answer (Node::answer_deferred())
  };
  // server.cpp: expedited transfer, beginning and end of the others
  void initiate_upload(const Frame& frame) noexcept;
  void initiate_download(const Frame& frame) noexcept;
  void upload_expedited(const Entry& entry, sdo::Address at) noexcept;
  void download_expedited(const Entry& entry, const Frame& frame, std::size_t size) noexcept;
  Result<void> write_expedited(const Entry& entry, std::span<const std::uint8_t> bytes) noexcept;
  /// An initiate request ends the transfer before it without a word, and finds its entry; nullptr if there is
  /// none.
  const Entry* find(sdo::Address at) noexcept {
    if (phase_ != Phase::Idle) end();
    return context_.dictionary.lookup(at.index, at.sub_index);
  }
  Result<void> open_source(const Entry& entry) noexcept;
  Result<void> open_sink(const Entry& entry, std::optional<std::uint32_t> size) noexcept;
  void begin(Phase phase, sdo::Address at) noexcept;
  void end() noexcept;
  void finish_download(std::uint64_t answer) noexcept;
  void defer(sdo::Address at, std::uint64_t bytes, std::uint64_t request) noexcept;
  void on_awaited_frame(const Frame& frame) noexcept;
  TimePoint due() const noexcept;
  bool may_confirm_early() const noexcept { return phase_ == Phase::BlockDownload && !confirmed_early_; }
  void abort(sdo::Address at, AbortCode code) noexcept;
  void abort(AbortCode code) noexcept { abort(address_, code); }
  void refuse_command() noexcept;

  // segmented.cpp
  void begin_segmented_upload(sdo::Address at) noexcept;
  void initiate_segmented_download(const Entry& entry, const Frame& frame) noexcept;
  void begin_segmented_download(sdo::Address at) noexcept;
  void upload_segment(sdo::CommandByte command) noexcept;
  void download_segment(const Frame& frame) noexcept;
  bool continues(Phase phase, sdo::CommandByte command) noexcept;

  // block_upload.cpp
  void on_block_upload(const Frame& frame) noexcept;
  void initiate_block_upload(const Frame& frame) noexcept;
  void begin_block_upload(const Frame& frame) noexcept;
  void send_sub_block() noexcept;
  void take_confirmation(const Frame& frame) noexcept;
  void send_block_end() noexcept;

  // block_download.cpp
  void on_block_download(const Frame& frame) noexcept;
  void initiate_block_download(const Frame& frame) noexcept;
  void begin_block_download(const Frame& frame) noexcept;
  void take_block_segment(const Frame& frame) noexcept;
  void keep_segment(std::span<const std::uint8_t> bytes, bool last) noexcept;
  void confirm_sub_block() noexcept;
  void confirm_early() noexcept;
  void end_block_download(const Frame& frame) noexcept;

  // viewed.cpp
  bool begins_transfer(sdo::CommandByte command) const noexcept;
  void initiate_viewed(const Frame& frame) noexcept;
  void upload_viewed(sdo::ViewedObject object) noexcept;
  void send_viewed(sdo::Address at) noexcept;
  void upload_viewed_block(sdo::ViewedObject object, const Frame& frame) noexcept;
  void download_viewed(sdo::ViewedObject object, const Frame& frame) noexcept;
  void gather_viewed(sdo::ViewedObject object, const Frame& frame) noexcept;
  void gather_viewed_block(sdo::ViewedObject object, const Frame& frame) noexcept;

  void send(std::uint64_t bytes) noexcept {
    store(answer_.data.data(), bytes);
    deliver(answer_);
  }
  void deliver(const Frame& answer) noexcept {
    answers_.count_frame();
    context_.sink->send(answer, Delivery::Ordered);
  }
  std::uint64_t abort_answer(sdo::Address at, AbortCode code) noexcept {
    answers_.count_abort(code);
    return sdo::abort_bytes(at, code);
  }

  Context& context_;
  sdo::DomainLocks& locks_;
  std::size_t timer_;
  std::size_t position_;
  std::uint64_t deferred_request_ = 0;  ///< whose answer was put off, 0 = of several frames
  Identifier request_identifier_ = 0;
  Frame answer_{};  ///< identifier and length stand, the data are those of the last answer

  std::uint8_t number_;
  Phase phase_ = Phase::Idle;
  std::uint8_t toggle_ = 0;    ///< expected in the next segment: 0 or 10h
  sdo::Address address_;       ///< of the transfer
  std::uint16_t crc_ = 0;      ///< block: of the bytes that count already
  TimePoint last_request_{};   ///< or the server's early confirmation
  TimePoint last_progress_{};  ///< block download: the last segment in order

  std::optional<AbortCode> refusal_;  ///< block download: waits for the end of the sub-block
  bool crc_wanted_ = false;           ///< block: the client uses CRC
  bool confirmed_early_ = false;      ///< block download: the client's silence has been answered
  bool must_restart_ = false;         ///< block download: segment 1 must come, segments were confirmed early
  bool last_sent_ = false;            ///< block upload: the sub-block ends the data
  std::uint8_t block_size_ = 0;       ///< block upload: most segments in the next sub-block
  std::uint8_t sequence_ = 0;         ///< block: last segment sent, or taken in order, in the sub-block
  std::uint8_t last_size_ = 0;        ///< block upload: bytes in the last segment
  std::array<std::uint8_t, 7>
      last_segment_{};  ///< block download: how many of its bytes count, only the end tells

  SdoAnswerCounters answers_;
  std::vector<std::uint8_t> buffer_;  ///< the window of the two below
  sdo::UploadSource source_;
  sdo::DownloadSink sink_;
};

}  // namespace canopen
