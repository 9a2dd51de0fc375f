#include "service/journal.hpp"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace axisd {
namespace {

constexpr std::string_view kPath = "/run/systemd/journal/socket";

/// A value with a newline has its length in front of it, 64 bits in little endian, and a line for its name.
void append(std::string& entry, const Journal::Field& field) {
  entry.append(field.name);
  if (field.value.find('\n') == std::string_view::npos) {
    entry.append("=").append(field.value).append("\n");
    return;
  }
  entry.append("\n");
  for (unsigned shift = 0; shift < 64; shift += 8)
    entry += static_cast<char>(static_cast<std::uint64_t>(field.value.size()) >> shift & 0xFF);
  entry.append(field.value).append("\n");
}

sockaddr_un journal_address() noexcept {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  kPath.copy(address.sun_path, kPath.size());
  return address;
}

}  // namespace

bool Journal::has_standard_error() noexcept {
  const char* const stream = std::getenv("JOURNAL_STREAM");
  struct stat status {};
  if (stream == nullptr || fstat(STDERR_FILENO, &status) != 0) return false;
  return std::to_string(status.st_dev) + ':' + std::to_string(status.st_ino) == stream;
}

bool Journal::send(std::span<const Field> fields) {
  if (!socket_) socket_ = os::Descriptor{::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)};
  std::string entry;
  for (const Field& field : fields) append(entry, field);
  const sockaddr_un address = journal_address();
  return ::sendto(socket_.get(), entry.data(), entry.size(), MSG_NOSIGNAL,
                  reinterpret_cast<const sockaddr*>(&address), sizeof address) >= 0;
}

}  // namespace axisd
