#include <array>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

#include "eds/document/finding_filter.hpp"
#include "eds/transform/comparison.hpp"
#include "eds/transform/object_tree.hpp"
#include "tools/edstool/command.hpp"

namespace edstool {
namespace {

using nlohmann::json;

template <class T>
json text_of(const eds::Stated<T>& stated) {
  return stated.stated() ? json(eds::printable(stated.text())) : json(nullptr);
}

json to_json(const eds::SheetEntry& entry) {
  json result{{"sub_index", entry.sub_index},
              {"name", eds::printable(entry.name)},
              {"type", entry.type != nullptr ? json(entry.type->name) : text_of(entry.data_type)},
              {"access", eds::name_of(eds::kAccesses, entry.access_or_default()).text},
              {"pdo", entry.mappable.value_or(false)},
              {"default", text_of(entry.default_value)},
              {"low", text_of(entry.low)},
              {"high", text_of(entry.high)}};
  if (entry.parameter_value.stated()) result["value"] = text_of(entry.parameter_value);
  return result;
}

json to_json(const eds::SheetObjects& objects) {
  json list = json::array();
  for (const auto& [index, object] : objects) {
    json entries = json::array();
    for (const eds::SheetEntry& entry : object.entries) entries.push_back(to_json(entry));
    list.push_back({{"index", index},
                    {"name", eds::printable(object.name)},
                    {"object_type", eds::word_of(object.code())},
                    {"entries", std::move(entries)}});
  }
  return list;
}

json to_json(const eds::DataSheet& sheet) {
  json modules = json::array();
  for (const auto& [number, module] : sheet.modules)
    modules.push_back({{"number", number}, {"objects", to_json(module.objects)}});
  const eds::DeviceInfo& info = sheet.device_info;
  return {{"device",
           {{"vendor", text_of(info.vendor_name)},
            {"product", text_of(info.product_name)},
            {"vendor_number", info.vendor_number.value_or(0)},
            {"product_number", info.product_number.value_or(0)},
            {"revision_number", info.revision_number.value_or(0)}}},
          {"objects", to_json(sheet.objects)},
          {"modules", std::move(modules)}};
}

/// What could not be read of a file that is shown or compared, to standard error.
void complain(const InputFile& file) {
  for (const eds::FindingGroup& group : eds::group_warnings(file.findings.all()))
    std::cerr << eds::to_text(group) << '\n';
}

int show(const std::string& path, bool as_json) {
  const InputFile file{path};
  if (as_json) {
    std::cout << to_json(file.sheet).dump() << '\n';
  } else {
    std::cout << eds::write_tree(file.sheet);
  }
  complain(file);
  return kClean;
}

int diff(const std::string& first_path, const std::string& second_path, bool as_json) {
  const InputFile first{first_path}, second{second_path};
  const std::vector<eds::Difference> differences = eds::compare(first.sheet, second.sheet);
  json list = json::array();
  for (const eds::Difference& difference : differences) {
    const auto side = [](const std::optional<std::string>& text) {
      return text ? json(eds::printable(*text)) : json(nullptr);
    };
    if (as_json) {
      list.push_back({{"where", difference.where},
                      {"what", difference.what},
                      {"first", side(difference.first)},
                      {"second", side(difference.second)}});
    } else {
      std::cout << eds::to_text(difference) << '\n';
    }
  }
  if (as_json) std::cout << list.dump() << '\n';
  complain(first);
  if (first_path != second_path) complain(second);
  return differences.empty() ? kClean : kFound;
}

}  // namespace

void add_show(CLI::App& app, Invocation& invocation) {
  CLI::App* const command = app.add_subcommand("show", "Print the device and its objects");
  const auto file = std::make_shared<std::string>();
  command->add_option("file", *file, "EDS or DCF file")->required()->type_name("FILE");
  command->callback(
      [&invocation, file] { invocation.run = [&invocation, file] { return show(*file, invocation.json); }; });
}

void add_diff(CLI::App& app, Invocation& invocation) {
  CLI::App* const command = app.add_subcommand("diff", "Compare two files object by object");
  const auto files = std::make_shared<std::array<std::string, 2>>();
  command->add_option("first", (*files)[0], "EDS or DCF file")->required()->type_name("FILE");
  command->add_option("second", (*files)[1], "EDS or DCF file")->required()->type_name("FILE");
  command->callback([&invocation, files] {
    invocation.run = [&invocation, files] { return diff((*files)[0], (*files)[1], invocation.json); };
  });
}

}  // namespace edstool
