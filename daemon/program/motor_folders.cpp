#include "daemon/program/motor_folders.hpp"

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "daemon/program/configuration_file.hpp"
#include "os/folder.hpp"
#include "os/own_program.hpp"

namespace axisd {
namespace {

/// Where presets are looked for, the first hit counts.
std::vector<std::filesystem::path> preset_folders() {
  std::vector<std::filesystem::path> folders;
  const char* const config = std::getenv("XDG_CONFIG_HOME");
  const char* const home = std::getenv("HOME");
  if (config != nullptr && *config != '\0')
    folders.emplace_back(std::filesystem::path{config} / "axisd/motors");
  else if (home != nullptr && *home != '\0')
    folders.emplace_back(std::filesystem::path{home} / ".config/axisd/motors");
  const std::filesystem::path folder = os::program_folder();
  folders.push_back(folder / "../share/axisd/motors");
  folders.push_back(folder / "../../share/axisd/motors");  // of a test program
  return folders;
}

}  // namespace

std::string MotorFolders::path_from(const std::string& file, const std::string& name) const {
  return (std::filesystem::path{file}.parent_path() / name).string();  // an absolute path stands for itself
}

std::optional<std::string> MotorFolders::find_preset(const std::string& name) const {
  std::error_code error;
  for (const std::filesystem::path& folder : preset_folders()) {
    const std::filesystem::path file = folder / (name + ".json");
    if (std::filesystem::exists(file, error)) return file.string();
  }
  return std::nullopt;
}

std::set<std::string> MotorFolders::presets() const {
  std::set<std::string> names;
  for (const std::filesystem::path& folder : preset_folders()) {
    for (const std::string& name : os::names_in(folder.string())) {
      const std::filesystem::path file{name};
      if (file.extension() == ".json" && file.stem().extension().empty()) names.insert(file.stem().string());
    }
  }
  return names;
}

tl::expected<std::string, std::string> MotorFolders::read(const std::string& path) const {
  return read_text_file(path);
}

}  // namespace axisd
