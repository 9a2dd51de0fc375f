#include "eds/document/document.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace eds {

Line::Line(std::string text, std::string_view ending, unsigned number)
    : text_{std::move(text)}, ending_{ending}, number_{number} {
  take_apart();
}

Line::Part Line::part_of(std::string_view piece) const noexcept {
  return {.begin = static_cast<std::size_t>(piece.data() - text_.data()), .size = piece.size()};
}

void Line::take_apart() {
  const std::string_view content = trimmed(text_);
  const std::size_t equals = content.find('=');
  if (content.empty()) {
    kind_ = LineKind::Blank;
  } else if (content.front() == ';' || content.front() == '#') {
    kind_ = LineKind::Comment;
  } else if (content.front() == '[') {
    if (content.find(']') != content.size() - 1) return;
    const std::string_view name = trimmed(content.substr(1, content.size() - 2));
    if (name.empty()) return;
    kind_ = LineKind::Header;
    key_ = part_of(name);
  } else if (equals != std::string_view::npos && equals != 0) {
    kind_ = LineKind::Entry;
    key_ = part_of(trimmed(content.substr(0, equals)));
    value_ = part_of(trimmed(content.substr(equals + 1)));
  }
}

void Line::set_value(std::string_view value) {
  text_.replace(value_.begin, value_.size, value);
  value_.size = value.size();
}

void Line::end_with(std::string_view ending) {
  if (ending_.empty()) ending_ = ending;
}

const Line* Section::find(std::string_view key) const noexcept {
  const auto found = std::ranges::find_if(lines_, [key](const Line& line) {
    return line.kind() == LineKind::Entry && equal_in_any_case(line.key(), key);
  });
  return found == lines_.end() ? nullptr : &*found;
}

std::string_view Section::value(std::string_view key) const noexcept {
  const Line* const line = find(key);
  return line == nullptr ? std::string_view{} : line->value();
}

Place Section::place(std::string_view key) const noexcept {
  const Line* const line = find(key);
  if (line == nullptr) return {.section = name(), .key = key, .line = header_.number()};
  return {.section = name(), .key = line->key(), .line = line->number()};
}

void Section::set(std::string_view key, std::string_view value) {
  const auto is_entry = [](const Line& line) { return line.kind() == LineKind::Entry; };
  const auto same = std::ranges::find_if(
      lines_, [&](const Line& line) { return is_entry(line) && equal_in_any_case(line.key(), key); });
  if (same != lines_.end()) return same->set_value(value);
  const auto last = std::find_if(lines_.rbegin(), lines_.rend(), is_entry).base();
  Line& before = last == lines_.begin() ? header_ : *(last - 1);
  const std::string_view ending = before.ending();
  before.end_with(header_.ending().empty() ? "\r\n" : header_.ending());
  lines_.insert(last, Line{fmt::format("{}={}", key, value), ending, 0});
}

bool Section::remove(std::string_view key) {
  return std::erase_if(lines_, [key](const Line& line) {
           return line.kind() == LineKind::Entry && equal_in_any_case(line.key(), key);
         }) != 0;
}

void Section::end_with(std::string_view ending) {
  if (!lines_.empty()) return lines_.back().end_with(ending);
  if (!header_.text().empty()) header_.end_with(ending);
}

Document::Document() {
  append(Line{"", "", 0});
}

Section& Document::append(Line header) {
  Section& added = sections_.emplace_back(std::move(header));
  if (!added.name().empty()) by_name_.try_emplace(lower_case(added.name()), sections_.size() - 1);
  return added;
}

void Document::index() {
  by_name_.clear();
  for (std::size_t n = 0; n < sections_.size(); ++n)
    if (!sections_[n].name().empty()) by_name_.try_emplace(lower_case(sections_[n].name()), n);
}

const Section* Document::find(std::string_view name) const {
  const auto found = by_name_.find(lower_case(name));
  return found == by_name_.end() ? nullptr : &sections_[found->second];
}

Section* Document::find(std::string_view name) {
  const auto found = by_name_.find(lower_case(name));
  return found == by_name_.end() ? nullptr : &sections_[found->second];
}

std::string_view Document::value(std::string_view name, std::string_view key) const {
  const Section* const section = find(name);
  return section == nullptr ? std::string_view{} : section->value(key);
}

Section& Document::section(std::string_view name) {
  if (Section* const known = find(name)) return *known;
  Section& last = sections_.back();
  last.end_with(ending_);
  const bool first = sections_.size() == 1 && last.lines().empty();
  const bool separated = !last.lines().empty() && last.lines().back().kind() == LineKind::Blank;
  if (!first && !separated) last.append(Line{"", ending_, 0});
  return append(Line{fmt::format("[{}]", name), ending_, 0});
}

std::string Document::write() const {
  std::string text{mark_};
  const auto add = [&text](const Line& line) { (text += line.text()) += line.ending(); };
  for (const Section& section : sections_) {
    add(section.header());
    std::ranges::for_each(section.lines(), add);
  }
  return text;
}

}  // namespace eds
