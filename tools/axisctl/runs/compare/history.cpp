#include "tools/axisctl/runs/compare/history.hpp"

#include <algorithm>

#include "meaning/words.hpp"

namespace runs {
namespace {

struct ServiceRow {
  std::string_view what;
  bool (*contains)(meaning::Role role);
};
constexpr std::array<ServiceRow, 4> kServiceRows{
    ServiceRow{"SDO request", [](meaning::Role role) { return role == meaning::Role::SdoRequest; }},
    ServiceRow{"NMT", [](meaning::Role role) { return role == meaning::Role::Nmt; }},
    ServiceRow{"SYNC", [](meaning::Role role) { return role == meaning::Role::Sync; }},
    ServiceRow{"PDO",
               [](meaning::Role role) { return role == meaning::Role::Rpdo || role == meaning::Role::Tpdo; }},
};

std::uint32_t key_of(const LoggedFrame& logged) noexcept {
  return canopen::identifier_of(logged.frame) | (logged.is_error ? 1U << 31U : 0U);
}

}  // namespace

History::History(const eds::Description& description, std::size_t surroundings)
    : description_{description}, most_{surroundings}, ids_{description} {}

void History::take(const FramePair& pair) {
  const LoggedFrame& logged = *pair.a;
  last_.push_back(pair);
  if (last_.size() > most_) last_.pop_front();
  const std::uint32_t key = key_of(logged);
  if (const auto known = by_identifier_.find(key); known != by_identifier_.end())
    known->second = logged;
  else if (by_identifier_.size() < kMostIdentifiers)
    by_identifier_.emplace(key, logged);
  if (logged.is_error) return;
  const meaning::Meaning meaning = ids_.meaning_of(logged.frame);
  ids_.follow(logged.frame, meaning);
  for (std::size_t i = 0; i < kServiceRows.size(); ++i)
    if (kServiceRows[i].contains(meaning.role)) services_[i] = logged;
  if (meaning.role == meaning::Role::SdoRequest) requests_[meaning.node] = logged;
}

std::string History::words_of(const std::optional<LoggedFrame>& logged) const {
  if (!logged) return "";
  if (logged->is_error) return "error frame";
  return meaning::words_of(logged->frame, ids_.meaning_of(logged->frame), description_);
}

void History::add_former(std::vector<Former>& formers, std::string_view what, const LoggedFrame& frame) const {
  formers.push_back({std::string{what}, frame, words_of(frame)});
}

std::vector<Former> History::formers(const std::optional<LoggedFrame>& a,
                                     const std::optional<LoggedFrame>& b) const {
  std::vector<Former> formers;
  for (const auto* const one : {&a, &b}) {
    if (!*one || (one == &b && a && key_of(*a) == key_of(*b))) continue;
    const auto known = by_identifier_.find(key_of(**one));
    if (known != by_identifier_.end()) add_former(formers, "same identifier", known->second);
  }
  for (std::size_t i = 0; i < kServiceRows.size(); ++i) {
    const std::optional<LoggedFrame>* last = &services_[i];
    // The request that an answer belongs to, if it is one.
    const auto& one = a ? a : b;
    if (const meaning::Meaning meaning = one ? ids_.meaning_of(one->frame) : meaning::Meaning{};
        kServiceRows[i].contains(meaning::Role::SdoRequest) && meaning.role == meaning::Role::SdoResponse &&
        requests_[meaning.node])
      last = &requests_[meaning.node];
    if (*last) add_former(formers, kServiceRows[i].what, **last);
  }
  return formers;
}

}  // namespace runs
