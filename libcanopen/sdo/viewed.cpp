#include "libcanopen/sdo/server.hpp"

// Transfers with objects of the application (SdoView). What follows their first request is no different.

namespace canopen {

using sdo::Address;
using sdo::CommandByte;
using sdo::Request;
using sdo::ViewedObject;

namespace {
constexpr std::size_t kExpeditedBytes = 4;
}

void SdoServer::on_viewed_frame(const Frame& frame) noexcept {
  const bool listens = frame.length == 8 && phase_ < Phase::BlockDownload;
  if (!listens || !begins_transfer(CommandByte{frame.data[0]})) return on_frame(frame);
  const Address at = sdo::address_in(frame);
  switch (context_.view->place_of(number_, at.index)) {
    case ObjectPlace::Dictionary:
      return on_frame(frame);
    case ObjectPlace::Application:
      return initiate_viewed(frame);
    case ObjectPlace::Nowhere:
      return abort(at, AbortCode::NoObject);
  }
}

/// True for a request that names an object, unless it is refused whatever it names.
bool SdoServer::begins_transfer(CommandByte command) const noexcept {
  switch (command.request()) {
    case Request::InitiateUpload:
    case Request::InitiateDownload:
      return true;
    case Request::BlockUpload:
      return context_.policy.sdo_block && command.block_upload() == sdo::BlockUploadRequest::Initiate;
    case Request::BlockDownload:
      return context_.policy.sdo_block && !command.is_block_end();
    case Request::UploadSegment:
    case Request::DownloadSegment:
    case Request::Abort:
      break;
  }
  return false;
}

void SdoServer::initiate_viewed(const Frame& frame) noexcept {
  end();
  const CommandByte command{frame.data[0]};
  const Request request = command.request();
  const Address at = sdo::address_in(frame);
  const ViewedObject object{at.index, at.sub_index, number_};
  if (request == Request::InitiateUpload) return upload_viewed(object);
  if (request == Request::BlockUpload) return upload_viewed_block(object, frame);
  if (request == Request::BlockDownload) return gather_viewed_block(object, frame);
  return command.is_expedited() ? download_viewed(object, frame) : gather_viewed(object, frame);
}

void SdoServer::upload_viewed(ViewedObject object) noexcept {
  if (auto opened = source_.open(*context_.view, object); !opened) return abort(object.address(), opened.error());
  if (source_.available() > kExpeditedBytes) return begin_segmented_upload(object.address());
  send_viewed(object.address());
}

/// Sends all that the source has, up to four bytes.
void SdoServer::send_viewed(Address at) noexcept {
  const auto size = static_cast<unsigned>(source_.available());
  const auto bits = static_cast<std::uint32_t>(load<std::uint32_t>(source_.data()) & byte_mask(size));
  send(sdo::response_bytes(sdo::expedited_upload(size), at, bits));
}

void SdoServer::download_viewed(ViewedObject object, const Frame& frame) noexcept {
  Frame answer = answer_;  // the write may connect the server anew: the client still waits here
  const CommandByte command{frame.data[0]};
  const std::size_t size = command.has_size() ? command.expedited_size() : kExpeditedBytes;
  context_.answer_deferred = false;
  const auto written = object.write(*context_.view, {&frame.data[4], size}, command.has_size());
  const std::uint64_t done =
      sdo::response_bytes(sdo::command_byte(sdo::Response::InitiateDownload), object.address(), 0);
  if (written && context_.answer_deferred)
    return defer(object.address(), done, load<std::uint64_t>(frame.data.data()));
  store(answer.data.data(), written ? done : abort_answer(object.address(), written.error()));
  deliver(answer);
}

void SdoServer::gather_viewed(ViewedObject object, const Frame& frame) noexcept {
  if (auto opened = sink_.open(object, sdo::size_in(frame)); !opened)
    return abort(object.address(), opened.error());
  begin_segmented_download(object.address());
}

void SdoServer::gather_viewed_block(ViewedObject object, const Frame& frame) noexcept {
  if (auto opened = sink_.open(object, sdo::size_in_block(frame)); !opened)
    return abort(object.address(), opened.error());
  begin_block_download(frame);
}

void SdoServer::upload_viewed_block(ViewedObject object, const Frame& frame) noexcept {
  const std::uint8_t switch_size = frame.data[5];
  if (!sdo::is_block_size(frame.data[4])) return abort(object.address(), AbortCode::InvalidBlockSize);
  if (auto opened = source_.open(*context_.view, object); !opened) return abort(object.address(), opened.error());
  const std::size_t size = source_.available();
  if (size <= kExpeditedBytes && size <= switch_size) return send_viewed(object.address());
  begin_block_upload(frame);
}

}  // namespace canopen
