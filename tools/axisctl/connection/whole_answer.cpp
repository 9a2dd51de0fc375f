#include "tools/axisctl/connection/whole_answer.hpp"

#include <algorithm>
#include <utility>

#include "control/methods.hpp"

namespace axisctl {
namespace {

using nlohmann::json;

/// Puts what the lists of @p page hold behind those of @p result.
void append(json& result, const json& page) {
  for (const auto& item : page.items()) {
    json& own = result[item.key()];
    if (!own.is_array() || !item.value().is_array()) continue;
    for (const json& element : item.value()) own.push_back(element);
  }
}

/// Whether the result of @p name comes in pages that begin where `from` says.
bool has_pages(std::string_view name) {
  const control::Method* const method = control::find_method(name);
  return method != nullptr && std::ranges::count(method->parameters, "from", &control::Parameter::key) == 1;
}

}  // namespace

Expected<json> ask_whole(const Ask& ask, std::string_view method, json params) {
  auto result = ask(method, params);
  const bool wants_all = has_pages(method) && !params.contains("from") && !params.contains("count");
  if (!wants_all || !result || !result->is_object()) return result;
  for (json next = result->value("next", json{}); next.is_number_unsigned();) {
    params["from"] = next;
    auto page = ask(method, params);
    if (!page) return page;
    append(*result, *page);
    const json before = std::move(next);
    next = page->value("next", json{});
    if (next.is_number_unsigned() && next <= before) break;
  }
  result->erase("next");
  return result;
}

}  // namespace axisctl
