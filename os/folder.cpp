#include "os/folder.hpp"

#include <memory>
#include <string_view>

#include <dirent.h>

namespace os {

std::vector<std::string> names_in(const std::string& folder) {
  const auto close = [](DIR* stream) { ::closedir(stream); };
  const std::unique_ptr<DIR, decltype(close)> stream{::opendir(folder.c_str()), close};
  std::vector<std::string> names;
  if (!stream) return names;
  while (const dirent* const entry = ::readdir(stream.get())) {
    const std::string_view name = entry->d_name;
    if (name != "." && name != "..") names.emplace_back(name);
  }
  return names;
}

}  // namespace os
