#include "gateway/units/unit_list.hpp"

#include <utility>

namespace gateway {
namespace {

using nlohmann::json;

void take_page(DaemonClient& client, json before, Answer page, OnAnswer on_answer);

void ask_from(DaemonClient& client, json before, const json& from, OnAnswer on_answer) {
  client.ask("units", from.is_null() ? json::object() : json{{"from", from}},
             [&client, before = std::move(before), on_answer = std::move(on_answer)](Answer page) {
               take_page(client, before, std::move(page), on_answer);
             });
}

void take_page(DaemonClient& client, json before, Answer page, OnAnswer on_answer) {
  if (!page || !page->is_object() || !page->value("units", json{}).is_array()) return on_answer(std::move(page));
  for (const json& unit : (*page)["units"]) before.push_back(unit);
  const json next = page->value("next", json{});
  // A daemon that goes on where it has begun would be asked for ever.
  if (next.is_number_unsigned() && next == before.size())
    return ask_from(client, std::move(before), next, std::move(on_answer));
  page->erase("next");
  (*page)["units"] = std::move(before);
  on_answer(std::move(page));
}

}  // namespace

void ask_for_units(DaemonClient& client, OnAnswer on_answer) {
  ask_from(client, json::array(), json{}, std::move(on_answer));
}

}  // namespace gateway
