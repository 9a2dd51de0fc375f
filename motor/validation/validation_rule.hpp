#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <string_view>

#include "motor/validation/validation.hpp"

/// What the tables of motor/validation.hpp are made of.
namespace motor::validation {

/// A member and what it has to be.
template <class Data>
struct Rule {
  std::string_view member;
  bool (*holds)(const Data&) noexcept;
  std::string_view expected;
};

inline constexpr std::string_view kPositiveText = "a number above 0";
inline constexpr std::string_view kNotNegativeText = "a number not below 0";
inline constexpr std::string_view kNumberText = "a finite number";

inline constexpr double kSmallest = 1e-12;   // that counts as above 0, so that its reciprocal is harmless
inline constexpr double kFastestRate = 1e5;  // 1/s, of what the models integrate with sub-steps

inline bool positive(double value) noexcept {
  return std::isfinite(value) && value >= kSmallest;
}
inline bool not_negative(double value) noexcept {
  return std::isfinite(value) && value >= 0.0;
}
/// Written so that NaN is outside.
inline bool within(double value, double low, double high) noexcept {
  return value >= low && value <= high;
}

template <auto member>
constexpr auto kPositive = []<class Data>(const Data& data) noexcept { return positive(data.*member); };
template <auto member>
constexpr auto kNotNegative = []<class Data>(const Data& data) noexcept { return not_negative(data.*member); };
template <auto member>
constexpr auto kFinite = []<class Data>(const Data& data) noexcept { return std::isfinite(data.*member); };
/// The same for a member of a struct inside.
template <auto part, auto member>
constexpr auto kPositivePart = []<class Data>(const Data& data) noexcept { return positive(data.*part.*member); };
template <auto part, auto member>
constexpr auto kNotNegativePart =
    []<class Data>(const Data& data) noexcept { return not_negative(data.*part.*member); };

template <class Data>
std::optional<Impossible> first_broken(std::span<const Rule<Data>> rules, const Data& data) noexcept {
  for (const Rule<Data>& rule : rules)
    if (!rule.holds(data)) return Impossible{rule.member, rule.expected};
  return std::nullopt;
}

}  // namespace motor::validation
