#include "farm/options/host_option.hpp"

#include <array>
#include <climits>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include "farm/naming/unit_name.hpp"
#include "text/name.hpp"

namespace farm {
namespace {

constexpr const char* kOption = "--host";

std::string name_of_machine() {
  std::array<char, HOST_NAME_MAX + 1> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0 || name[0] == '\0') return "host";
  return name_from(name.data());
}

}  // namespace

void add_host(CLI::App& app, std::string& word) {
  app.add_option(kOption, word, "name of this host on the farm (default: that of the machine)")->type_name("NAME");
}

tl::expected<std::string, std::string> read_host(const std::string& word) {
  if (word.empty()) return name_of_machine();
  if (is_name(word)) return word;
  return tl::unexpected{fmt::format("{}: expected a name of {}, got \"{}\"", kOption, text::kNameForm, word)};
}

}  // namespace farm
