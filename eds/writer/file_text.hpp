#pragma once

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

// For the tools of the build, which end with the message of an exception.
namespace eds {

/// The whole file at @p path; std::runtime_error.
inline std::string read_file(const std::string& path) {
  std::ifstream file{path, std::ios::binary};
  if (!file) throw std::runtime_error{path + ": cannot be read"};
  return {std::istreambuf_iterator<char>{file}, {}};
}

/// Writes the file at @p path; std::runtime_error.
inline void write_file(const std::string& path, const std::string& text) {
  std::ofstream file{path, std::ios::binary};
  file << text << std::flush;
  if (!file) throw std::runtime_error{path + ": cannot be written"};
}

}  // namespace eds
