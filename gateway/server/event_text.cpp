#include "gateway/server/event_text.hpp"

namespace gateway {
namespace {

constexpr int kRetry = 2000;  // ms

}  // namespace

EventText event_text(std::string_view name, std::string_view data, std::uint64_t id) {
  std::string text;
  if (id != 0) text.append("id: ").append(std::to_string(id)).append("\n");
  text.append("event: ").append(name).append("\ndata: ").append(data).append("\n\n");
  return std::make_shared<const std::string>(std::move(text));
}

EventText stream_start() {
  return std::make_shared<const std::string>("retry: " + std::to_string(kRetry) + "\n\n");
}

EventText heartbeat() {
  static const EventText text = std::make_shared<const std::string>(": alive\n\n");
  return text;
}

}  // namespace gateway
