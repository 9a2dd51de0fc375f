#include "meaning/sdo_watch.hpp"

#include "libcanopen/base/little_endian.hpp"

namespace meaning {

namespace sdo = canopen::sdo;

namespace {

constexpr std::uint8_t kSpecifier = 0xE0;
constexpr std::uint8_t kExpedited = 0x02;

bool is(const canopen::Frame& response, sdo::Response kind) noexcept {
  return (response.data[0] & kSpecifier) == static_cast<std::uint8_t>(kind);
}

std::uint32_t value_in(const canopen::Frame& frame, unsigned bytes) noexcept {
  return static_cast<std::uint32_t>(canopen::load<std::uint32_t>(&frame.data[4]) & canopen::byte_mask(bytes));
}

}  // namespace

unsigned expedited_bytes(const canopen::Frame& response) noexcept {
  const sdo::CommandByte command{response.data[0]};
  if (response.length != 8 || !is(response, sdo::Response::InitiateUpload) || (command.byte & kExpedited) == 0)
    return 0;
  return command.has_size() ? command.expedited_size() : 4;
}

void SdoWatch::take_request(SdoChannel channel, const canopen::Frame& request) {
  const sdo::CommandByte command{request.data[0]};
  writes_.erase(channel);
  if (request.length != 8 || command.request() != sdo::Request::InitiateDownload || !command.is_expedited())
    return;
  const unsigned bytes = command.has_size() ? command.expedited_size() : 4;
  writes_[channel] = {
      .node = channel.node, .at = sdo::address_in(request), .value = value_in(request, bytes), .is_write = true};
}

std::optional<EntryValue> SdoWatch::take_response(SdoChannel channel, const canopen::Frame& response) {
  if (const unsigned bytes = expedited_bytes(response); bytes != 0)
    return EntryValue{.node = channel.node, .at = sdo::address_in(response), .value = value_in(response, bytes)};
  const auto write = writes_.find(channel);
  if (write == writes_.end()) return std::nullopt;
  const EntryValue value = write->second;
  writes_.erase(write);
  const bool is_done = response.length == 8 && is(response, sdo::Response::InitiateDownload);
  const sdo::Address at = sdo::address_in(response);
  if (!is_done || at.index != value.at.index || at.sub_index != value.at.sub_index) return std::nullopt;
  return value;
}

}  // namespace meaning
