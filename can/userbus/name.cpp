#include "can/userbus/name.hpp"

#include <cerrno>
#include <cstring>

namespace userbus {

namespace {

constexpr size_t kPrefixLength = sizeof kNamePrefix - 1;
constexpr unsigned kBitsOfDigit = 4;

/// Behind the zero byte of the abstract name space.
constexpr size_t kFirst = offsetof(sockaddr_un, sun_path) + 1;

bool read_number(const char* digits, uint64_t& number) noexcept {
  number = 0;
  for (size_t i = 0; i < kNameDigits; ++i) {
    const char digit = digits[i];
    const bool decimal = digit >= '0' && digit <= '9';
    if (!decimal && (digit < 'a' || digit > 'f')) return false;
    number = number << kBitsOfDigit | static_cast<uint64_t>(decimal ? digit - '0' : digit - 'a' + 10);
  }
  return true;
}

}  // namespace

socklen_t make_name(Kind kind, uint64_t number, sockaddr_un& address) noexcept {
  address = {};
  address.sun_family = AF_UNIX;
  char* at = address.sun_path + 1;
  memcpy(at, kNamePrefix, kPrefixLength);
  at += kPrefixLength;
  const char* const word = kKindNames[static_cast<size_t>(kind)];
  memcpy(at, word, strlen(word));  // NOLINT(bugprone-not-null-terminated-result): the name has no zero
  at += strlen(word);
  *at++ = '/';
  for (size_t i = 0; i < kNameDigits; ++i)
    *at++ = "0123456789abcdef"[number >> (kBitsOfDigit * (kNameDigits - 1 - i)) & 0xF];
  return static_cast<socklen_t>(at - reinterpret_cast<const char*>(&address));
}

bool read_name(const sockaddr_un& address, socklen_t length, Name& name) noexcept {
  if (address.sun_family != AF_UNIX || length < kFirst + kPrefixLength || length > sizeof address) return false;
  const char* const text = address.sun_path + 1;
  if (address.sun_path[0] != '\0' || memcmp(text, kNamePrefix, kPrefixLength) != 0) return false;
  for (size_t kind = 0; kind < sizeof kKindNames / sizeof *kKindNames; ++kind) {
    const size_t word = strlen(kKindNames[kind]);
    if (length != kFirst + kPrefixLength + word + 1 + kNameDigits) continue;
    if (memcmp(text + kPrefixLength, kKindNames[kind], word) != 0 || text[kPrefixLength + word] != '/') continue;
    name.kind = static_cast<Kind>(kind);
    return read_number(text + kPrefixLength + word + 1, name.number);
  }
  return false;
}

bool name_of(int descriptor, Name& name) noexcept {
  const int error = errno;
  sockaddr_un address{};
  socklen_t length = sizeof address;
  const bool known = getsockname(descriptor, reinterpret_cast<sockaddr*>(&address), &length) == 0 &&
                     read_name(address, length, name);
  errno = error;
  return known;
}

}  // namespace userbus
