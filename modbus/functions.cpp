#include "modbus/functions.hpp"

#include <algorithm>
#include <array>

#include <tl/expected.hpp>

namespace modbus {
namespace {

using Bytes = std::span<const std::uint8_t>;
using Response = std::span<std::uint8_t, kMostPduBytes>;
/// The bytes of the answer.
using Answered = tl::expected<std::size_t, Exception>;

constexpr std::size_t kMostRead = 125, kMostWritten = 123;
// Where the parts of requests and answers lie, behind the function.
constexpr std::size_t kAddress = 1, kCount = 3, kValue = 3, kByteCount = 5, kValues = 6;
constexpr std::size_t kReadByteCount = 1, kReadValues = 2;
// The bytes of a request without values to be written, which 06 and 16 answer with, too.
constexpr std::size_t kShort = 5;

bool exist(std::size_t address, std::size_t count) noexcept {
  return address + count <= kRegisters;
}

std::uint16_t number_of(std::size_t address) noexcept {
  return static_cast<std::uint16_t>(kFirstRegister + address);
}

Answered read(Bytes request, Response response, RegisterBank& bank) noexcept {
  if (request.size() != kShort) return tl::unexpected{Exception::BadValue};
  const std::size_t count = word_at(request, kCount), address = word_at(request, kAddress);
  if (count == 0 || count > kMostRead) return tl::unexpected{Exception::BadValue};
  if (!exist(address, count)) return tl::unexpected{Exception::BadAddress};
  std::array<std::uint16_t, kMostRead> values{};
  bank.read(number_of(address), std::span{values}.first(count));
  response[kReadByteCount] = static_cast<std::uint8_t>(count * kWordBytes);
  for (std::size_t i = 0; i < count; ++i) put_word(response, kReadValues + i * kWordBytes, values[i]);
  return kReadValues + count * kWordBytes;
}

Answered write(std::size_t address, std::span<const std::uint16_t> values, RegisterBank& bank) noexcept {
  if (!exist(address, values.size())) return tl::unexpected{Exception::BadAddress};
  if (!bank.write(number_of(address), values)) return tl::unexpected{Exception::ServerFailure};
  return kShort;
}

Answered write_one(Bytes request, Response response, RegisterBank& bank) noexcept {
  if (request.size() != kShort) return tl::unexpected{Exception::BadValue};
  const std::array value{word_at(request, kValue)};
  std::ranges::copy(request, response.begin());
  return write(word_at(request, kAddress), value, bank);
}

Answered write_many(Bytes request, Response response, RegisterBank& bank) noexcept {
  if (request.size() < kValues) return tl::unexpected{Exception::BadValue};
  const std::size_t count = word_at(request, kCount), bytes = count * kWordBytes;
  const bool fits = count != 0 && count <= kMostWritten && request[kByteCount] == bytes;
  if (!fits || request.size() != kValues + bytes) return tl::unexpected{Exception::BadValue};
  std::array<std::uint16_t, kMostWritten> values{};
  for (std::size_t i = 0; i < count; ++i) values[i] = word_at(request, kValues + i * kWordBytes);
  std::ranges::copy(request.first(kShort), response.begin());
  return write(word_at(request, kAddress), std::span{values}.first(count), bank);
}

struct FunctionRow {
  std::uint8_t code;
  Answered (*carry_out)(Bytes request, Response response, RegisterBank& bank) noexcept;
};
constexpr std::array kFunctions{FunctionRow{3, read}, FunctionRow{6, write_one}, FunctionRow{16, write_many}};

Answered carry_out(Bytes request, Response response, RegisterBank& bank) noexcept {
  const auto* const row = std::ranges::find(kFunctions, request.front(), &FunctionRow::code);
  if (row == kFunctions.end()) return tl::unexpected{Exception::UnknownFunction};
  return row->carry_out(request, response, bank);
}

}  // namespace

std::size_t answer(Bytes request, Response response, RegisterBank& bank) noexcept {
  const Answered answered = carry_out(request, response, bank);
  response[0] = request.front();
  if (answered) return *answered;
  response[0] |= kExceptionBit;
  response[1] = static_cast<std::uint8_t>(answered.error());
  return 2;
}

}  // namespace modbus
