#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "audit/base/findings.hpp"
#include "audit/base/transfer.hpp"
#include "audit/sdo/block_data.hpp"

namespace audit {

/// What passes on one channel of SDO, with the eyes of somebody who knows what the client may send next.
class Dialogue {
 public:
  /// @p has_times: frames have times; else any pause may be between two of them.
  Dialogue(meaning::SdoChannel channel, bool has_times) : channel_{channel}, has_times_{has_times} {}

  /// Takes a request of the client; the transfer that it ends, as an abort does.
  std::optional<Transfer> take_request(const Heard& heard, Findings& findings);
  /// Takes an answer of the server; the transfer that it ends.
  std::optional<Transfer> take_response(const Heard& heard, Findings& findings);
  /// The node is reset by @p heard: its server forgets what it was doing.
  void reset(const Heard& heard, Findings& findings);
  /// The node has booted: its server has forgotten what it was doing, which the client does not know.
  void take_boot_up();
  /// There are no more frames; @p at: when the last one of the bus came.
  void end(canopen::Duration at, Findings& findings);

 private:
  /// Who is to send what.
  enum class Phase : std::uint8_t {
    Unknown,       ///< nothing was heard yet: a transfer may be under way
    Idle,          ///< the client may begin a transfer
    Initiated,     ///< the server answers the initiate request of a transfer
    Segments,      ///< the client goes on with a segment
    SegmentAsked,  ///< the server answers that
    BlockReady,    ///< the client starts a block upload
    BlockSent,     ///< the client sends segments of a block download
    BlockEnding,   ///< the server answers the last segment of a block, or the end of the download
    BlockHeard,    ///< the server sends segments of a block upload
    BlockConfirm,  ///< the client confirms them, or the end of the upload
  };
  enum class Kind : std::uint8_t { Normal, Block };

  void begin(const Heard& heard, Findings& findings);
  void forget();
  std::optional<Transfer> take_abort(const Heard& heard, Findings& findings);
  [[nodiscard]] bool is_behind_abort(const Heard& heard);
  [[nodiscard]] bool has_crossed(const Heard& abort) const noexcept;
  [[nodiscard]] bool refuses_answer(const Heard& abort) const noexcept;
  void report_left_open(const Heard& last, Findings& findings) const;
  void note_unanswered(const Heard& heard, Findings& findings);

  // answers.cpp: what the server answers
  std::optional<Transfer> take_initiated(const Heard& heard);
  void note_repetition(const Heard& heard, Findings& findings);
  void note_late(const Heard& heard, Findings& findings);

  // segments.cpp: expedited transfers and those in segments
  void begin_download(const Heard& heard, Findings& findings);
  bool expects_segment(const Heard& heard, bool is_write, Findings& findings);
  void take_download_segment(const Heard& heard, Findings& findings);
  void take_upload_segment_request(const Heard& heard, Findings& findings);
  std::optional<Transfer> take_segment_answer(const Heard& heard);

  // blocks.cpp: transfers in blocks
  void begin_block(const Heard& heard, bool is_write, Findings& findings);
  void start_block_download(const canopen::Frame& answer);
  void take_block_segment(const Heard& heard, Findings& findings);
  void take_block_end(const Heard& heard, Findings& findings);
  std::optional<Transfer> take_block_upload(const Heard& heard, Findings& findings);
  std::optional<Transfer> take_block_answer(const Heard& heard);
  void take_block_upload_segment(const Heard& heard);
  void drop_segments(std::uint8_t confirmed);

  [[nodiscard]] bool awaits_server() const noexcept {
    return phase_ == Phase::Initiated || phase_ == Phase::SegmentAsked || phase_ == Phase::BlockEnding;
  }
  [[nodiscard]] bool is_open() const noexcept { return phase_ > Phase::Initiated; }
  [[nodiscard]] std::string object() const;
  void blame(const Rule& rule, const Heard& heard, Findings& findings, const std::string& text);
  Transfer finished(Transfer::End end, const Heard& last, std::uint32_t code = 0);
  void add_bytes(const std::uint8_t* data, std::size_t size) noexcept;
  void drop_bytes(std::uint64_t size) noexcept;

  meaning::SdoChannel channel_;
  bool has_times_;
  Phase phase_ = Phase::Unknown;
  Kind kind_ = Kind::Normal;
  Transfer transfer_{};
  Heard asked_{};                           ///< the request that awaits its answer
  std::optional<std::uint64_t> told_size_;  ///< of the transfer
  std::uint8_t toggle_ = 0;
  bool is_last_ = false;       ///< the last segment is sent, or asked for
  bool has_answered_ = false;  ///< the server, at any time
  bool has_rebooted_ = false;  ///< since the transfer began
  bool has_gap_ = false;       ///< a segment of a block did not follow the one before
  BlockData block_{};
  std::optional<Heard> aborted_;   ///< by the server: the last frame of the channel
  std::optional<Heard> given_up_;  ///< the request whose answer was not awaited
  Heard refused_{};                ///< the initiate request that the server aborted last
  std::uint32_t refusals_ = 0;     ///< of it without a success between
};

}  // namespace audit
