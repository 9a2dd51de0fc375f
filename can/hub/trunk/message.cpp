#include "can/hub/trunk/message.hpp"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>

namespace hub::trunk {

namespace {

constexpr unsigned kBitsOfByte = 8;
constexpr std::size_t kIdentifierSize = 4;
constexpr std::size_t kNumberSize = 3;
constexpr std::size_t kDataAt = 8;

}  // namespace

void Writer::begin(const Header& header) noexcept {
  header_ = header;
  header_.count = 0;
  size_ = 0;
  put(kVersion, 1);
  put(static_cast<std::uint8_t>(header.kind), 1);
  put(0, sizeof header.count);  // finish() writes it
  put(header.hub, sizeof header.hub);
  put(header.epoch, sizeof header.epoch);
  put(header.origin, sizeof header.origin);
  put(header.counter, sizeof header.counter);
  put(static_cast<std::uint64_t>(header.seen), sizeof header.seen);
  put(0, kHeaderSize - size_);
}

void Writer::add(const MarkedFrame& frame) noexcept {
  put(frame.frame.can_id, kIdentifierSize);
  put(frame.frame.can_dlc, 1);
  put(frame.number, kNumberSize);
  std::memcpy(&bytes_[size_], frame.frame.data, sizeof frame.frame.data);
  size_ += sizeof frame.frame.data;
  ++header_.count;
}

void Writer::add_name(std::string_view name) noexcept {
  const std::string_view cut = name.substr(0, kLongestName);
  std::memcpy(&bytes_[size_], cut.data(), cut.size());
  size_ += cut.size();
  header_.count = static_cast<std::uint16_t>(cut.size());
}

std::span<const std::byte> Writer::finish() noexcept {
  constexpr std::size_t kCountAt = 2;
  const std::size_t size = std::exchange(size_, kCountAt);
  put(header_.count, sizeof header_.count);
  size_ = size;
  return std::span{bytes_}.first(size_);
}

void Writer::put(std::uint64_t value, std::size_t bytes) noexcept {
  for (std::size_t i = 0; i < bytes; ++i) {
    bytes_[size_++] = static_cast<std::byte>(value);
    value >>= kBitsOfByte;
  }
}

std::optional<Reader> Reader::read(std::span<const std::byte> bytes, std::string_view& problem) noexcept {
  Reader reader{bytes};
  problem = "is too short for a message of a hub";
  if (bytes.size() < kHeaderSize) return std::nullopt;
  problem = "is of another version";
  if (bytes[0] != std::byte{kVersion}) return std::nullopt;
  reader.read_header();
  problem = reader.fault();
  if (!problem.empty()) return std::nullopt;
  return reader;
}

void Reader::read_header() noexcept {
  std::size_t at = 1;
  const auto next = [&](auto& field) {
    using Field = std::remove_reference_t<decltype(field)>;
    field = static_cast<Field>(get(at, sizeof field));
    at += sizeof field;
  };
  next(header_.kind);
  next(header_.count);
  next(header_.hub);
  next(header_.epoch);
  next(header_.origin);
  next(header_.counter);
  next(header_.seen);
}

std::string_view Reader::fault() const noexcept {
  const std::size_t rest = bytes_.size() - kHeaderSize;
  if (header_.hub == 0) return "comes from no hub";
  if (header_.kind == Kind::Beat)
    return header_.count <= kLongestName && rest == header_.count ? "" : "has no name of its length";
  if (header_.kind != Kind::Frames) return "is of a kind that is unknown";
  if (header_.count == 0 || header_.count > kMostFrames || rest != header_.count * kFrameSize)
    return "does not have the frames that it counts";
  for (std::size_t i = 0; i < header_.count; ++i)
    if (frame(i).frame.can_dlc > CAN_MAX_DLEN) return "has a frame of more than 8 bytes";
  return "";
}

MarkedFrame Reader::frame(std::size_t number) const noexcept {
  const std::size_t at = kHeaderSize + number * kFrameSize;
  MarkedFrame marked;
  marked.frame.can_id = static_cast<canid_t>(get(at, kIdentifierSize));
  marked.frame.can_dlc = static_cast<std::uint8_t>(get(at + kIdentifierSize, 1));
  marked.number = static_cast<std::uint32_t>(get(at + kIdentifierSize + 1, kNumberSize));
  std::memcpy(marked.frame.data, &bytes_[at + kDataAt], sizeof marked.frame.data);
  return marked;
}

std::string_view Reader::name() const noexcept {
  return {reinterpret_cast<const char*>(bytes_.data()) + kHeaderSize,
          header_.kind == Kind::Beat ? header_.count : 0U};
}

std::uint64_t Reader::get(std::size_t at, std::size_t bytes) const noexcept {
  std::uint64_t value = 0;
  for (std::size_t i = bytes; i > 0; --i)
    value = value << kBitsOfByte | static_cast<std::uint8_t>(bytes_[at + i - 1]);
  return value;
}

}  // namespace hub::trunk
