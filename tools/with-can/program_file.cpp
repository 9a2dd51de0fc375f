#include "tools/with-can/program_file.hpp"

#include <cstdlib>
#include <ranges>

#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include "tools/with-can/elf_file.hpp"
#include "tools/with-can/script.hpp"

namespace with_can {

namespace {

/// Interpreters of interpreters that are followed: more than the kernel follows.
constexpr int kMostScripts = 8;

constexpr std::string_view kOtherWays =
    "reach the bus through canhub's --bridge udp-multicast:// or --socketcand, or run it where the kernel has "
    "vcan";

bool is_file(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

Verdict not_executable(const std::filesystem::path& path) {
  return {kNotExecutable, fmt::format("{}: is not an executable file", path.string())};
}

Verdict unfit(const std::filesystem::path& path, std::string_view why, std::string_view instead = kOtherWays) {
  return {kUnfit, fmt::format("{}: {}; {}", path.string(), why, instead)};
}

/// What the kernel runs with rights that the caller has not starts without LD_PRELOAD.
Verdict judge_rights(const std::filesystem::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return not_executable(path);
  constexpr std::string_view kCopy = "use a copy of it (cp drops them), run by somebody who has its rights";
  if ((status.st_mode & (S_ISUID | S_ISGID)) != 0)
    return unfit(path, "is setuid or setgid, and such programs ignore LD_PRELOAD", kCopy);
  if (::getxattr(path.c_str(), "security.capability", nullptr, 0) > 0)
    return unfit(path, "has file capabilities, and such programs ignore LD_PRELOAD", kCopy);
  return {};
}

Verdict judge_elf(const std::filesystem::path& path, const ElfFile& file) {
  const std::optional<ElfFile> own = read_elf("/proc/self/exe");
  if (!own) return {1, "/proc/self/exe: cannot be read"};
  if (file.word_class != own->word_class || file.byte_order != own->byte_order || file.machine != own->machine)
    return unfit(path, "was built for another machine or word size than this with-can",
                 "use a with-can that was built for it");
  if (file.loader.empty()) return unfit(path, "is linked statically, so that nothing can be preloaded");
  const std::filesystem::path loader{file.loader};
  if (loader.filename() != std::filesystem::path{own->loader}.filename())
    return unfit(path, fmt::format("uses another C library ({})", loader.filename().string()));
  return judge_rights(path);
}

FoundProgram found_at(const std::filesystem::path& path) {
  if (::access(path.c_str(), F_OK) != 0)
    return {path, {kNotFound, fmt::format("{}: no such file", path.string())}};
  if (!is_file(path) || ::access(path.c_str(), X_OK) != 0) return {path, not_executable(path)};
  return {path, {}};
}

/// The program that runs @p path; it is @p path itself unless that is a script.
FoundProgram runner_of(const std::filesystem::path& path) {
  const std::optional<std::string> name = interpreter_of_script(path);
  if (!name) return {path, {}};
  return find_program(name->empty() ? std::string_view{"/bin/sh"} : std::string_view{*name});
}

}  // namespace

FoundProgram find_program(std::string_view name) {
  if (name.find('/') != std::string_view::npos) return found_at(name);
  const char* const variable = std::getenv("PATH");
  const std::string_view folders = variable != nullptr ? variable : "/bin:/usr/bin";
  FoundProgram second_best{{}, {kNotFound, fmt::format("{}: no such program in $PATH", name)}};
  for (const auto folder : std::views::split(folders, ':')) {
    const std::string_view text{folder.begin(), folder.end()};
    const std::filesystem::path path = std::filesystem::path{text.empty() ? "." : text} / name;
    if (!is_file(path)) continue;
    if (::access(path.c_str(), X_OK) == 0) return {path, {}};
    second_best = {path, not_executable(path)};
  }
  return second_best;
}

Verdict judge_program(const std::filesystem::path& path) {
  std::filesystem::path at = path;
  for (int depth = 0; depth < kMostScripts; ++depth) {
    if (::access(at.c_str(), R_OK) != 0) return judge_rights(at);  // no more can be known
    if (const std::optional<ElfFile> file = read_elf(at)) return judge_elf(at, *file);
    FoundProgram runner = runner_of(at);
    if (runner.verdict.status != 0) {
      runner.verdict.message = fmt::format("{}: its interpreter {}", path.string(), runner.verdict.message);
      return runner.verdict;
    }
    at = runner.path;
  }
  return unfit(path, "is a script whose interpreters are scripts without end", "run what is behind it");
}

}  // namespace with_can
