#include <exception>
#include <fstream>
#include <iostream>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/scdoc_text.hpp"

namespace {

using Json = nlohmann::ordered_json;

/// "one of servo, vector", "number", "list"; empty where the schema does not say.
std::string type_of(const Json& node) {
  if (node.contains("enum")) {
    std::string choices;
    for (const Json& choice : node["enum"]) choices += (choices.empty() ? "" : ", ") + choice.get<std::string>();
    return "one of " + choices;
  }
  const Json types = node.value("type", Json(""));
  if (types.is_array()) {
    std::string all;
    for (const Json& each : types) all += (all.empty() ? "" : " or ") + each.get<std::string>();
    return all;
  }
  const auto type = types.get<std::string>();
  if (type == "boolean") return "true or false";
  if (type == "array")
    return node.contains("maxItems") ? fmt::format("list of up to {}", node["maxItems"].dump()) : "list";
  return type;
}

std::string range_of(const Json& node) {
  const auto bound = [&](const char* key) { return node.contains(key) ? node[key].dump() : std::string{}; };
  if (const std::string above = bound("exclusiveMinimum"); !above.empty()) return ", above " + above;
  const std::string least = bound("minimum");
  const std::string most = bound("maximum");
  if (!least.empty() && !most.empty()) return fmt::format(", {} to {}", least, most);
  if (!least.empty()) return ", from " + least;
  return most.empty() ? "" : ", up to " + most;
}

/// The keys of the schema as definitions, in its order.
class Keys {
 public:
  explicit Keys(const Json& root) : root_{root} {}

  /// Every key below @p node, whose own path is @p path ("axes[].").
  void write(const std::string& path, const Json& node) {
    for (const char* const alternatives : {"oneOf", "anyOf"})
      if (node.contains(alternatives))
        for (const Json& alternative : node[alternatives]) write(path, resolved(alternative));
    if (!node.contains("properties")) return;
    for (const auto& [name, property] : node["properties"].items()) write_key(path, path + name, property);
  }

 private:
  /// What @p node refers to, with what stands beside the reference laid over it.
  [[nodiscard]] Json resolved(const Json& node) const {
    if (!node.contains("$ref")) return node;
    Json target = resolved(root_.at(Json::json_pointer{node["$ref"].get<std::string>().substr(1)}));
    for (const auto& [name, value] : node.items())
      if (name != "$ref") target[name] = value;
    return target;
  }

  void write_key(const std::string& above, const std::string& path, const Json& property) {
    const Json node = resolved(property);
    std::string facts = type_of(node) + range_of(node);
    if (node.contains("default")) facts += (facts.empty() ? "default " : "; default ") + node["default"].dump();
    const std::string description = node.value("description", "");
    std::string text = description.empty() ? facts : description;
    if (!description.empty() && !facts.empty()) text += fmt::format(" ({})", facts);
    std::cout << fmt::format("*{}*\n\t{}\n\n", cli::scdoc_text(path),
                             cli::scdoc_text(text.empty() ? "object" : text));
    // An entry of the list has the keys of a unit, which stand there.
    const bool is_of_unit = above == "units[]." && property.contains("$ref");
    if (is_of_unit) return;
    write(path + '.', node);
    if (node.contains("items")) write(path + "[].", resolved(node["items"]));
  }

  const Json& root_;
};

}  // namespace

/// write_configuration_keys SCHEMA: prints every key of the configuration in the language of scdoc.
int main(int count, char** words) try {
  if (count != 2) return 2;
  std::ifstream file{words[1]};
  const Json root = Json::parse(file);
  Keys keys{root};
  std::cout << "# KEYS OF A UNIT\n\n";
  keys.write("", root.at("$defs").at("unit"));
  std::cout << "# KEYS OF MANY UNITS\n\n";
  keys.write("", root.at("$defs").at("list"));
  return 0;
} catch (const std::exception& error) {
  std::cerr << "write_configuration_keys: " << error.what() << '\n';
  return 1;
}
