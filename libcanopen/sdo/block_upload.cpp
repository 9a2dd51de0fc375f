#include <algorithm>
#include <cassert>

#include "libcanopen/sdo/crc.hpp"
#include "libcanopen/sdo/server.hpp"

// Block upload (CiA 301, 7.2.4.3.12 to 7.2.4.3.15).

namespace canopen {

using sdo::Address;
using sdo::BlockUploadRequest;
using sdo::command_byte;
using sdo::CommandByte;
using sdo::Response;

void SdoServer::on_block_upload(const Frame& frame) noexcept {
  switch (CommandByte{frame.data[0]}.block_upload()) {
    case BlockUploadRequest::Initiate:
      return initiate_block_upload(frame);
    case BlockUploadRequest::Start:
      if (phase_ != Phase::BlockUploadStart) break;
      last_request_ = context_.now;
      return send_sub_block();
    case BlockUploadRequest::Confirm:
      if (phase_ != Phase::BlockUploadConfirm) break;
      last_request_ = context_.now;
      return take_confirmation(frame);
    case BlockUploadRequest::End:
      if (phase_ != Phase::BlockUploadEnd) break;
      return end();
  }
  refuse_command();
}

void SdoServer::initiate_block_upload(const Frame& frame) noexcept {
  const Address at = sdo::address_in(frame);
  if (!context_.policy.sdo_block) {
    return abort(phase_ == Phase::Idle ? at : address_, AbortCode::CommandSpecifierInvalid);
  }
  const std::uint8_t block_size = frame.data[4];
  const std::uint8_t switch_size = frame.data[5];
  const Entry* const entry = find(at);
  if (entry == nullptr) return abort(at, context_.dictionary.absence(at.index));
  if (!entry->readable) return abort(at, AbortCode::WriteOnly);
  if (!sdo::is_block_size(block_size)) return abort(at, AbortCode::InvalidBlockSize);
  const std::uint8_t number_size = entry->size;
  if (number_size >= 1 && number_size <= 4 && number_size <= switch_size) return initiate_upload(frame);
  if (auto opened = open_source(*entry); !opened) return abort(at, opened.error());
  begin_block_upload(frame);
}

/// Begins to send what the source has been opened for.
void SdoServer::begin_block_upload(const Frame& frame) noexcept {
  const Address at = sdo::address_in(frame);
  const std::uint8_t switch_size = frame.data[5];  // the "protocol switch threshold": 0 forbids it
  const auto size = source_.size();
  if (switch_size != 0 && size && *size <= switch_size) return begin_segmented_upload(at);

  begin(Phase::BlockUploadStart, at);
  block_size_ = frame.data[4];
  crc_wanted_ = CommandByte{frame.data[0]}.has_crc();
  crc_ = 0;
  send(sdo::response_bytes(command_byte(Response::BlockUpload, sdo::kBlockCrc | (size ? sdo::kBlockSize : 0)), at,
                           size.value_or(0)));
}

/// Sends the next segments, as many as the client takes, without dropping them.
void SdoServer::send_sub_block() noexcept {
  assert(sdo::is_block_size(block_size_));
  if (auto ready = source_.want(block_size_ * sdo::kSegmentBytes + 1); !ready) return abort(ready.error());
  phase_ = Phase::BlockUploadConfirm;
  sequence_ = 0;
  last_sent_ = false;
  const std::uint8_t* data = source_.data();
  std::size_t left = source_.available();
  while (sequence_ < block_size_ && !last_sent_) {
    const std::size_t size = std::min(left, sdo::kSegmentBytes);
    last_sent_ = size == left;
    ++sequence_;
    send(sdo::segment_bytes(static_cast<std::uint8_t>(sequence_ | (last_sent_ ? sdo::kLastOfBlock : 0)), data,
                            size));
    data += size;
    left -= size;
    last_size_ = static_cast<std::uint8_t>(size);
  }
}

void SdoServer::take_confirmation(const Frame& frame) noexcept {
  const std::uint8_t confirmed = frame.data[1];
  const std::uint8_t block_size = frame.data[2];
  if (confirmed > sequence_) return abort(AbortCode::InvalidSequenceNumber);
  if (!sdo::is_block_size(block_size)) return abort(AbortCode::InvalidBlockSize);
  const bool complete = last_sent_ && confirmed == sequence_;
  const std::size_t bytes = std::min(confirmed * sdo::kSegmentBytes, source_.available());
  if (crc_wanted_) crc_ = sdo::crc({source_.data(), bytes}, crc_);
  source_.drop(bytes);
  if (complete) return send_block_end();
  block_size_ = block_size;
  send_sub_block();
}

void SdoServer::send_block_end() noexcept {
  assert(source_.available() == 0);
  phase_ = Phase::BlockUploadEnd;
  const auto unused = static_cast<unsigned>(sdo::kSegmentBytes - last_size_);
  send(std::uint64_t{crc_} << 8 | command_byte(Response::BlockUpload, unused << 2 | sdo::kBlockEnd));
}

}  // namespace canopen
