#include "tools/canopen-zoo/residents.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cli/suggestion.hpp"

namespace zoo {
namespace {

constexpr char kCapitals = 'a' - 'A';

/// @p name as it is compared: small letters and digits.
std::string folded(std::string_view name) {
  std::string text;
  for (const char each : name) {
    if (each == '-' || each == '_') continue;
    text += each >= 'A' && each <= 'Z' ? static_cast<char>(each + kCapitals) : each;
  }
  return text;
}

}  // namespace

std::vector<WrongSlave> residents() {
  std::vector<WrongSlave> all{
      {.name = std::string{kRight}, .what = "Nothing is wrong.", .defect = {}, .found_by = {}},
      {.name = "RightWithLss",
       .what = "Nothing is wrong; it has those services of LSS that need no reset.",
       .defect = right_lss(),
       .found_by = {}},
      {.name = "RightDrive",
       .what = "Nothing is wrong; it is a drive of CiA 402 that positions, turns and homes.",
       .defect = {.drive = DriveFlaws{}},
       .found_by = {}}};
  std::vector<WrongSlave> wrong = wrong_slaves();
  std::move(wrong.begin(), wrong.end(), std::back_inserter(all));
  return all;
}

tl::expected<WrongSlave, std::string> find_resident(std::string_view name) {
  std::vector<WrongSlave> all = residents();
  const std::string wanted = folded(name);
  const auto found = std::ranges::find(all, wanted, [](const WrongSlave& each) { return folded(each.name); });
  if (found != all.end()) return std::move(*found);
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const WrongSlave& each : all) names.push_back(folded(each.name));
  const std::string meant = wanted.empty() ? "" : cli::nearest(wanted, names);
  if (meant.empty()) return tl::unexpected{fmt::format("expected a name of --list, got \"{}\"", name)};
  const auto nearest = std::ranges::find(names, meant) - names.begin();
  return tl::unexpected{fmt::format("no slave is called \"{}\", did you mean {}?", name,
                                    all[static_cast<std::size_t>(nearest)].name)};
}

std::string eds_of(const WrongSlave& slave) {
  std::string text = eds_of(objects_of(slave.defect));
  slave.defect.eds(text);
  return text;
}

}  // namespace zoo
