#include "gateway/openapi/poll_schemas.hpp"

#include <cstdint>
#include <utility>

#include "control/methods.hpp"

namespace gateway {
namespace {

using nlohmann::json;

json bounds_of(const control::Parameter& row) {
  return {{"minimum", static_cast<std::int64_t>(row.range.low)},
          {"maximum", static_cast<std::int64_t>(row.range.high)}};
}

json list_of_texts(const control::Parameter& row) {
  json items{{"type", "string"}};
  if (row.key == "kinds") items = {{"enum", control::kEventKind}};
  json schema{{"type", "array"}, {"items", std::move(items)}};
  if (row.range.high > 0) schema["maxItems"] = static_cast<std::int64_t>(row.range.high);
  return schema;
}

json without_description(const control::Parameter& row) {
  if (row.form == control::Form::List) return list_of_texts(row);
  if (row.form == control::Form::Switch) return {{"type", "boolean"}};
  json schema{{"type", row.form == control::Form::Integer ? "integer" : "string"}};
  if (row.form == control::Form::Integer) schema.update(bounds_of(row));
  return schema;
}

OrderedJson count(const char* meaning) {
  return {{"type", "integer"}, {"minimum", 0}, {"description", meaning}};
}

OrderedJson list(OrderedJson items, const char* meaning) {
  return {{"type", "array"}, {"items", std::move(items)}, {"description", meaning}};
}

OrderedJson flag(const char* meaning) {
  return {{"type", "boolean"}, {"description", meaning}};
}

/// An object that has all of @p properties.
OrderedJson object_of(OrderedJson properties) {
  OrderedJson required = OrderedJson::array();
  for (const auto& [key, schema] : properties.items()) required.push_back(key);
  return {{"type", "object"}, {"properties", std::move(properties)}, {"required", std::move(required)}};
}

}  // namespace

json own_schema(const control::Parameter& row) {
  json schema = without_description(row);
  schema["description"] = row.help;
  return schema;
}

OrderedJson live_schema(OrderedJson samples, OrderedJson frames) {
  return object_of(
      {{"cursor", {{"type", "string"}, {"description", "for `after` of the next request"}}},
       {"samples", list(std::move(samples), "what has come since, oldest first; empty if it was not asked for")},
       {"frames", list(std::move(frames), "the same")},
       {"lost", count("items that have come since and are no longer kept")},
       {"restarted", flag("`after` is none of these subscriptions: what is wanted begins now")}});
}

OrderedJson recent_schema(OrderedJson event) {
  event["properties"]["id"] = count("its number, that of the stream of events");
  event["required"].push_back("id");
  return object_of({{"last", count("for `after` of the next request")},
                    {"events", list(std::move(event), "oldest first")},
                    {"lost", count("events of any unit and kind that have come since and are no longer kept")},
                    {"restarted", flag("what has come since `after` is not known: all that are kept are told")},
                    {"units", list({{"type", "string"}}, "the units that there are now")}});
}

}  // namespace gateway
