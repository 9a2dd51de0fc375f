#include "audit/sdo/requests.hpp"

#include "libcanopen/base/little_endian.hpp"

namespace audit {

namespace sdo = canopen::sdo;

using sdo::CommandByte;
using sdo::Request;

namespace {

constexpr std::uint8_t kResponseBits = 0xE0;

/// Bits of the command byte that must be zero, by command.
std::uint8_t reserved_bits(std::uint8_t byte) noexcept {
  const CommandByte command{byte};
  switch (command.request()) {
    case Request::InitiateDownload:
      return command.is_expedited() ? 0x10 : 0x1C;
    case Request::InitiateUpload:
      return 0x1F;
    case Request::UploadSegment:
      return 0x0F;
    case Request::Abort:
      return 0x1F;
    case Request::BlockUpload:
      return command.block_upload() == sdo::BlockUploadRequest::Initiate ? 0x18 : 0x1C;
    case Request::BlockDownload:
      return command.is_block_end() ? 0x02 : 0x18;
    case Request::DownloadSegment:
      break;
  }
  return 0;
}

}  // namespace

bool is_request(std::uint8_t byte) noexcept {
  return CommandByte{byte}.request() <= Request::BlockDownload && (byte & reserved_bits(byte)) == 0;
}

bool begins_transfer(std::uint8_t byte) noexcept {
  const CommandByte command{byte};
  switch (command.request()) {
    case Request::InitiateDownload:
    case Request::InitiateUpload:
      return true;
    case Request::BlockUpload:
      return command.block_upload() == sdo::BlockUploadRequest::Initiate;
    case Request::BlockDownload:
      return !command.is_block_end();
    default:
      return false;
  }
}

sdo::Response response_of(const canopen::Frame& frame) noexcept {
  return static_cast<sdo::Response>(frame.data[0] & kResponseBits);
}

std::uint32_t abort_code_in(const canopen::Frame& frame) noexcept {
  return canopen::load<std::uint32_t>(&frame.data[4]);
}

}  // namespace audit
