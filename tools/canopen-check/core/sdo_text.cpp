#include <algorithm>

#include <fmt/format.h>

#include "meaning/words.hpp"
#include "tools/canopen-check/core/sdo_client.hpp"

namespace conformance {
namespace {

/// Bytes of a value that texts show.
constexpr std::size_t kMostShown = 32;

}  // namespace

std::string to_text(const canopen::Frame& frame) {
  return fmt::format("{:03X}#{}", frame.id,
                     hexadecimal(std::span{frame.data}.first(std::min<std::size_t>(frame.length, 8))));
}

std::string hexadecimal(std::span<const std::uint8_t> bytes) {
  if (bytes.size() <= kMostShown) return fmt::format("{:02X}", fmt::join(bytes, ""));
  return fmt::format("{:02X}... ({} bytes)", fmt::join(bytes.first(kMostShown), ""), bytes.size());
}

std::string to_text(const SdoAnswer& answer) {
  switch (answer.kind) {
    case SdoAnswer::Kind::Done:
      return answer.data.empty() ? "done" : hexadecimal(answer.data);
    case SdoAnswer::Kind::Aborted:
      return "abort " + meaning::abort_text(answer.abort_code);
    case SdoAnswer::Kind::Silent:
      return "no answer" + answer.problem;
    case SdoAnswer::Kind::Malformed:
    case SdoAnswer::Kind::Endless:
    case SdoAnswer::Kind::Cut:
      break;
  }
  return answer.problem;
}

}  // namespace conformance
