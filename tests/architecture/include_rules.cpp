#include "tests/architecture/include_rules.hpp"

#include <algorithm>
#include <optional>
#include <regex>

#include "tests/architecture/source_files.hpp"

namespace architecture {
namespace {

/// An #include line: its target, and whether it stands in angle brackets.
struct Include {
  std::string target;
  bool angled = false;
};

std::optional<Include> include_of(const std::string& line) {
  static const std::regex kInclude{R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)"};
  std::smatch match;
  if (!std::regex_match(line, match, kInclude)) return std::nullopt;
  return Include{match[2], match[1] == "<"};
}

bool allows(std::string_view item, std::string_view target) {
  if (item.empty()) return false;
  return item.back() == '/' ? target.starts_with(item) : target == item;
}

/// Libraries have rules of their own even where they are included in angle brackets.
bool named_by_a_layer(std::string_view target, std::span<const Layer> layers) {
  return std::ranges::any_of(layers, [target](const Layer& layer) {
    return std::ranges::any_of(layer.allowed, [target](std::string_view item) { return allows(item, target); });
  });
}

bool may_include(const Layer& layer, const Include& include, std::span<const Layer> layers) {
  const std::string_view target = include.target;
  const bool standard = include.angled && target.find_first_of("./") == std::string_view::npos;
  const bool own = !include.angled && target.starts_with(std::string{layer.folder} + "/");
  if (standard || own || target == "tl/expected.hpp") return true;
  if (std::ranges::any_of(layer.allowed, [target](std::string_view item) { return allows(item, target); }))
    return true;
  const bool system = include.angled && target.ends_with(".h") && !named_by_a_layer(target, layers);
  return system && std::ranges::count(layer.allowed, kSystem) == 1;
}

bool is_below(std::string_view path, std::string_view folder) {
  return path.starts_with(std::string{folder} + "/");
}

}  // namespace

std::vector<std::string> find_lawless(const std::filesystem::path& root, std::span<const Layer> layers) {
  std::vector<std::string> findings;
  for (const Layer& layer : layers)
    if (read_folder(root, layer.folder).empty())
      findings.push_back(std::string{layer.folder} + ": a layer without a source file");
  for (const std::string& folder : source_folders(root)) {
    if (std::ranges::count(kOutside, folder) == 1) continue;
    for (const SourceFile& file : read_folder(root, folder))
      if (std::ranges::none_of(layers, [&](const Layer& layer) { return is_below(file.path, layer.folder); }))
        findings.push_back(file.path + ": no layer says what it may include");
  }
  return findings;
}

std::vector<std::string> find_forbidden_includes(const std::filesystem::path& root,
                                                 std::span<const Layer> layers) {
  std::vector<std::string> findings;
  for (const Layer& layer : layers)
    for (const SourceFile& file : read_folder(root, layer.folder))
      for (std::size_t n = 0; n < file.lines.size(); ++n) {
        const std::optional<Include> include = include_of(file.lines[n]);
        if (!include || may_include(layer, *include, layers)) continue;
        findings.push_back(file.path + ":" + std::to_string(n + 1) + ": " + std::string{layer.folder} +
                           " may not include " + include->target);
      }
  return findings;
}

}  // namespace architecture
