#include "libcanopen/sdo/server.hpp"

// Segmented transfer (CiA 301, 7.2.4.3.3 to 7.2.4.3.7).

namespace canopen {

using sdo::Address;
using sdo::command_byte;
using sdo::CommandByte;
using sdo::Response;

void SdoServer::begin_segmented_upload(Address at) noexcept {
  begin(Phase::Upload, at);
  const auto size = source_.size();
  send(sdo::response_bytes(command_byte(Response::InitiateUpload, size ? sdo::kSizeIndicated : 0), at,
                           size.value_or(0)));
}

void SdoServer::upload_segment(CommandByte command) noexcept {
  if (!continues(Phase::Upload, command)) return;
  if (auto ready = source_.want(sdo::kSegmentBytes + 1); !ready) return abort(ready.error());
  const std::size_t left = source_.available();
  const std::uint8_t* const data = source_.data();
  const unsigned answer = command_byte(Response::UploadSegment, command.toggle());
  if (left > sdo::kSegmentBytes) {
    source_.drop(sdo::kSegmentBytes);
    return send(load<std::uint64_t>(data) << 8 | answer);
  }
  end();
  const auto unused = static_cast<unsigned>(sdo::kSegmentBytes - left);
  send(sdo::segment_bytes(static_cast<std::uint8_t>(answer | unused << 1 | sdo::kLastSegment), data, left));
}

void SdoServer::initiate_segmented_download(const Entry& entry, const Frame& frame) noexcept {
  const Address at = sdo::address_in(frame);
  if (auto opened = open_sink(entry, sdo::size_in(frame)); !opened) return abort(at, opened.error());
  begin_segmented_download(at);
}

/// Begins to take what the sink has been opened for.
void SdoServer::begin_segmented_download(Address at) noexcept {
  begin(Phase::Download, at);
  send(sdo::response_bytes(command_byte(Response::InitiateDownload), at, 0));
}

void SdoServer::download_segment(const Frame& frame) noexcept {
  const CommandByte command{frame.data[0]};
  if (!continues(Phase::Download, command)) return;
  if (auto taken = sink_.append({&frame.data[1], command.segment_size()}); !taken) return abort(taken.error());
  const std::uint64_t answer = command_byte(Response::DownloadSegment, command.toggle());
  if (command.is_last()) return finish_download(answer);
  send(answer);
}

/// True if @p command is the segment that the transfer waits for; otherwise the transfer is aborted.
bool SdoServer::continues(Phase phase, CommandByte command) noexcept {
  if (phase_ != phase) {
    refuse_command();
    return false;
  }
  if (command.toggle() != toggle_) {
    abort(AbortCode::ToggleBitNotAlternated);
    return false;
  }
  toggle_ ^= 0x10;
  last_request_ = context_.now;
  return true;
}

}  // namespace canopen
