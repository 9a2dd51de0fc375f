#include "tools/axisctl/fleet/check.hpp"

#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "os/descriptor.hpp"

extern char** environ;

namespace fleet {
namespace {

constexpr int kConfiguration = 3;  ///< descriptor in the child
constexpr const char* kPath = "/dev/fd/3";
constexpr const char* kProgram = "axisd: ";
constexpr std::size_t kLongestMessage = 4096;

tl::unexpected<std::string> failure(const std::string& what, int error) {
  return tl::unexpected{fmt::format("{}: {}", what, std::generic_category().message(error))};
}

/// A file without a name that has @p content.
os::Descriptor file_of(std::string_view content) {
  os::Descriptor file{::memfd_create("configuration", MFD_CLOEXEC)};
  while (file && !content.empty()) {
    const ssize_t written = ::write(file.get(), content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return os::Descriptor{};
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return file;
}

/// Runs the @p program with @p configuration and @p errors for what it says; its exit status, or -1 with errno.
int run(const std::string& program, const os::Descriptor& configuration, const os::Descriptor& errors) {
  posix_spawn_file_actions_t actions{};
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, errors.get(), STDERR_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, configuration.get(), kConfiguration);
  std::array<std::string, 4> words{program, "--check-config", "--config", kPath};
  std::array<char*, 5> pointers{words[0].data(), words[1].data(), words[2].data(), words[3].data(), nullptr};
  pid_t child = 0;
  errno = ::posix_spawn(&child, program.c_str(), &actions, nullptr, pointers.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (errno != 0) return -1;
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

/// What the program has said, of @p file instead of the descriptor.
std::string said(const os::Descriptor& errors, const std::string& file) {
  std::string text(kLongestMessage, '\0');
  const ssize_t size = ::pread(errors.get(), text.data(), text.size(), 0);
  text.resize(size < 0 ? 0 : static_cast<std::size_t>(size));
  text = text.substr(0, text.find('\n'));
  if (text.starts_with(kProgram)) text.erase(0, std::string_view{kProgram}.size());
  if (const std::size_t at = text.find(kPath); at != std::string::npos)
    text.replace(at, std::string_view{kPath}.size(), file);
  return text.empty() ? file + ": axisd cannot use it" : text;
}

}  // namespace

tl::expected<Checked, std::string> check_configuration(const std::string& folder,
                                                       const nlohmann::json& configuration,
                                                       const std::string& file) {
  const std::string program = folder + "/axisd";
  if (::access(program.c_str(), X_OK) != 0) return Checked::NotAtAll;
  const os::Descriptor content = file_of(configuration.dump());
  const os::Descriptor errors = file_of("");
  if (!content || !errors) return failure("memfd_create", errno);
  const int status = run(program, content, errors);
  if (status < 0) return failure(program, errno);
  if (status == 0) return Checked::Right;
  return tl::unexpected{said(errors, file)};
}

}  // namespace fleet
