#include "farm/documents/place.hpp"

#include "farm/documents/field_reader.hpp"
#include "farm/documents/numbers.hpp"

namespace farm {

tl::expected<Place, std::string> parse_place(std::string_view key, std::string_view text) {
  FieldReader fields{key, text};
  Place place;
  place.host = fields.name("host");
  place.instance = fields.number("instance", 0, kGreatestNumber, 0);
  place.term = fields.number("term", 0, kGreatestNumber, 0);
  place.restarts = fields.number("restarts", 0, kGreatestNumber, 0);
  place.problem = fields.text("problem");
  return fields.result(std::move(place));
}

std::string text_of(const Place& place) {
  nlohmann::json document{{"term", place.term}};
  if (!place.host.empty()) {
    document["host"] = place.host;
    document["instance"] = place.instance;
  }
  if (place.restarts != 0) document["restarts"] = place.restarts;
  if (!place.problem.empty()) document["problem"] = place.problem;
  return document.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace farm
