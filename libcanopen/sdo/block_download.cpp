#include <algorithm>
#include <cassert>

#include "libcanopen/sdo/crc.hpp"
#include "libcanopen/sdo/server.hpp"

// Block download (CiA 301, 7.2.4.3.8 to 7.2.4.3.11).

namespace canopen {

using sdo::Address;
using sdo::command_byte;
using sdo::CommandByte;
using sdo::Response;

void SdoServer::on_block_download(const Frame& frame) noexcept {
  if (!CommandByte{frame.data[0]}.is_block_end()) return initiate_block_download(frame);
  if (phase_ != Phase::BlockDownloadEnd) return refuse_command();
  end_block_download(frame);
}

void SdoServer::initiate_block_download(const Frame& frame) noexcept {
  const Address at = sdo::address_in(frame);
  if (!context_.policy.sdo_block) {
    return abort(phase_ == Phase::Idle ? at : address_, AbortCode::CommandSpecifierInvalid);
  }
  const Entry* const entry = find(at);
  if (entry == nullptr) return abort(at, context_.dictionary.absence(at.index));
  if (!entry->writable) return abort(at, AbortCode::ReadOnly);
  if (auto opened = open_sink(*entry, sdo::size_in_block(frame)); !opened) return abort(at, opened.error());
  begin_block_download(frame);
}

/// Begins to take what the sink has been opened for.
void SdoServer::begin_block_download(const Frame& frame) noexcept {
  const Address at = sdo::address_in(frame);
  begin(Phase::BlockDownload, at);
  crc_wanted_ = CommandByte{frame.data[0]}.has_crc();
  crc_ = 0;
  sequence_ = 0;
  must_restart_ = false;
  refusal_.reset();
  send(sdo::response_bytes(command_byte(Response::BlockDownload, sdo::kBlockCrc), at, sdo::kLongestBlock));
}

/// A segment counts if it is the next one; whichever closes the sub-block is answered.
void SdoServer::take_block_segment(const Frame& frame) noexcept {
  const auto number = static_cast<std::uint8_t>(frame.data[0] & ~sdo::kLastOfBlock);
  const bool last = (frame.data[0] & sdo::kLastOfBlock) != 0;
  if (number == 0) return last ? end() : abort(AbortCode::InvalidSequenceNumber);  // 80h is an abort
  if (!confirmed_early_) last_request_ = context_.now;
  if (must_restart_ && number != 1 && !refusal_) refusal_ = AbortCode::InvalidSequenceNumber;
  must_restart_ = false;
  if (number == sequence_ + 1) {
    ++sequence_;
    last_request_ = last_progress_ = context_.now;
    confirmed_early_ = false;
    keep_segment({&frame.data[1], sdo::kSegmentBytes}, last);
  }
  if (last || number == sdo::kLongestBlock) confirm_sub_block();
}

/// Takes the next segment. The last one is put aside: only the end tells how many of its bytes count.
void SdoServer::keep_segment(std::span<const std::uint8_t> bytes, bool last) noexcept {
  if (last) {
    std::copy(bytes.begin(), bytes.end(), last_segment_.begin());
    phase_ = Phase::BlockDownloadEnd;
  } else if (!refusal_) {
    if (auto taken = sink_.append(bytes); !taken) refusal_ = taken.error();
    if (crc_wanted_) crc_ = sdo::crc(bytes, crc_);
  }
}

/// Tells the client which segment was the last one in order; the next sub-block begins behind it. A refusal waits
/// for this moment: the client, which does not listen before, would send the rest of its sub-block to a server
/// that takes segments for requests.
void SdoServer::confirm_sub_block() noexcept {
  assert(sequence_ <= sdo::kLongestBlock);
  if (refusal_) return abort(*refusal_);
  send(command_byte(Response::BlockDownload, sdo::kBlockConfirm) | std::uint64_t{sequence_} << 8 |
       std::uint64_t{sdo::kLongestBlock} << 16);
  sequence_ = 0;
}

/// Confirms what has come of a sub-block whose end is missing. A client that goes on with its sub-block all the
/// same is refused: it would take the next confirmation for one of the whole, and send again what has been taken.
void SdoServer::confirm_early() noexcept {
  confirmed_early_ = true;
  must_restart_ = sequence_ != 0;
  last_request_ = context_.now;
  context_.timers.arm(timer_, due());
  confirm_sub_block();
}

void SdoServer::end_block_download(const Frame& frame) noexcept {
  const std::span bytes{last_segment_.data(), CommandByte{frame.data[0]}.end_size()};
  if (crc_wanted_ && sdo::crc(bytes, crc_) != load<std::uint16_t>(&frame.data[1])) {
    return abort(AbortCode::CrcError);
  }
  if (auto taken = sink_.append(bytes); !taken) return abort(taken.error());
  finish_download(command_byte(Response::BlockDownload, sdo::kBlockEnd));
}

}  // namespace canopen
