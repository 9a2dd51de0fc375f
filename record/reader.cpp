#include "record/reader.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "checksum/crc32.hpp"

namespace record {
namespace {

using nlohmann::json;
using Bytes = std::span<const std::byte>;

constexpr std::size_t kVersionAt = 8, kHeadLengthAt = 12;

std::string_view text_in(Bytes bytes) noexcept {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Takes a payload apart from front to back; what is not there is 0, and makes it too short.
class Payload {
 public:
  explicit Payload(Bytes bytes) noexcept : rest_{bytes} {}
  std::uint64_t number(std::size_t size) noexcept {
    const Bytes bytes = take(size);
    return bytes.size() == size ? number_at(bytes, 0, size) : 0;
  }
  template <class Number>
  Number as(std::size_t size = sizeof(Number)) noexcept {
    return static_cast<Number>(number(size));
  }
  double real() noexcept { return std::bit_cast<double>(number(sizeof(double))); }
  std::string_view text() noexcept { return text_in(take(as<std::size_t>(1))); }
  Bytes take(std::size_t size) noexcept {
    is_short_ = is_short_ || size > rest_.size();
    const Bytes taken = rest_.first(std::min(size, rest_.size()));
    rest_ = rest_.subspan(taken.size());
    return taken;
  }
  std::size_t left() const noexcept { return rest_.size(); }
  bool is_short() const noexcept { return is_short_; }

 private:
  Bytes rest_;
  bool is_short_ = false;
};

using Content = decltype(Record::content);

std::optional<Content> frame_in(Payload& payload) {
  const auto flags = payload.as<std::uint8_t>();
  canopen::Frame frame;
  frame.length = payload.as<std::uint8_t>();
  frame.id = payload.as<std::uint32_t>();
  frame.remote = (flags & kRemote) != 0;
  frame.extended = (flags & kExtended) != 0;
  if (frame.length > frame.data.size()) return std::nullopt;
  if (!frame.remote)
    for (std::size_t i = 0; i < frame.length; ++i) frame.data[i] = payload.as<std::uint8_t>();
  return FrameRecord{frame, (flags & kSent) != 0};
}

std::optional<Content> event_in(Payload& payload) {
  Event event;
  const auto kind = payload.as<std::uint8_t>();
  const auto origin = payload.as<std::uint8_t>();
  if (kind >= kEventKinds || origin > static_cast<std::uint8_t>(Origin::Control)) return std::nullopt;
  event.kind = static_cast<EventKind>(kind);
  event.origin = static_cast<Origin>(origin);
  event.server = payload.as<std::uint8_t>();
  event.object = payload.as<std::uint8_t>();
  event.axis = payload.as<std::uint8_t>();
  const auto flags = payload.as<std::uint8_t>();
  event.active = (flags & kActive) != 0;
  event.number = payload.as<std::uint16_t>();
  event.index = payload.as<std::uint16_t>();
  event.code = payload.as<std::uint32_t>();
  const double value = payload.real();
  const double before = payload.real();
  if ((flags & kHasValue) != 0) event.value = value;
  if ((flags & kHasBefore) != 0) event.before = before;
  for (std::uint8_t& byte : event.data) byte = payload.as<std::uint8_t>();
  event.text = payload.text();
  event.text_before = payload.text();
  if (event.kind == EventKind::Control) event.note = Note{std::exchange(event.text_before, {})};
  return event;
}

std::optional<Content> samples_in(Payload& payload) {
  SamplesRecord samples;
  while (payload.left() >= sizeof(double)) samples.values.push_back(payload.real());
  return samples;
}

std::optional<Content> lost_in(Payload& payload) {
  return LostRecord{payload.as<std::uint64_t>()};
}

std::optional<Content> end_in(Payload& payload) {
  const auto reason = payload.as<std::uint8_t>();
  if (reason > static_cast<std::uint8_t>(EndReason::Over)) return std::nullopt;
  return EndRecord{static_cast<EndReason>(reason)};
}

struct Decoder {
  RecordType type;
  std::optional<Content> (*read)(Payload& payload);
};
constexpr std::array kDecoders{Decoder{RecordType::Frame, &frame_in}, Decoder{RecordType::Event, &event_in},
                               Decoder{RecordType::Samples, &samples_in}, Decoder{RecordType::Lost, &lost_in},
                               Decoder{RecordType::End, &end_in}};

}  // namespace

/// A record of a later program may have more behind what is known; one that is shorter is none.
std::optional<Content> content_of(Bytes record) {
  const auto* const decoder = std::ranges::find(kDecoders, type_of(record), &Decoder::type);
  if (decoder == kDecoders.end()) return std::nullopt;
  Payload payload{record.subspan(kRecordHeadBytes)};
  auto content = decoder->read(payload);
  return payload.is_short() ? std::nullopt : content;
}

tl::expected<Reader, std::string> Reader::open(Bytes content) {
  if (content.size() < kMagic.size() || text_in(content.first(kMagic.size())) != kMagic)
    return tl::unexpected{std::string{"no recording: it does not begin with AXISREC"}};
  if (content.size() < kHeadBytes) return tl::unexpected{std::string{"cut within its head"}};
  if (const auto version = number_at(content, kVersionAt, 2); version != kVersion)
    return tl::unexpected{fmt::format("version {} of the format, this program reads {}", version, kVersion)};
  const auto length = static_cast<std::size_t>(number_at(content, kHeadLengthAt, 4));
  if (length > kLongestHead) return tl::unexpected{std::string{"its head is damaged"}};
  const std::size_t first = kHeadBytes + length + kChecksumBytes;
  if (content.size() < first) return tl::unexpected{std::string{"cut within its head"}};
  const Bytes text = content.subspan(kHeadBytes, length);
  json head = json::parse(text_in(text), nullptr, false);
  if (checksum::crc32(text) != number_at(content, kHeadBytes + length, kChecksumBytes) || !head.is_object())
    return tl::unexpected{std::string{"its head is damaged"}};
  return Reader{content, first, std::move(head)};
}

Bytes Reader::take() noexcept {
  const Bytes rest = content_.subspan(position_);
  const auto end_with = [this](Ending ending) {
    ending_ = ending;
    return Bytes{};
  };
  if (rest.empty()) return end_with(Ending::Open);
  if (rest.size() < kRecordHeadBytes) return end_with(Ending::Cut);
  const std::size_t size = size_of(rest);
  if (rest.size() < size + kChecksumBytes) return end_with(Ending::Cut);
  const Bytes record = rest.first(size);
  if (checksum::crc32(record) != number_at(rest, size, kChecksumBytes)) return end_with(Ending::Damaged);
  position_ += size + kChecksumBytes;
  return record;
}

std::optional<Record> Reader::next() {
  while (ending_ == Ending::NotYet) {
    const Bytes record = take();
    if (record.empty()) break;
    auto content = content_of(record);
    if (!content) {
      ++skipped_;
      continue;
    }
    if (std::holds_alternative<EndRecord>(*content)) ending_ = Ending::Whole;
    return Record{moment_of(record), *std::move(content)};
  }
  return std::nullopt;
}

std::string Reader::remark() const {
  switch (ending_) {
    case Ending::NotYet:
    case Ending::Whole:
      return {};
    case Ending::Open:
      return "it has no end: it is still being written, or was not finished";
    case Ending::Cut:
      return fmt::format("cut within a record at byte {}: {} bytes left out", position_, left());
    case Ending::Damaged:
      return fmt::format("damaged at byte {}: {} bytes left out", position_, left());
  }
  return {};
}

}  // namespace record
