#include "profidrive/record/request.hpp"

#include "profidrive/parameter/big_endian.hpp"

namespace profidrive::record {
namespace {

using drive::RefusalReason;
using Bytes = std::span<const std::uint8_t>;

/// Format and number in front of values.
constexpr std::size_t kValueHead = 2;

/// The values at the start of @p rest, which loses them; nothing if it ends before they do. Of an unknown format
/// all that follows.
std::optional<Values> take(Bytes& rest) noexcept {
  if (rest.size() < kValueHead) return std::nullopt;
  Values values{.format = find_format(rest[0]), .count = rest[1]};
  rest = rest.subspan(kValueHead);
  const std::size_t size = values.format != nullptr ? values.count * values.format->size : rest.size();
  const std::size_t padded = size + (values.format != nullptr ? size % 2 : 0);
  if (rest.size() < padded) return std::nullopt;
  values.bytes = rest.first(size);
  rest = rest.subspan(padded);
  return values;
}

/// Whether @p rest has values for @p count parameters, as far as their formats are known.
bool is_complete(Bytes rest, std::size_t count) noexcept {
  for (std::size_t i = 0; i < count; ++i) {
    const auto values = take(rest);
    if (!values) return false;
    if (values->format == nullptr) return true;
  }
  return true;
}

}  // namespace

Header header_of(Bytes record) noexcept {
  const auto byte = [&](std::size_t place) { return place < record.size() ? record[place] : std::uint8_t{0}; };
  return {byte(0), byte(1), byte(2), byte(3)};
}

tl::expected<Request, RefusalReason> Request::of(Bytes record) noexcept {
  const Header header = header_of(record);
  const bool reads = header.service == static_cast<std::uint8_t>(Service::Read);
  const bool writes = header.service == static_cast<std::uint8_t>(Service::Write);
  if (record.size() > 1 && !reads && !writes) return tl::unexpected{RefusalReason::UnknownService};
  const std::size_t addresses = header.count * kAddressBytes;
  const bool is_whole = record.size() >= kHeaderBytes + addresses;
  if (header.count == 0 || header.count > kMostParameters || !is_whole)
    return tl::unexpected{RefusalReason::BadAddress};
  const Bytes values = record.subspan(kHeaderBytes + addresses);
  if (writes && !is_complete(values, header.count)) return tl::unexpected{RefusalReason::BadAddress};
  return Request{header, record.subspan(kHeaderBytes, addresses), values};
}

Address Request::address(std::size_t place) const noexcept {
  const Bytes bytes = addresses_.subspan(place * kAddressBytes, kAddressBytes);
  return {.attribute = bytes[0],
          .elements = bytes[1],
          .number = static_cast<std::uint16_t>(number_in(bytes.subspan(2, 2))),
          .sub_index = static_cast<std::uint16_t>(number_in(bytes.subspan(4, 2)))};
}

std::optional<Values> Request::take_values() noexcept {
  if (!values_) return std::nullopt;
  const auto values = take(*values_);
  if (values && values->format == nullptr) values_.reset();
  return values;
}

}  // namespace profidrive::record
