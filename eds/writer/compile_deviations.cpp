#include <cstdio>
#include <exception>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "eds/writer/file_text.hpp"

// Makes lists from tables of docs/reference/deviations.md: for canopen-check the deviations from the standards and
// which check meets which of them, for axisctl twin the differences of axisd from the unit.
namespace {

using Cells = std::vector<std::string>;

std::string_view trimmed(std::string_view cell) {
  while (cell.starts_with(' ')) cell.remove_prefix(1);
  while (cell.ends_with(' ')) cell.remove_suffix(1);
  return cell;
}

/// The cells of a line "| a | b |".
Cells cells_of(std::string_view line) {
  Cells cells;
  line.remove_prefix(1);
  for (std::size_t bar = line.find('|'); bar != std::string_view::npos; bar = line.find('|')) {
    cells.emplace_back(trimmed(line.substr(0, bar)));
    line.remove_prefix(bar + 1);
  }
  return cells;
}

/// The rows of the table on @p page whose header begins with @p header; each has @p columns cells.
std::vector<Cells> table(std::string_view page, std::string_view header, std::size_t columns) {
  std::vector<Cells> rows;
  std::size_t at = page.find(fmt::format("\n{}", header));
  if (at == std::string_view::npos) throw std::runtime_error{fmt::format("no table begins with \"{}\"", header)};
  for (++at; at < page.size() && page[at] == '|';) {
    const std::size_t end = std::min(page.find('\n', at), page.size());
    rows.push_back(cells_of(page.substr(at, end - at)));
    if (rows.back().size() != columns)
      throw std::runtime_error{fmt::format("expected {} cells, got {}", columns, page.substr(at, end - at))};
    at = end + 1;
  }
  rows.erase(rows.begin(), rows.begin() + std::min<std::ptrdiff_t>(2, std::ssize(rows)));
  return rows;
}

nlohmann::ordered_json list_of(const std::string& page) {
  std::map<std::string, Cells> deviations;
  for (Cells& row : table(page, "| id |", 6)) deviations.emplace(row[0], row);
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Cells& row : table(page, "| check |", 3)) {
    const auto deviation = deviations.find(row[1]);
    if (deviation == deviations.end())
      throw std::runtime_error{fmt::format("{}: no such deviation as {}", row[0], row[1])};
    nlohmann::ordered_json item{{"check", row[0]},
                                {"reason", deviation->second[4]},
                                {"source", fmt::format("{}: {}", row[1], deviation->second[5])}};
    if (row[2] != "-") item["object"] = row[2];
    list.push_back(std::move(item));
  }
  return list;
}

nlohmann::ordered_json differences_of(const std::string& page) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Cells& row : table(page, "| difference |", 4))
    list.push_back({{"difference", row[0]}, {"id", row[1]}, {"object", row[2]}, {"reason", row[3]}});
  return list;
}

}  // namespace

int main(int count, char** words) try {
  if (count != 4) return std::fputs("usage: compile_deviations PAGE DEVIATIONS DIFFERENCES\n", stderr), 2;
  const std::string page = eds::read_file(words[1]);
  eds::write_file(words[2], list_of(page).dump(2) + "\n");
  eds::write_file(words[3], differences_of(page).dump(2) + "\n");
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s: %s\n", count > 1 ? words[1] : "compile_deviations", error.what());
  return 1;
}
