#pragma once

#include <list>
#include <memory>
#include <string_view>

#include "gateway/server/event_stream.hpp"
#include "gateway/streams/event_filter.hpp"

namespace gateway {

/// The viewers of a stream, each with what it wants.
class Viewers {
 public:
  /// A stream for a new viewer. It stays until remove().
  std::shared_ptr<EventStream> add(EventFilter filter = {});
  void remove(const EventStream& stream);
  /// Lets @p text follow in all streams.
  void tell(const EventText& text);
  /// The same in those that want an event of @p unit and @p kind.
  void tell(const EventText& text, std::string_view unit, std::string_view kind);
  /// Ends all streams, behind @p text.
  void end(const EventText& text);
  [[nodiscard]] bool is_empty() const noexcept { return all_.empty(); }
  [[nodiscard]] std::size_t size() const noexcept { return all_.size(); }

 private:
  struct Viewer {
    std::shared_ptr<EventStream> stream;
    EventFilter filter;
  };

  std::list<Viewer> all_;
};

}  // namespace gateway
