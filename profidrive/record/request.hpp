#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <tl/expected.hpp>

#include "drive/parameter/error.hpp"
#include "profidrive/parameter/format.hpp"

namespace profidrive::record {

/// What a request wants.
enum class Service : std::uint8_t { Read = 0x01, Write = 0x02 };

/// What of a parameter an address means.
enum class Attribute : std::uint8_t { Value = 0x10, Description = 0x20, Text = 0x30 };

/// The beginning of a request, as far as it is there; the rest is 0.
struct Header {
  std::uint8_t reference = 0;
  std::uint8_t service = 0;
  std::uint8_t object = 0;
  std::uint8_t count = 0;  ///< parameters
};
inline constexpr std::size_t kHeaderBytes = 4;

/// A parameter that a request is about.
struct Address {
  std::uint8_t attribute = 0;
  std::uint8_t elements = 0;
  std::uint16_t number = 0;
  std::uint16_t sub_index = 0;

  /// 0 stands for one.
  std::size_t count() const noexcept { return elements == 0 ? std::size_t{1} : elements; }
};
inline constexpr std::size_t kAddressBytes = 6;
inline constexpr std::size_t kMostParameters = 39;

/// What a request brings for a parameter.
struct Values {
  const FormatRow* format = nullptr;  ///< nullptr: an unknown one
  std::size_t count = 0;
  std::span<const std::uint8_t> bytes{};
};

/// The beginning of @p record.
Header header_of(std::span<const std::uint8_t> record) noexcept;

/// Takes a request apart.
class Request {
 public:
  /// @p record outlives this. UnknownService, BadAddress for a number of parameters that there cannot be, and for
  /// a record that ends before what it declares; what lies behind that is ignored.
  [[nodiscard]] static tl::expected<Request, drive::RefusalReason> of(
      std::span<const std::uint8_t> record) noexcept;

  Service service() const noexcept { return Service{header_.service}; }
  std::uint8_t object() const noexcept { return header_.object; }
  std::size_t count() const noexcept { return header_.count; }
  /// Of parameter @p place, from 0.
  Address address(std::size_t place) const noexcept;
  /// What a request to write brings for each parameter in turn, from the first one on. Nothing behind an unknown
  /// format: where its values end is not known.
  std::optional<Values> take_values() noexcept;

 private:
  Request(const Header& header, std::span<const std::uint8_t> addresses,
          std::span<const std::uint8_t> values) noexcept
      : header_{header}, addresses_{addresses}, values_{values} {}

  Header header_;
  std::span<const std::uint8_t> addresses_;
  std::optional<std::span<const std::uint8_t>> values_;  ///< those to come, if they can be found
};

}  // namespace profidrive::record
