#include "audit/base/time_lines.hpp"

#include <utility>

namespace audit {

void TimeLine::add(const Heard& heard, std::string text) {
  Milestone milestone{heard.at, heard.place, std::move(text)};
  if (first_.size() < kMostKept) return first_.push_back(std::move(milestone));
  last_.push_back(std::move(milestone));
  if (last_.size() <= kMostKept) return;
  last_.pop_front();
  ++left_out_;
}

}  // namespace audit
