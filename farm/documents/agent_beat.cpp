#include "farm/documents/agent_beat.hpp"

#include <limits>

#include "farm/documents/field_reader.hpp"
#include "farm/documents/numbers.hpp"

namespace farm {

tl::expected<AgentBeat, std::string> parse_agent_beat(std::string_view subject, std::string_view text) {
  FieldReader fields{subject, text};
  AgentBeat beat;
  beat.host = fields.name("host");
  if (beat.host.empty()) fields.fail("host", "a name", nullptr);
  beat.instance = fields.number("instance", 1, kGreatestNumber);
  beat.version = fields.text("version");
  beat.since = fields.text("since");
  beat.buses = fields.names("buses");
  beat.capacity = static_cast<std::uint32_t>(fields.number("capacity", 1, kGreatestCapacity));
  beat.units = static_cast<std::uint32_t>(fields.number("units", 0, std::numeric_limits<std::uint32_t>::max(), 0));
  beat.draining = fields.flag("draining", false);
  beat.sent_ms = fields.number("sent_ms", 0, kGreatestNumber, 0);
  return fields.result(std::move(beat));
}

std::string text_of(const AgentBeat& beat) {
  nlohmann::json document{{"host", beat.host},         {"instance", beat.instance}, {"version", beat.version},
                          {"capacity", beat.capacity}, {"units", beat.units},       {"draining", beat.draining},
                          {"sent_ms", beat.sent_ms}};
  if (!beat.since.empty()) document["since"] = beat.since;
  if (!beat.buses.empty()) document["buses"] = beat.buses;
  return document.dump();
}

}  // namespace farm
