#include "control/discovery/socket_files.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include <sys/stat.h>
#include <unistd.h>

#include "control/discovery/server_trust.hpp"
#include "control/socket_name.hpp"
#include "os/folder.hpp"

namespace control {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSocketOfMany = "axisd.sock";
/// Folders of the services (systemd/): each instance has one of its own in them.
constexpr std::array<std::string_view, 2> kFoldersOfServices{"/run/axisd", "/run/axisd-bus"};

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::vector<fs::path> folders() {
  std::vector<fs::path> found;
  // systemd.exec(5): several folders are separated by colons.
  std::string own = environment("RUNTIME_DIRECTORY");
  for (std::size_t at = 0; at < own.size();
       at = own.find(':', at) == std::string::npos ? own.size() : own.find(':', at) + 1)
    found.emplace_back(own.substr(at, own.find(':', at) - at));
  if (!found.empty()) return found;
  std::vector<fs::path> above{kFoldersOfServices.begin(), kFoldersOfServices.end()};
  if (const std::string user = environment("XDG_RUNTIME_DIR"); !user.empty()) {
    found.emplace_back(user);
    above.push_back(found.back() / "axisd");
  }
  found.insert(found.end(), {"/run", "/tmp"});
  for (const fs::path& folder : above)
    for (const std::string& name : os::names_in(folder)) found.push_back(folder / name);
  return found;
}

bool is_trusted(const fs::path& path) {
  struct stat file {};
  struct stat folder {};
  return ::stat(path.c_str(), &file) == 0 && S_ISSOCK(file.st_mode) &&
         ::stat(path.parent_path().c_str(), &folder) == 0 && is_trusted_server(file.st_uid, ::geteuid(), folder);
}

}  // namespace

std::vector<SocketFile> socket_files() {
  std::vector<SocketFile> files;
  for (const fs::path& folder : folders())
    for (const std::string& name : os::names_in(folder)) {
      const fs::path path = folder / name;
      const auto unit = parse_socket_name(name);
      if ((!unit && name != kSocketOfMany) || !is_trusted(path)) continue;
      files.push_back(
          {path.string(),
           unit ? std::optional{UnitName{std::string{unit->label}, std::string{unit->station}}} : std::nullopt});
    }
  std::ranges::sort(files, {}, &SocketFile::path);
  const auto is_repeated = [](const SocketFile& one, const SocketFile& other) { return one.path == other.path; };
  files.erase(std::unique(files.begin(), files.end(), is_repeated), files.end());
  return files;
}

}  // namespace control
