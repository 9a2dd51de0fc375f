#include "injection/wire/transfer.hpp"

namespace injection {
namespace {

using canopen::sdo::BlockUploadRequest;
using canopen::sdo::CommandByte;
using canopen::sdo::Request;
using canopen::sdo::Response;

constexpr std::uint8_t kSequence = 0x7F;
constexpr unsigned kSpecifier = 0xE0;
constexpr std::uint8_t kSubCommand = 0x03;

}  // namespace

void Transfer::begin(const canopen::Frame& frame, bool is_upload) noexcept {
  *this = {};
  at_ = canopen::sdo::address_in(frame);
  is_upload_ = is_upload;
  part_ = Part::Initiate;
  step_ = requests_ = 1;
}

/// In a block download the first byte is a sequence number, but 80h, which none has.
void Transfer::on_request(const canopen::Frame& frame) noexcept {
  const CommandByte command{frame.data[0]};
  step_ = ++requests_;
  if (frame.data[0] == kAbortCommand) {
    in_block_ = false;
    part_ = Part::Abort;
    return;
  }
  if (in_block_ && !is_upload_) {
    part_ = Part::Block;
    last_sequence_ = frame.data[0] & kSequence;
    block_is_last_ = (frame.data[0] & canopen::sdo::kLastOfBlock) != 0;
    return;
  }
  switch (command.request()) {
    case Request::InitiateDownload:
    case Request::InitiateUpload:
      return begin(frame, command.request() == Request::InitiateUpload);
    case Request::BlockUpload:
      if (command.block_upload() == BlockUploadRequest::Initiate) return begin(frame, true);
      part_ = command.block_upload() == BlockUploadRequest::End ? Part::BlockEnd : Part::BlockConfirm;
      in_block_ = part_ == Part::BlockConfirm && !(block_is_last_ && frame.data[1] == last_sequence_);
      return;
    case Request::BlockDownload:
      if (!command.is_block_end()) return begin(frame, false);
      part_ = Part::BlockEnd;
      return;
    default:
      part_ = Part::Segment;
  }
}

void Transfer::on_response(const canopen::Frame& frame) noexcept {
  step_ = ++responses_;
  if (frame.data[0] == kAbortCommand) {
    in_block_ = false;
    part_ = Part::Abort;
    return;
  }
  if (in_block_ && is_upload_) {
    part_ = Part::Block;
    last_sequence_ = frame.data[0] & kSequence;
    block_is_last_ = (frame.data[0] & canopen::sdo::kLastOfBlock) != 0;
    return;
  }
  const auto response = static_cast<Response>(frame.data[0] & kSpecifier);
  if (response == Response::BlockDownload) {
    const auto sub = static_cast<std::uint8_t>(frame.data[0] & kSubCommand);
    part_ = sub == 0 ? Part::Initiate : sub == canopen::sdo::kBlockConfirm ? Part::BlockConfirm : Part::BlockEnd;
    in_block_ = sub == 0 || (part_ == Part::BlockConfirm && !(block_is_last_ && frame.data[1] == last_sequence_));
  } else if (response == Response::BlockUpload) {
    part_ = (frame.data[0] & canopen::sdo::kBlockEnd) != 0 ? Part::BlockEnd : Part::Initiate;
  } else {
    const bool is_segment = response == Response::UploadSegment || response == Response::DownloadSegment;
    part_ = is_segment ? Part::Segment : Part::Initiate;
  }
}

}  // namespace injection
