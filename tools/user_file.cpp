#include "tools/user_file.hpp"

#include <fstream>
#include <utility>

#include "cli/usage_error.hpp"
#include "tools/sheet_file.hpp"

namespace tools {
namespace {

[[noreturn]] void fail_to_write(const std::string& path) {
  throw cli::UsageError{path + ": cannot be written"};
}

}  // namespace

std::string read_user_file(const std::string& path) {
  auto text = read_sheet_file(path);
  if (!text) throw cli::UsageError{text.error()};
  return *std::move(text);
}

void expect_writable(const std::string& path) {
  if (!path.empty() && !std::ofstream{path, std::ios::binary | std::ios::app}) fail_to_write(path);
}

void write_user_file(const std::string& path, const std::string& text) {
  if (path.empty()) return;
  std::ofstream file{path, std::ios::binary};
  file << text;
  file.flush();
  if (!file) fail_to_write(path);
}

}  // namespace tools
