#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace axisctl {

/// Lines in columns that are as wide as their widest text.
class Table {
 public:
  explicit Table(std::vector<std::string> heads) : lines_{std::move(heads)} {}

  /// As many texts as there are heads.
  void add(std::vector<std::string> cells) { lines_.push_back(std::move(cells)); }
  /// Prints the lines, below the heads if @p with_heads; each line behind @p indent blanks.
  void print(std::ostream& out, bool with_heads = true, std::size_t indent = 0) const;

 private:
  std::vector<std::vector<std::string>> lines_;  // the first are the heads
};

}  // namespace axisctl
