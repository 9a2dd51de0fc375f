#include <algorithm>
#include <iostream>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "farm/naming/subjects.hpp"
#include "json/strict.hpp"
#include "os/regular_file.hpp"
#include "tools/axisctl/fleet/check.hpp"
#include "tools/axisctl/fleet/fleet_commands.hpp"
#include "tools/axisctl/fleet/in_store.hpp"
#include "tools/axisctl/fleet/store.hpp"
#include "tools/axisctl/page/files.hpp"
#include "tools/axisctl/print/printable.hpp"
#include "tools/axisctl/print/table.hpp"

namespace fleet {
namespace {

using axisctl::ExitStatus;
using axisctl::Expected;
using axisctl::fail;
using axisctl::Settings;
using nlohmann::json;

constexpr std::size_t kLargestFile = std::size_t{4} << 20U;
constexpr const char* kSaved = "parameters.bin";

Expected<std::string> read_file(const std::string& path, std::size_t most) {
  auto text = os::read_regular_file(path, most);
  if (text) return *std::move(text);
  return fail(text.error().is_missing() ? ExitStatus::NotThere : ExitStatus::Failed,
              fmt::format("{}: cannot be read: {}", path, text.error().reason()));
}

Expected<void> check(const json& document, const std::string& path) {
  if (document.value("units", json::array()).empty()) return {};
  const auto checked = check_configuration(axisctl::program_folder(), configuration_of(document), path);
  if (!checked) return fail(ExitStatus::Usage, checked.error());
  if (*checked == Checked::NotAtAll)
    std::cerr << "axisctl: there is no axisd beside this program: " << axisctl::printable(path)
              << ": whether the configurations are right is not known\n";
  return {};
}

Expected<WantedFleet> read_wanted(const ApplyWish& wish) {
  WantedFleet wanted;
  for (const std::string& path : wish.files) {
    const auto text = read_file(path, kLargestFile);
    if (!text) return tl::unexpected{text.error()};
    const auto document = json_text::parse(*text);
    if (!document) return fail(ExitStatus::Usage, fmt::format("{}: {}", path, document.error()));
    if (const auto read = read_fleet_file(*document, path, wanted); !read)
      return fail(ExitStatus::Usage, read.error());
    if (wish.unchecked) continue;
    if (const auto checked = check(*document, path); !checked) return tl::unexpected{checked.error()};
  }
  return wanted;
}

using Effects = std::vector<std::pair<std::string, Effect>>;

json json_of(const Effects& effects, const char* what) {
  json list = json::array();
  for (const auto& [name, effect] : effects) list.push_back({{what, name}, {"effect", text_of(effect)}});
  return list;
}

Expected<void> show(const Applied& applied, const Settings& settings) {
  if (settings.json)
    return axisctl::print_line(
        json{{"units", json_of(applied.units, "unit")}, {"buses", json_of(applied.buses, "bus")}}.dump());
  axisctl::Table table{{"what", "effect"}};
  for (const auto& [name, effect] : applied.buses) table.add({"bus " + name, std::string{text_of(effect)}});
  for (const auto& [name, effect] : applied.units) table.add({name, std::string{text_of(effect)}});
  table.print(std::cout, !settings.style.brief);
  return {};
}

}  // namespace

Expected<farm::UnitName> unit_of(const std::string& word) {
  if (auto unit = farm::parse_unit_name(word)) return *std::move(unit);
  return fail(ExitStatus::Usage, fmt::format("UNIT: expected BUS/NODE, got \"{}\"", word));
}

Expected<void> expect_host(const std::string& word) {
  if (farm::is_name(word)) return {};
  return fail(ExitStatus::Usage,
              fmt::format("HOST: expected a name of 1 to 32 letters, digits, '-' and '_', got \"{}\"", word));
}

Expected<void> run_apply(const Settings& settings, const ApplyWish& wish) {
  const auto wanted = read_wanted(wish);
  if (!wanted) return tl::unexpected{wanted.error()};
  const auto applied = in_store<Applied>(
      settings,
      [&wanted, farm = settings.farm->farm()](farm::Storage& storage) { return apply(storage, farm, *wanted); });
  return applied.and_then([&settings](const Applied& done) { return show(done, settings); });
}

Expected<void> run_remove(const Settings& settings, const std::vector<std::string>& words) {
  std::vector<farm::UnitName> units;
  std::vector<std::string> buses;
  for (const std::string& word : words) {
    if (word.ends_with("/*") && farm::is_name(word.substr(0, word.size() - 2))) {
      buses.push_back(word.substr(0, word.size() - 2));
      continue;
    }
    const auto unit = unit_of(word);
    if (!unit) return tl::unexpected{unit.error()};
    units.push_back(*unit);
  }
  using Names = std::vector<std::string>;
  const auto removed = in_store<Names>(settings, [&, farm = settings.farm->farm()](farm::Storage& storage) {
    return remove(storage, farm, units, buses);
  });
  if (!removed) return tl::unexpected{removed.error()};
  if (settings.json) {
    if (auto printed = axisctl::print_line(json{{"removed", *removed}}.dump()); !printed) return printed;
  } else {
    for (const std::string& name : *removed) std::cout << name << " removed\n";
  }
  std::set<std::string> missing;
  for (const farm::UnitName& unit : units)
    if (std::ranges::find(*removed, unit.text()) == removed->end()) missing.insert(unit.text());
  for (const std::string& bus : buses)
    if (std::ranges::none_of(*removed, [&bus](const std::string& name) { return name.starts_with(bus + '/'); }))
      missing.insert(bus + "/*");
  if (missing.empty()) return {};
  return fail(ExitStatus::NotThere, fmt::format("{}: not wanted in this farm", fmt::join(missing, ", ")));
}

Expected<void> run_move(const Settings& settings, const std::string& word, const std::string& host) {
  const auto unit = unit_of(word);
  if (!unit) return tl::unexpected{unit.error()};
  if (auto checked = expect_host(host); !checked) return checked;
  const auto moved = in_store<bool>(settings, [&, farm = settings.farm->farm()](farm::Storage& storage) {
    return move(storage, farm, *unit, host);
  });
  if (!moved) return tl::unexpected{moved.error()};
  if (!*moved) return fail(ExitStatus::NotThere, fmt::format("{}: not wanted in this farm", word));
  if (settings.json) return axisctl::print_line("{}");
  return {};
}

Expected<void> run_drain(const Settings& settings, const std::string& host, bool drained) {
  if (auto checked = expect_host(host); !checked) return checked;
  const auto done = in_store<bool>(settings, [&, farm = settings.farm->farm()](farm::Storage& storage) {
    return drain(storage, farm, host, drained);
  });
  if (!done) return tl::unexpected{done.error()};
  if (settings.json) return axisctl::print_line("{}");
  return {};
}

Expected<void> run_export(const Settings& settings, const std::string& word, const std::string& file) {
  const auto unit = unit_of(word);
  if (!unit) return tl::unexpected{unit.error()};
  using Content = std::optional<std::string>;
  const auto content = in_store<Content>(settings, [&, farm = settings.farm->farm()](farm::Storage& storage) {
    return storage.objects.get(farm::state_bucket(farm), farm::state_object(*unit, kSaved));
  });
  if (!content) return tl::unexpected{content.error()};
  if (!*content)
    return fail(ExitStatus::NotThere, fmt::format("{}: the farm keeps nothing that it has saved", word));
  return axisctl::write_whole(file, **content);
}

Expected<void> run_import(const Settings& settings, const std::string& word, const std::string& file) {
  const auto unit = unit_of(word);
  if (!unit) return tl::unexpected{unit.error()};
  const auto content = read_file(file, farm::ObjectStore::kLongest);
  if (!content) return tl::unexpected{content.error()};
  const auto done = in_store<bool>(settings, [&, farm = settings.farm->farm()](farm::Storage& storage) {
    return storage.objects.put(farm::state_bucket(farm), farm::state_object(*unit, kSaved), *content).map([] {
      return true;
    });
  });
  if (!done) return tl::unexpected{done.error()};
  if (settings.json) return axisctl::print_line("{}");
  return {};
}

}  // namespace fleet
