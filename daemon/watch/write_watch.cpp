#include "daemon/watch/write_watch.hpp"

#include <algorithm>
#include <bit>

#include "libcanopen/base/object_index.hpp"
#include "libcanopen/od/abort_text.hpp"

namespace axisd {
namespace {

using canopen::sdo::CommandByte;
using canopen::sdo::Request;
using canopen::sdo::Response;

constexpr std::uint16_t kMostServers = 128;
constexpr std::size_t kFrameBytes = 8, kExpeditedAt = 4, kExpeditedBytes = 4;

std::size_t servers_of(const device::Device& device) {
  std::size_t servers = 1;
  while (servers < kMostServers &&
         device.dictionary().contains(static_cast<std::uint16_t>(canopen::object::kSdoServer + servers)))
    ++servers;
  return servers;
}

Response response_in(const canopen::Frame& frame) noexcept {
  constexpr unsigned kSpecifier = 0xE0;
  return static_cast<Response>(frame.data[0] & kSpecifier);
}

}  // namespace

WriteWatch::WriteWatch(const device::Device& device) : device_{device}, downloads_(servers_of(device)) {}

canopen::Identifier WriteWatch::identifier(std::size_t number, device::SdoWay way) const noexcept {
  return device::sdo_identifier(device_.dictionary(), device_.node_id(), number, way);
}

void WriteWatch::on_received(const canopen::Frame& frame) noexcept {
  if (frame.remote || frame.length != kFrameBytes) return;
  for (std::size_t server = 0; server < downloads_.size(); ++server)
    if (identifier(server, device::SdoWay::Request) == canopen::identifier_of(frame)) return begin(server, frame);
}

/// In a block download the first byte is a sequence number, but 80h, which none has.
void WriteWatch::begin(std::size_t server, const canopen::Frame& frame) noexcept {
  Download& download = downloads_[server];
  const CommandByte command{frame.data[0]};
  const bool is_block = download.phase == Phase::Block;
  if (command.request() == Request::DownloadSegment && download.phase == Phase::Segments) {
    take(download, frame, 1, command.segment_size());
    if (command.is_last()) download.phase = Phase::LastSegment;
    return;
  }
  if (is_block && frame.data[0] != canopen::sdo::command_byte(Response::Abort)) return;
  const Request request = command.request();
  if (request != Request::InitiateDownload && request != Request::BlockDownload) {
    if (request != Request::UploadSegment) download.phase = Phase::Idle;
    return;
  }
  download = {.phase = Phase::Initiated, .at = canopen::sdo::address_in(frame)};
  download.parameter =
      device_.parameter_at(static_cast<std::uint8_t>(server), download.at.index, download.at.sub_index);
  download.before = value_of(download);
  if (request == Request::BlockDownload) {
    download.phase = Phase::Block;
  } else if (command.is_expedited()) {
    take(download, frame, kExpeditedAt, command.has_size() ? command.expedited_size() : kExpeditedBytes);
  } else {
    download.phase = Phase::Segments;
  }
}

void WriteWatch::take(Download& download, const canopen::Frame& frame, std::size_t first,
                      std::size_t size) noexcept {
  for (std::size_t i = 0; i < size; ++i, ++download.size)
    if (download.size < download.bytes.size()) download.bytes[download.size] = frame.data[first + i];
}

std::optional<UnitEvent> WriteWatch::on_sent(const canopen::Frame& frame) noexcept {
  if (frame.remote || frame.length != kFrameBytes) return std::nullopt;
  for (std::size_t server = 0; server < downloads_.size(); ++server) {
    Download& download = downloads_[server];
    if (download.phase == Phase::Idle ||
        identifier(server, device::SdoWay::Response) != canopen::identifier_of(frame))
      continue;
    const Phase phase = download.phase;
    const Response response = response_in(frame);
    const bool ends = (phase == Phase::Initiated && response == Response::InitiateDownload) ||
                      (phase == Phase::LastSegment && response == Response::DownloadSegment) ||
                      (phase == Phase::Block && response == Response::BlockDownload &&
                       CommandByte{frame.data[0]}.is_block_end());
    if (!ends && response != Response::Abort) return std::nullopt;
    download.phase = Phase::Idle;
    return ends ? written(server) : refused(server, frame);
  }
  return std::nullopt;
}

/// The value that is there now.
std::optional<double> WriteWatch::value_of(const Download& download) const noexcept {
  if (const auto& at = download.parameter) {
    const auto found = device_.unit().read(at->object, at->number, at->index);
    return found ? std::optional{drive::decode(*found)} : std::nullopt;
  }
  const canopen::Entry* const entry = device_.dictionary().lookup(download.at.index, download.at.sub_index);
  if (entry == nullptr || entry->size == 0) return std::nullopt;
  const auto value = device_.dictionary().read(*entry);
  return value ? std::optional{static_cast<double>(*value)} : std::nullopt;
}

/// The bytes that have come, as the type of the parameter or object has them.
double WriteWatch::number_in(const Download& download) const noexcept {
  const auto bits = canopen::load<std::uint64_t>(download.bytes.data());
  if (const auto& at = download.parameter) {
    const auto found = device_.unit().read(at->object, at->number, at->index);
    const drive::DataType type = found ? found->type : drive::DataType::U32;
    return drive::decode({type, static_cast<std::uint32_t>(bits)});
  }
  const canopen::Entry* const entry = device_.dictionary().lookup(download.at.index, download.at.sub_index);
  if (entry == nullptr || entry->size == 0) return static_cast<double>(bits);
  const std::uint64_t own = bits & canopen::byte_mask(entry->size);
  return entry->is_signed ? static_cast<double>(canopen::sign_extend(own, entry->size)) : static_cast<double>(own);
}

/// What has come in a block, or is longer than a number, is not kept: then the value that is there now is told.
UnitEvent WriteWatch::written(std::size_t server) const noexcept {
  const Download& download = downloads_[server];
  UnitEvent event{.kind = record::EventKind::Object,
                  .origin = record::Origin::Sdo,
                  .server = static_cast<std::uint8_t>(server),
                  .number = download.at.index,
                  .index = download.at.sub_index,
                  .value = value_of(download),
                  .before = download.before};
  const bool is_kept = download.size != 0 && download.size <= download.bytes.size();
  if (is_kept && event.value) event.value = number_in(download);
  if (const auto& at = download.parameter) {
    event.kind = record::EventKind::Parameter;
    event.object = at->object;
    event.number = at->number;
    event.index = static_cast<std::uint16_t>(at->index);
  }
  return event;
}

UnitEvent WriteWatch::refused(std::size_t server, const canopen::Frame& frame) const noexcept {
  const Download& download = downloads_[server];
  const auto code = canopen::load<std::uint32_t>(&frame.data[4]);
  return {.kind = record::EventKind::Refusal,
          .origin = record::Origin::Sdo,
          .server = static_cast<std::uint8_t>(server),
          .number = download.at.index,
          .index = download.at.sub_index,
          .code = code,
          .text = canopen::text_of(static_cast<canopen::AbortCode>(code))};
}

}  // namespace axisd
