#include "meaning/words.hpp"

#include <algorithm>
#include <span>

#include <fmt/format.h>

#include "libcanopen/base/little_endian.hpp"
#include "libcanopen/od/abort_text.hpp"

namespace meaning {
namespace {

namespace sdo = canopen::sdo;

constexpr std::uint8_t kResponseBits = 0xE0;

std::string of_node(const Meaning& meaning) {
  return meaning.node == 0 ? std::string{} : fmt::format(" of node {}", meaning.node);
}

std::string hex_value(std::span<const std::uint8_t> bytes) {
  std::string digits;
  for (std::size_t i = bytes.size(); i > 0; --i) digits += fmt::format("{:02X}", bytes[i - 1]);
  return digits + 'h';
}

std::string abort_words(const canopen::Frame& frame, const std::string& object) {
  return fmt::format("{} aborted: {}", object, abort_text(canopen::load<std::uint32_t>(&frame.data[4])));
}

std::string request_words(const canopen::Frame& frame, const eds::Description& description) {
  const sdo::CommandByte command{frame.data[0]};
  const std::string object = name_of(sdo::address_in(frame), description);
  switch (command.request()) {
    case sdo::Request::InitiateDownload:
      if (!command.is_expedited()) return "write " + object + " in segments";
      return fmt::format(
          "write {} = {}", object,
          hex_value(std::span{frame.data}.subspan(4, command.has_size() ? command.expedited_size() : 4U)));
    case sdo::Request::InitiateUpload:
      return "read " + object;
    case sdo::Request::Abort:
      return abort_words(frame, object);
    case sdo::Request::DownloadSegment:
      return "a segment to be written";
    case sdo::Request::UploadSegment:
      return "the next segment to be read";
    case sdo::Request::BlockUpload:
      return "block upload";
    case sdo::Request::BlockDownload:
      return "block download";
  }
  return "";
}

std::string response_words(const canopen::Frame& frame, const eds::Description& description) {
  const std::string object = name_of(sdo::address_in(frame), description);
  if (const unsigned bytes = expedited_bytes(frame); bytes != 0)
    return fmt::format("{} = {}", object, hex_value(std::span{frame.data}.subspan(4, bytes)));
  switch (static_cast<sdo::Response>(frame.data[0] & kResponseBits)) {
    case sdo::Response::InitiateUpload:
      return object + " in segments";
    case sdo::Response::InitiateDownload:
      return object + " is written";
    case sdo::Response::Abort:
      return abort_words(frame, object);
    case sdo::Response::UploadSegment:
      return "a segment that is read";
    case sdo::Response::DownloadSegment:
      return "a segment is written";
    case sdo::Response::BlockDownload:
      return "block download";
    case sdo::Response::BlockUpload:
      return "block upload";
  }
  return "";
}

std::string emergency_words(const canopen::Frame& frame) {
  return fmt::format("error code {:04X}h, error register {:02X}h", canopen::load<std::uint16_t>(frame.data.data()),
                     frame.data[2]);
}

/// "heartbeat Operational", "NMT start", as scenarios name them.
std::string service_words(const canopen::Frame& frame, std::uint32_t function, std::uint8_t node) {
  canopen::Frame plain = frame;
  plain.id = function + node;
  plain.extended = false;
  return service_of(plain);
}

}  // namespace

std::string name_of(const sdo::Address& at, const eds::Description& description) {
  std::string text = fmt::format("{:04X}h:{:02X}", at.index, at.sub_index);
  const eds::EntryFacts* const entry = description.find(at.index, at.sub_index);
  return entry == nullptr || entry->name.empty() ? text : fmt::format("{} ({})", text, entry->name);
}

std::string words_of(const canopen::Frame& frame, const Meaning& meaning, const eds::Description& description) {
  switch (meaning.role) {
    case Role::Unknown:
      return "";
    case Role::Nmt:
      return fmt::format("{} to {}", service_words(frame, 0, 0),
                         frame.data[1] == 0 ? "all nodes" : fmt::format("node {}", frame.data[1]));
    case Role::Sync:
      return "SYNC";
    case Role::Time:
      return "TIME";
    case Role::Emergency:
      return fmt::format("EMCY{}: {}", of_node(meaning), emergency_words(frame));
    case Role::Tpdo:
      return fmt::format("TPDO {}{}", meaning.number, of_node(meaning));
    case Role::Rpdo:
      return fmt::format("RPDO {}{}", meaning.number, of_node(meaning));
    case Role::SdoRequest:
      return fmt::format("SDO request to node {}: {}", meaning.node, request_words(frame, description));
    case Role::SdoResponse:
      return fmt::format("SDO response{}: {}", of_node(meaning), response_words(frame, description));
    case Role::ErrorControl:
    case Role::Guarding:
      return service_words(frame, canopen::function_code::kErrorControl, meaning.node) + of_node(meaning);
    case Role::LssRequest:
      return "LSS request";
    case Role::LssResponse:
      return "LSS response";
  }
  return "";
}

std::string abort_text(std::uint32_t code) {
  const std::string_view text = canopen::text_of(canopen::AbortCode{code});
  return text.empty() ? fmt::format("{:08X}h", code) : fmt::format("{:08X}h ({})", code, text);
}

}  // namespace meaning
