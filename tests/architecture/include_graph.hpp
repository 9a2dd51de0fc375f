#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace architecture {

/// Who includes whom, of files or of folders.
using IncludeGraph = std::map<std::string, std::set<std::string>>;

/// Every source file of @p folders below @p root, and the sources of them that it includes. An include is looked
/// for from the root and beside the file.
IncludeGraph include_graph(const std::filesystem::path& root, std::span<const std::string_view> folders);

/// The same of the folders in which the files of @p files lie; a folder's files among themselves do not count. A
/// folder and one within it are two.
IncludeGraph folder_graph(const IncludeGraph& files);

/// For every group of nodes of which each comes back to itself by way of the others, one way round:
/// "a.hpp -> b.hpp -> a.hpp".
std::vector<std::string> find_circles(const IncludeGraph& graph);

}  // namespace architecture
