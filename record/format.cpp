#include "record/format.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>

namespace record {
namespace {

constexpr std::size_t kLengthAt = 2, kMomentAt = 4;

constexpr unsigned bit_if(bool condition, unsigned bit) noexcept {
  return condition ? bit : 0U;
}

}  // namespace

RecordBytes::RecordBytes(RecordType type, Moment at) noexcept {
  add_number(static_cast<std::uint64_t>(type), 2);
  add_number(0, 2);
  add_number(static_cast<std::uint64_t>(at.count()), 8);
  store_length();
}

void RecordBytes::store_length() noexcept {
  const std::size_t length = size_ - std::min(size_, kRecordHeadBytes);
  bytes_[kLengthAt] = static_cast<std::byte>(length & 0xFFU);
  bytes_[kLengthAt + 1] = static_cast<std::byte>(length >> 8);
}

void RecordBytes::add_number(std::uint64_t number, std::size_t size) noexcept {
  assert(size_ + size <= bytes_.size());
  for (std::size_t i = 0; i < size; ++i) bytes_[size_++] = static_cast<std::byte>(number >> 8 * i & 0xFFU);
  store_length();
}

void RecordBytes::add_real(double number) noexcept {
  add_number(std::bit_cast<std::uint64_t>(number), sizeof number);
}

void RecordBytes::add_text(std::string_view text) noexcept {
  const std::string_view kept = text.substr(0, std::numeric_limits<std::uint8_t>::max());
  add_number(kept.size(), 1);
  for (const char letter : kept) bytes_[size_++] = static_cast<std::byte>(letter);
  store_length();
}

void RecordBytes::add(std::span<const std::uint8_t> bytes) noexcept {
  for (const std::uint8_t byte : bytes) bytes_[size_++] = static_cast<std::byte>(byte);
  store_length();
}

RecordBytes frame_record(const canopen::Frame& frame, bool sent, Moment at) noexcept {
  RecordBytes record{RecordType::Frame, at};
  record.add_number(bit_if(sent, kSent) | bit_if(frame.remote, kRemote) | bit_if(frame.extended, kExtended), 1);
  record.add_number(frame.length, 1);
  record.add_number(frame.id, 4);
  const std::size_t data = frame.remote ? 0 : std::min<std::size_t>(frame.length, frame.data.size());
  record.add(std::span{frame.data}.first(data));
  return record;
}

RecordBytes event_record(const Event& event, Moment at) noexcept {
  RecordBytes record{RecordType::Event, at};
  for (const unsigned byte : {static_cast<unsigned>(event.kind), static_cast<unsigned>(event.origin),
                              unsigned{event.server}, unsigned{event.object}, unsigned{event.axis},
                              bit_if(event.active, kActive) | bit_if(event.value.has_value(), kHasValue) |
                                  bit_if(event.before.has_value(), kHasBefore)})
    record.add_number(byte, 1);
  record.add_number(event.number, 2);
  record.add_number(event.index, 2);
  record.add_number(event.code, 4);
  record.add_real(event.value.value_or(0.0));
  record.add_real(event.before.value_or(0.0));
  record.add(event.data);
  record.add_text(event.text.substr(0, kLongestText));
  const std::string_view second = event.kind == EventKind::Control ? event.note.text() : event.text_before;
  record.add_text(second.substr(0, kLongestText));
  return record;
}

RecordBytes samples_record(std::span<const double> values, Moment at) noexcept {
  assert(values.size() <= kMostSignals);
  RecordBytes record{RecordType::Samples, at};
  for (const double value : values) record.add_real(value);
  return record;
}

RecordBytes lost_record(std::uint64_t records, Moment at) noexcept {
  RecordBytes record{RecordType::Lost, at};
  record.add_number(records, 8);
  return record;
}

RecordBytes end_record(EndReason reason, Moment at) noexcept {
  RecordBytes record{RecordType::End, at};
  record.add_number(static_cast<std::uint64_t>(reason), 1);
  return record;
}

RecordType type_of(std::span<const std::byte> record) noexcept {
  return static_cast<RecordType>(number_at(record, 0, 2));
}

std::size_t size_of(std::span<const std::byte> record) noexcept {
  return kRecordHeadBytes + static_cast<std::size_t>(number_at(record, kLengthAt, 2));
}

Moment moment_of(std::span<const std::byte> record) noexcept {
  return Moment{static_cast<std::int64_t>(number_at(record, kMomentAt, 8))};
}

std::span<const std::byte> record_at(const ByteRing& ring, std::uint64_t at, RecordBuffer& buffer) noexcept {
  const std::span head = std::span{buffer}.first(kRecordHeadBytes);
  ring.get(at, head);
  const std::span record = std::span{buffer}.first(size_of(head));
  ring.get(at, record);
  return record;
}

}  // namespace record
