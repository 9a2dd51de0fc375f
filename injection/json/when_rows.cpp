#include "injection/json/when_rows.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "injection/json/choice.hpp"
#include "text/number.hpp"

namespace injection {
namespace {

using nlohmann::json;

constexpr std::uint64_t kMostCount = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint64_t kMostSeed = (std::uint64_t{1} << 53) - 1;  ///< what a double of other languages holds
constexpr std::uint64_t kLongest = 3'600'000;                      ///< ms

std::optional<std::uint32_t> count_in(const json& value, std::uint64_t low) {
  const auto number = whole_number(value);
  const bool is_right = number && *number >= low && *number <= kMostCount;
  return is_right ? std::optional{static_cast<std::uint32_t>(*number)} : std::nullopt;
}

bool read_event(const json& value, When& when) {
  when.event = value.is_string() ? parse_event(value.get<std::string>()) : std::nullopt;
  return when.event.has_value();
}
json write_event(const When& when) {
  return when.event ? json(text_of(*when.event)) : json{};
}

bool read_after(const json& value, When& when) {
  const auto count = count_in(value, 0);
  when.after = count.value_or(0);
  return count.has_value();
}
json write_after(const When& when) {
  return when.after != 0 ? json(when.after) : json{};
}

bool read_every(const json& value, When& when) {
  const auto count = count_in(value, 1);
  when.every = count.value_or(1);
  return count.has_value();
}
json write_every(const When& when) {
  return when.every != 1 ? json(when.every) : json{};
}

bool read_times(const json& value, When& when) {
  when.times = count_in(value, 1);
  return when.times.has_value();
}
json write_times(const When& when) {
  return when.times ? json(*when.times) : json{};
}

bool read_probability(const json& value, When& when) {
  when.probability = value.is_number()   ? std::optional{value.get<double>()}
                     : value.is_string() ? text::real(value.get<std::string>())
                                         : std::nullopt;
  return when.probability && *when.probability >= 0.0 && *when.probability <= 1.0;
}
json write_probability(const When& when) {
  return when.probability ? json(*when.probability) : json{};
}

bool read_seed(const json& value, When& when) {
  const auto seed = whole_number(value);
  when.seed = seed.value_or(0);
  return seed && *seed <= kMostSeed;
}
json write_seed(const When& when) {
  return when.seed != 0 ? json(when.seed) : json{};
}

bool read_during(const json& value, When& when) {
  if (!value.is_string()) return false;
  const auto* const name = std::ranges::find(kStateNames, value.get<std::string>());
  if (name == kStateNames.end()) return false;
  when.during = static_cast<State>(name - kStateNames.begin());
  return true;
}
json write_during(const When& when) {
  return when.during ? json(kStateNames[static_cast<std::size_t>(*when.during)]) : json{};
}

bool read_until(const json& value, When& when) {
  when.until = value.is_string() ? parse_milestone(value.get<std::string>()) : std::nullopt;
  return when.until.has_value();
}
json write_until(const When& when) {
  return when.until ? json(text_of(*when.until)) : json{};
}

bool read_lasting(const json& value, When& when) {
  const auto time = whole_number(value);
  if (!time || *time == 0 || *time > kLongest) return false;
  when.lasting = std::chrono::milliseconds{*time};
  return true;
}
json write_lasting(const When& when) {
  using std::chrono::milliseconds;
  return when.lasting ? json(std::chrono::duration_cast<milliseconds>(*when.lasting).count()) : json{};
}

std::string count_rule() {
  return fmt::format("a whole number from 0 to {}", kMostCount);
}
std::string positive_rule() {
  return fmt::format("a whole number from 1 to {}", kMostCount);
}
std::string probability_rule() {
  return "a number from 0 to 1";
}
std::string seed_rule() {
  return fmt::format("a whole number from 0 to {}", kMostSeed);
}
std::string state_rule() {
  return choice_of(kStateNames);
}
std::string milestone_rule() {
  return fmt::format("a count from 1 and an event (\"10 heartbeat\"), {}", event_rule());
}
std::string time_rule() {
  return fmt::format("a whole number from 1 to {}", kLongest);
}

constexpr std::array kRows{
    WhenRow{"event", "what `after` counts, and what triggers a fault that is no frame's", &event_rule, &read_event,
            &write_event},
    WhenRow{"after", "so many events pass first; without `event`: opportunities of the fault itself", &count_rule,
            &read_after, &write_after},
    WhenRow{"every", "of the opportunities every so many'th is hit", &positive_rule, &read_every, &write_every},
    WhenRow{"times", "so many hits, then it is over", &positive_rule, &read_times, &write_times},
    WhenRow{"probability", "of a hit, drawn at each opportunity", &probability_rule, &read_probability,
            &write_probability},
    WhenRow{"seed", "of these draws: the same seed hits the same opportunities", &seed_rule, &read_seed,
            &write_seed},
    WhenRow{"while", "no opportunity in another state, of the node or of the axis", &state_rule, &read_during,
            &write_during},
    WhenRow{"until", "over after so many events that it has not hit", &milestone_rule, &read_until, &write_until},
    WhenRow{"for_ms", "over so long after it has become active, in ms", &time_rule, &read_lasting, &write_lasting},
};

}  // namespace

std::span<const WhenRow> when_rows() noexcept {
  return kRows;
}

std::optional<std::uint64_t> whole_number(const json& value, bool hexadecimal) {
  if (value.is_number_integer() && value >= 0) return value.get<std::uint64_t>();
  if (!value.is_string()) return std::nullopt;
  constexpr int kDecimal = 10;
  constexpr int kHexadecimal = 16;
  const auto& digits = value.get_ref<const std::string&>();
  if (digits.starts_with("0x") || digits.starts_with("0X"))
    return text::integer<std::uint64_t>(std::string_view{digits}.substr(2), kHexadecimal);
  return text::integer<std::uint64_t>(digits, hexadecimal ? kHexadecimal : kDecimal);
}

}  // namespace injection
