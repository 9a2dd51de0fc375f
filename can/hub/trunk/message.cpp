#include "can/hub/trunk/message.hpp"

#include <bit>
#include <cstring>
#include <type_traits>
#include <utility>

namespace hub::trunk {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers lie in memory as they are sent");

// Where the parts of a frame lie; length and number share four bytes.
constexpr std::size_t kLengthAt = 4;
constexpr std::size_t kDataAt = 8;
constexpr unsigned kBitsOfLength = 8;

}  // namespace

void Writer::begin(const Header& header) noexcept {
  header_ = header;
  header_.count = 0;
  size_ = 0;
  put(kVersion);
  put(header.kind);
  put(header_.count);  // finish() writes it
  put(header.hub);
  put(header.epoch);
  put(header.origin);
  put(header.counter);
  put(header.seen);
  put(header.term);
  put(header.detail);
}

void Writer::add(const MarkedFrame& frame) noexcept {
  put(frame.frame.can_id);
  put(frame.frame.can_dlc | frame.number << kBitsOfLength);
  put(std::to_array(frame.frame.data));
  ++header_.count;
}

void Writer::add_granted(const MarkedFrame& frame, std::int64_t end) noexcept {
  put(end);
  add(frame);
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
  put(header_.count);
  size_ = size;
  return std::span{bytes_}.first(size_);
}

template <class Number>
void Writer::put(Number value) noexcept {
  std::memcpy(&bytes_[size_], &value, sizeof value);
  size_ += sizeof value;
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
    field = get<Field>(at);
    at += sizeof field;
  };
  next(header_.kind);
  next(header_.count);
  next(header_.hub);
  next(header_.epoch);
  next(header_.origin);
  next(header_.counter);
  next(header_.seen);
  next(header_.term);
  next(header_.detail);
}

std::string_view Reader::fault() const noexcept {
  const std::size_t rest = bytes_.size() - kHeaderSize;
  if (header_.hub == 0) return "comes from no hub";
  if (header_.kind > Kind::Lost) return "is of a kind that is unknown";
  if (is_of_arbiter(header_.kind) && header_.term == 0) return "comes from no arbiter";
  if (is_beat(header_.kind))
    return header_.count <= kLongestName && rest == header_.count ? "" : "has no name of its length";
  if (header_.kind == Kind::Lost) return header_.count == 0 && rest == 0 ? "" : "has more than it says";
  return fault_of_frames();
}

std::string_view Reader::fault_of_frames() const noexcept {
  const std::size_t most = header_.kind == Kind::Granted ? 1 : kMostFrames;
  if (header_.count == 0 || header_.count > most || bytes_.size() != frames_at() + header_.count * kFrameSize)
    return "does not have the frames that it counts";
  for (std::size_t i = 0; i < header_.count; ++i)
    if (get<std::uint8_t>(frames_at() + i * kFrameSize + kLengthAt) > CAN_MAX_DLEN)
      return "has a frame of more than 8 bytes";
  return "";
}

std::size_t Reader::frames_at() const noexcept {
  return header_.kind == Kind::Granted ? kHeaderSize + kTimeSize : kHeaderSize;
}

MarkedFrame Reader::frame(std::size_t number) const noexcept {
  const std::size_t at = frames_at() + number * kFrameSize;
  MarkedFrame marked;
  marked.frame.can_id = get<canid_t>(at);
  marked.frame.can_dlc = get<std::uint8_t>(at + kLengthAt);
  marked.number = get<std::uint32_t>(at + kLengthAt) >> kBitsOfLength;
  std::memcpy(marked.frame.data, &bytes_[at + kDataAt], sizeof marked.frame.data);
  return marked;
}

std::int64_t Reader::time(std::int64_t taken_in) const noexcept {
  return header_.kind == Kind::Granted ? get<std::int64_t>(kHeaderSize) : taken_in;
}

std::string_view Reader::name() const noexcept {
  return {reinterpret_cast<const char*>(bytes_.data()) + kHeaderSize, is_beat(header_.kind) ? header_.count : 0U};
}

template <class Number>
Number Reader::get(std::size_t at) const noexcept {
  Number value{};
  std::memcpy(&value, &bytes_[at], sizeof value);
  return value;
}

}  // namespace hub::trunk
