#include "tests/architecture/include_graph.hpp"

#include <algorithm>
#include <deque>
#include <regex>

#include "tests/architecture/source_files.hpp"

namespace architecture {
namespace {

namespace fs = std::filesystem;

std::string folder_of(const std::string& path) {
  return fs::path{path}.parent_path().generic_string();
}

/// The nodes that can be reached from @p start, each with the one before it on a shortest way.
std::map<std::string, std::string> ways_from(const IncludeGraph& graph, const std::string& start) {
  std::map<std::string, std::string> before;
  std::deque<std::string> next{start};
  while (!next.empty()) {
    const std::string node = next.front();
    next.pop_front();
    const auto found = graph.find(node);
    if (found == graph.end()) continue;
    for (const std::string& target : found->second)
      if (before.try_emplace(target, node).second) next.push_back(target);
  }
  return before;
}

}  // namespace

IncludeGraph include_graph(const fs::path& root, std::span<const std::string_view> folders) {
  static const std::regex kQuoted{R"re(^\s*#\s*include\s*"([^"]+)".*)re"};
  std::vector<SourceFile> sources;
  for (const std::string_view folder : folders)
    std::ranges::move(read_folder(root, folder), std::back_inserter(sources));
  IncludeGraph graph;
  for (const SourceFile& file : sources) graph[file.path];
  std::smatch match;
  for (const SourceFile& file : sources)
    for (const std::string& line : file.lines) {
      if (line.find("include") == std::string::npos || !std::regex_match(line, match, kQuoted)) continue;
      const std::string beside =
          (fs::path{folder_of(file.path)} / match[1].str()).lexically_normal().generic_string();
      for (const std::string& target : {match[1].str(), beside})
        if (graph.contains(target)) graph[file.path].insert(target);
    }
  return graph;
}

IncludeGraph folder_graph(const IncludeGraph& files) {
  IncludeGraph graph;
  for (const auto& [file, targets] : files)
    for (const std::string& target : targets)
      if (folder_of(file) != folder_of(target)) graph[folder_of(file)].insert(folder_of(target));
  return graph;
}

std::vector<std::string> find_circles(const IncludeGraph& graph) {
  std::vector<std::string> circles;
  std::set<std::string> told;
  for (const auto& [node, targets] : graph) {
    if (told.contains(node)) continue;
    const std::map<std::string, std::string> before = ways_from(graph, node);
    if (!before.contains(node)) continue;
    // All that come back here belong to the same group.
    for (const auto& [other, unused] : before)
      if (ways_from(graph, other).contains(node)) told.insert(other);
    std::string circle = node;
    for (std::string at = before.at(node); at != node; at = before.at(at)) circle.insert(0, at + " -> ");
    circles.push_back(node + " -> " + circle);
  }
  return circles;
}

}  // namespace architecture
