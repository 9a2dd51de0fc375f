#include "gateway/security/token.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include "os/descriptor.hpp"
#include "os/regular_file.hpp"

namespace gateway {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kRandomBytes = 32;
constexpr std::size_t kShortest = 32;  // characters
constexpr std::size_t kLongest = 256;

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

tl::unexpected<std::string> failed(const std::string& path, std::string_view what, int error) {
  return tl::unexpected{fmt::format("{}: {}: {}", path, what, std::generic_category().message(error))};
}

bool is_token_character(char c) noexcept {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '-' || c == '_';
}

std::string random_token() {
  std::array<unsigned char, kRandomBytes> bytes{};
  // Up to 256 bytes come whole once the kernel has gathered enough, which getrandom() waits for.
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) return {};
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

bool write_all(int file, std::string_view text) noexcept {
  return ::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size()) && ::fsync(file) == 0;
}

/// It has its name when it is whole; a token that another process has made meanwhile stays.
tl::expected<void, std::string> make_token(const std::string& path) {
  std::error_code error;
  fs::create_directories(fs::path{path}.parent_path(), error);
  const std::string token = random_token();
  if (token.empty()) return failed(path, "no random numbers", errno);
  const std::string fresh = path + ".new";
  ::unlink(fresh.c_str());
  const os::Descriptor file{
      ::open(fresh.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, S_IRUSR | S_IWUSR)};
  if (!file) return failed(fresh, "cannot be made", errno);
  const bool is_written =
      write_all(file.get(), token + '\n') && (::link(fresh.c_str(), path.c_str()) == 0 || errno == EEXIST);
  const int reason = errno;
  ::unlink(fresh.c_str());
  if (!is_written) return failed(path, "cannot be written", reason);
  return {};
}

}  // namespace

tl::expected<std::string, std::string> token_path() {
  if (const std::string state = environment("STATE_DIRECTORY"); !state.empty())
    return state.substr(0, state.find(':')) + "/token";
  if (const std::string state = environment("XDG_STATE_HOME"); !state.empty()) return state + "/axisd-http/token";
  if (const std::string home = environment("HOME"); !home.empty()) return home + "/.local/state/axisd-http/token";
  return tl::unexpected{
      std::string{"no place for the token: none of $STATE_DIRECTORY, $XDG_STATE_HOME and $HOME is set; "
                  "--token-file names one"}};
}

tl::expected<std::string, std::string> load_token(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 && errno == ENOENT)
    if (const auto made = make_token(path); !made) return tl::unexpected{made.error()};
  auto text = os::read_regular_file(path, kLongest);
  if (!text) return tl::unexpected{fmt::format("{}: cannot be read: {}", path, text.error().reason())};
  if (::stat(path.c_str(), &status) == 0 && (status.st_mode & (S_IROTH | S_IWOTH | S_IWGRP)) != 0)
    return tl::unexpected{fmt::format("{}: others may read or write the token (mode {:04o}, expected 0600)", path,
                                      status.st_mode & ALLPERMS)};
  while (text->ends_with('\n')) text->pop_back();
  if (text->size() >= kShortest && std::ranges::all_of(*text, is_token_character)) return *std::move(text);
  return tl::unexpected{
      fmt::format("{}: is no token: expected at least {} letters, digits, - and _", path, kShortest)};
}

}  // namespace gateway
