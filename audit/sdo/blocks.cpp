#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "audit/sdo/dialogue.hpp"
#include "audit/sdo/sdo_rules.hpp"
#include "libcanopen/base/little_endian.hpp"

namespace audit {

namespace sdo = canopen::sdo;
namespace rules = sdo_rules;

using sdo::CommandByte;
using sdo::Request;

namespace {

constexpr std::uint8_t kBlockPlace = 4;      // of the number of segments in an initiate request or response
constexpr std::uint8_t kConfirmedPlace = 1;  // of the number of the last segment in a confirmation
constexpr std::uint8_t kNextBlockPlace = 2;  // of the number of segments in it
constexpr std::size_t kCrcPlace = 1;         // in the end of a block transfer

}  // namespace

void Dialogue::begin_block(const Heard& heard, bool is_write, Findings& findings) {
  const canopen::Frame& frame = heard.frame;
  block_.begin(CommandByte{frame.data[0]}.has_crc());
  if (is_write) {
    told_size_ = sdo::size_in_block(frame);
    return;
  }
  const std::uint8_t size = frame.data[kBlockPlace];
  block_.begin_block(size);
  if (!sdo::is_block_size(size))
    blame(rules::kBlockSize, heard, findings, fmt::format("{} segments are asked for", size));
}

void Dialogue::start_block_download(const canopen::Frame& answer) {
  block_.set_crc(block_.has_crc() && CommandByte{answer.data[0]}.has_crc());
  block_.begin_block(answer.data[kBlockPlace]);
  phase_ = Phase::BlockSent;
}

void Dialogue::take_block_segment(const Heard& heard, Findings& findings) {
  const std::uint8_t byte = heard.frame.data[0];
  const std::uint8_t number = BlockData::number_in(byte);
  const std::uint8_t before = block_.number();
  asked_ = heard;
  is_last_ = (byte & sdo::kLastOfBlock) != 0;
  if (number > block_.size()) {
    blame(rules::kBlockSize, heard, findings, fmt::format("segment {} of {}", number, block_.size()));
  } else if (!block_.take(number, &heard.frame.data[1])) {
    if (!std::exchange(has_gap_, true))
      blame(rules::kBlockSequence, heard, findings, fmt::format("segment {} behind {}", number, before));
  } else {
    add_bytes(&heard.frame.data[1], sdo::kSegmentBytes);
  }
  if (is_last_ || number >= block_.size()) phase_ = Phase::BlockEnding;
}

/// The client ends a block download, or starts, confirms or ends a block upload.
std::optional<Transfer> Dialogue::take_block_upload(const Heard& heard, Findings& findings) {
  const canopen::Frame& frame = heard.frame;
  const CommandByte command{frame.data[0]};
  asked_ = heard;
  if (transfer_.is_write) {
    take_block_end(heard, findings);
    return std::nullopt;
  }
  switch (command.block_upload()) {
    case sdo::BlockUploadRequest::Start:
      phase_ = Phase::BlockHeard;
      break;
    case sdo::BlockUploadRequest::Confirm: {
      const std::uint8_t confirmed = frame.data[kConfirmedPlace], next = frame.data[kNextBlockPlace];
      const std::uint8_t sent = block_.number();
      if (confirmed > sent)
        blame(rules::kBlockConfirmation, heard, findings, fmt::format("{} of {}", confirmed, sent));
      else if (!sdo::is_block_size(next))
        blame(rules::kBlockSize, heard, findings, fmt::format("{} segments are asked for", next));
      if (confirmed < sent) drop_segments(confirmed);
      phase_ = is_last_ && confirmed >= sent ? Phase::BlockEnding : Phase::BlockHeard;
      block_.begin_block(next);
      break;
    }
    case sdo::BlockUploadRequest::End:
      return finished(Transfer::End::Done, heard);
    case sdo::BlockUploadRequest::Initiate:
      break;
  }
  return std::nullopt;
}

void Dialogue::take_block_end(const Heard& heard, Findings& findings) {
  const canopen::Frame& frame = heard.frame;
  const CommandByte command{frame.data[0]};
  if (command.request() != Request::BlockDownload || !command.is_block_end()) return;
  phase_ = Phase::BlockEnding;
  drop_bytes(sdo::kSegmentBytes - command.end_size());
  if (block_.has_crc() && !has_gap_) {
    const auto told = canopen::load<std::uint16_t>(&frame.data[kCrcPlace]);
    const std::uint16_t crc = block_.crc(command.end_size());
    if (told != crc)
      return blame(rules::kBlockCrc, heard, findings, fmt::format("{:04X}h instead of {:04X}h", told, crc));
  }
  if (told_size_ && transfer_.bytes != *told_size_ && !has_gap_)
    blame(rules::kSize, heard, findings, fmt::format("{} bytes of {} told", transfer_.bytes, *told_size_));
}

/// The server confirms a block or the end of a download, or ends an upload.
std::optional<Transfer> Dialogue::take_block_answer(const Heard& heard) {
  const canopen::Frame& frame = heard.frame;
  const bool is_end = (frame.data[0] & sdo::kBlockEnd) != 0;
  if (!transfer_.is_write) {
    drop_bytes(sdo::kSegmentBytes - CommandByte{frame.data[0]}.end_size());
    phase_ = Phase::BlockConfirm;
    return std::nullopt;
  }
  if (is_end) return finished(Transfer::End::Done, heard);
  const std::uint8_t confirmed = frame.data[kConfirmedPlace];
  const bool has_all = confirmed >= block_.number();
  if (!has_all) drop_segments(confirmed);
  if (is_last_ && has_all) {
    phase_ = Phase::BlockReady;
  } else {
    is_last_ = false;
    phase_ = Phase::BlockSent;
    block_.begin_block(frame.data[kNextBlockPlace]);
  }
  return std::nullopt;
}

/// What is behind segment @p confirmed of the block will be sent again.
void Dialogue::drop_segments(std::uint8_t confirmed) {
  drop_bytes(std::uint64_t{sdo::kSegmentBytes} * (block_.number() - confirmed));
  block_.set_crc(false);  // it has them already
}

void Dialogue::take_block_upload_segment(const Heard& heard) {
  const std::uint8_t byte = heard.frame.data[0];
  if (!block_.take(BlockData::number_in(byte), &heard.frame.data[1])) return;
  add_bytes(&heard.frame.data[1], sdo::kSegmentBytes);
  is_last_ = (byte & sdo::kLastOfBlock) != 0;
  if (is_last_ || block_.is_full()) phase_ = Phase::BlockConfirm;
}

}  // namespace audit
