#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "drive/parameter/row.hpp"

namespace axisd {

/// What somebody looks for among parameters: the beginning of a number ("112", "p112"), or else words that all
/// occur in its name or in what it does, whatever their case.
class SearchText {
 public:
  explicit SearchText(std::string_view text);

  /// Whether @p row is meant. An empty text means every one.
  bool finds(const drive::ParameterRow& row) const;

 private:
  std::vector<std::string> words_;
  std::string number_;  ///< the digits of a number, with its letter if it has one
};

}  // namespace axisd
