#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "tests/fakes/temporary_directory.hpp"
#include "tools/axisctl/runs/log/log_reader.hpp"

namespace runs_test {

/// Logs in files.
class Logs {
 public:
  /// The path of a file with @p text.
  std::string write(const std::string& name, std::string_view text) {
    const std::string path = folder_.path(name);
    std::ofstream{path, std::ios::binary} << text;
    return path;
  }
  /// The path of a log of @p frames, which come a millisecond apart: "605#40... 585#43...".
  std::string write_frames(const std::string& name, std::string_view frames) {
    return write(name, lines_of(frames));
  }
  /// Those frames as `candump -l` writes them. A word "+20" lets so many milliseconds pass in place of one.
  static std::string lines_of(std::string_view frames) {
    std::istringstream words{std::string{frames}};
    std::string text;
    int at = 0;
    for (std::string word; words >> word; ++at) {
      if (word.starts_with('+'))
        at += std::stoi(word.substr(1)) - 2;
      else
        text += fmt::format("({}.{:03}000) can0 {}\n", 1'700'000'000 + at / 1000, at % 1000, word);
    }
    return text;
  }
  std::string path(const std::string& name) const { return folder_.path(name); }
  /// @p text without the folder of the logs.
  std::string shown(std::string text) const {
    const std::string folder = folder_.path() + '/';
    for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder))
      text.erase(at, folder.size());
    return text;
  }

 private:
  fakes::TemporaryDirectory folder_;
};

}  // namespace runs_test
