#include "modbus/frame.hpp"

namespace modbus {
namespace {

constexpr std::size_t kTransaction = 0, kProtocol = 2, kLength = 4, kUnit = 6;
constexpr std::uint16_t kModbus = 0;  // the protocol

}  // namespace

tl::expected<std::optional<Frame>, BrokenStream> first_frame(std::span<const std::uint8_t> bytes) noexcept {
  if (bytes.size() < kProtocol + kWordBytes) return std::nullopt;
  if (word_at(bytes, kProtocol) != kModbus) return tl::unexpected{BrokenStream::Protocol};
  if (bytes.size() < kLength + kWordBytes) return std::nullopt;
  const std::size_t length = word_at(bytes, kLength);
  if (length < kLeastLength || length > kMostLength) return tl::unexpected{BrokenStream::Length};
  const std::size_t whole = kBytesBeforeUnit + length;
  if (bytes.size() < whole) return std::nullopt;
  return Frame{.transaction = word_at(bytes, kTransaction),
               .unit = bytes[kUnit],
               .pdu = bytes.subspan(kHeaderBytes, length - 1),
               .bytes = whole};
}

std::size_t write_header(const Frame& request, std::size_t pdu_bytes,
                         std::span<std::uint8_t, kHeaderBytes> header) noexcept {
  put_word(header, kTransaction, request.transaction);
  put_word(header, kProtocol, kModbus);
  put_word(header, kLength, static_cast<std::uint16_t>(pdu_bytes + 1));
  header[kUnit] = request.unit;
  return kHeaderBytes + pdu_bytes;
}

}  // namespace modbus
