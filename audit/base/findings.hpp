#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "audit/base/heard.hpp"
#include "audit/base/rule.hpp"

namespace audit {

/// A rule that was broken once.
struct Finding {
  const Rule* rule = nullptr;
  std::uint8_t node = 0;          ///< whose services it concerns; 0: of no one
  std::string text;               ///< what precisely: object, values, times
  std::vector<Heard> evidence{};  ///< the frames that show it, in their order; the last one broke the rule
  std::vector<meaning::Meaning> meanings{};  ///< of the evidence, frame by frame, as it was when this was found

  [[nodiscard]] const Heard& last() const noexcept { return evidence.back(); }
};

/// All that was found. Of each rule and node a few are kept in full, the others are counted.
class Findings {
 public:
  /// Findings of one rule and node that are kept.
  static constexpr std::uint64_t kMostKept = 10;

  /// @p rule was broken on @p node, as the frames of @p evidence show, one at least; @p text() makes the words,
  /// and is called only if they are kept.
  template <class Text>
  void add(const Rule& rule, std::uint8_t node, std::initializer_list<Heard> evidence, Text text) {
    ++total_;
    if (++counts_[{&rule, node}] <= kMostKept) kept_.push_back({&rule, node, text(), evidence, {}});
  }
  /// Notes what the evidence of findings that were added since the last call means, by @p ids.
  void explain(const meaning::CobIds& ids) {
    while (explained_ < kept_.size()) explain(kept_[explained_++], ids);
  }

  /// Those that are kept, in the order in which they were found.
  [[nodiscard]] const std::vector<Finding>& kept() const noexcept { return kept_; }
  /// How often @p rule was broken on @p node.
  [[nodiscard]] std::uint64_t count(const Rule& rule, std::uint8_t node) const noexcept;
  /// How often @p rule was broken, on whatever node.
  [[nodiscard]] std::uint64_t count(const Rule& rule) const noexcept;
  /// How often any rule was broken.
  [[nodiscard]] std::uint64_t total() const noexcept { return total_; }
  /// How often rules of @p severity were broken.
  [[nodiscard]] std::uint64_t count(Severity severity) const noexcept;

 private:
  static void explain(Finding& finding, const meaning::CobIds& ids);

  std::map<std::pair<const Rule*, std::uint8_t>, std::uint64_t> counts_;
  std::vector<Finding> kept_;
  std::size_t explained_ = 0;  ///< of kept_, from its beginning
  std::uint64_t total_ = 0;
};

}  // namespace audit
