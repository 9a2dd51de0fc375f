#include "farm/agent/plan/placement.hpp"

#include <algorithm>

namespace farm::agent {
namespace {

using canopen::TimePoint;

/// FNV-1a: the same on every host.
std::uint64_t hash_of(std::string_view text, std::uint64_t hash = 0xCBF29CE484222325) noexcept {
  constexpr std::uint64_t kPrime = 0x100000001B3;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * kPrime;
  return hash;
}

/// Whether @p one has more free capacity, relative to what it has, than @p other; @p unit decides if it is the
/// same.
bool is_better(const Candidate& one, const Candidate& other, const UnitName& unit) {
  const auto free = [](const Candidate& candidate) {
    return std::int64_t{candidate.capacity} - std::int64_t{candidate.load};
  };
  const std::int64_t left = free(one) * other.capacity;
  const std::int64_t right = free(other) * one.capacity;
  if (left != right) return left > right;
  const std::uint64_t of_unit = hash_of(unit.key());
  return hash_of(one.host, of_unit) > hash_of(other.host, of_unit);
}

/// The best of @p candidates among the @p hosts but those of @p passed.
Candidate* best_of(std::vector<Candidate>& candidates, const OpenUnit& unit, const std::set<std::string>& passed) {
  Candidate* best = nullptr;
  for (Candidate& candidate : candidates) {
    if (!unit.hosts.contains(candidate.host) || passed.contains(candidate.host)) continue;
    if (best == nullptr || is_better(candidate, *best, unit.name)) best = &candidate;
  }
  return best;
}

}  // namespace

void Placement::plan(std::vector<OpenUnit> open, std::vector<Candidate> candidates, TimePoint now) {
  std::map<UnitName, Turn> turns;
  std::vector<OpenUnit> undecided;
  for (OpenUnit& unit : open) {
    const auto known = turns_.find(unit.name);
    Turn turn = known == turns_.end() ? Turn{} : std::move(known->second);
    const auto host = std::ranges::find(candidates, turn.host, &Candidate::host);
    const bool stands = host != candidates.end() && unit.hosts.contains(turn.host) && now < turn.until;
    if (stands) ++host->load;
    if (!stands && now >= turn.until && !turn.host.empty()) turn.passed.insert(turn.host);
    turns[unit.name] = std::move(turn);
    if (!stands) undecided.push_back(std::move(unit));
  }
  std::ranges::sort(undecided, {}, [](const OpenUnit& unit) { return std::pair{unit.order, unit.name}; });
  for (const OpenUnit& unit : undecided) {
    Turn& turn = turns[unit.name];
    Candidate* best = best_of(candidates, unit, turn.passed);
    if (best == nullptr) best = best_of(candidates, unit, turn.passed = {});
    turn.host = best == nullptr ? "" : best->host;
    turn.until = now + kTurn;
    if (best != nullptr) ++best->load;
  }
  turns_ = std::move(turns);
  next_turn_ = canopen::kNever;
  for (const auto& [unit, turn] : turns_)
    if (!turn.host.empty()) next_turn_ = std::min(next_turn_, turn.until);
}

const std::string& Placement::host_for(const UnitName& unit) const {
  static const std::string kNobody;
  const auto turn = turns_.find(unit);
  return turn == turns_.end() ? kNobody : turn->second.host;
}

}  // namespace farm::agent
