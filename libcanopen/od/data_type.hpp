#pragma once

#include <cstdint>

namespace canopen {

/// Basic data types by their index in the object dictionary (CiA 301, table 44).
enum class DataType : std::uint16_t {
  Boolean = 0x01,
  Integer8 = 0x02,
  Integer16 = 0x03,
  Integer32 = 0x04,
  Unsigned8 = 0x05,
  Unsigned16 = 0x06,
  Unsigned32 = 0x07,
  Real32 = 0x08,
  VisibleString = 0x09,
  OctetString = 0x0A,
  UnicodeString = 0x0B,
  TimeOfDay = 0x0C,
  TimeDifference = 0x0D,
  Domain = 0x0F,
  Integer24 = 0x10,
  Real64 = 0x11,
  Integer40 = 0x12,
  Integer48 = 0x13,
  Integer56 = 0x14,
  Integer64 = 0x15,
  Unsigned24 = 0x16,
  Unsigned40 = 0x18,
  Unsigned48 = 0x19,
  Unsigned56 = 0x1A,
  Unsigned64 = 0x1B,
};

/// Size of a value of @p type in bytes; 0 for strings and DOMAIN, whose length is that of their data.
constexpr std::uint8_t size_of(DataType type) noexcept {
  switch (type) {
    case DataType::Boolean:
    case DataType::Integer8:
    case DataType::Unsigned8:
      return 1;
    case DataType::Integer16:
    case DataType::Unsigned16:
      return 2;
    case DataType::Integer24:
    case DataType::Unsigned24:
      return 3;
    case DataType::Integer32:
    case DataType::Unsigned32:
    case DataType::Real32:
      return 4;
    case DataType::Integer40:
    case DataType::Unsigned40:
      return 5;
    case DataType::Integer48:
    case DataType::Unsigned48:
    case DataType::TimeOfDay:
    case DataType::TimeDifference:
      return 6;
    case DataType::Integer56:
    case DataType::Unsigned56:
      return 7;
    case DataType::Integer64:
    case DataType::Unsigned64:
    case DataType::Real64:
      return 8;
    case DataType::VisibleString:
    case DataType::OctetString:
    case DataType::UnicodeString:
    case DataType::Domain:
      return 0;
  }
  return 0;
}

/// True for the two's complement integers.
constexpr bool is_signed(DataType type) noexcept {
  switch (type) {
    case DataType::Integer8:
    case DataType::Integer16:
    case DataType::Integer24:
    case DataType::Integer32:
    case DataType::Integer40:
    case DataType::Integer48:
    case DataType::Integer56:
    case DataType::Integer64:
      return true;
    default:
      return false;
  }
}

}  // namespace canopen
