#include "gateway/streams/viewers.hpp"

#include <utility>

namespace gateway {
std::shared_ptr<EventStream> Viewers::add(EventFilter filter) {
  auto stream = std::make_shared<EventStream>();
  stream->push(stream_start());
  all_.push_back({stream, std::move(filter)});
  return stream;
}

void Viewers::remove(const EventStream& stream) {
  all_.remove_if([&stream](const Viewer& viewer) { return viewer.stream.get() == &stream; });
}

void Viewers::tell(const EventText& text) {
  for (const Viewer& viewer : all_) viewer.stream->push(text);
}

void Viewers::tell(const EventText& text, std::string_view unit, std::string_view kind) {
  for (const Viewer& viewer : all_)
    if (viewer.filter.takes(unit, kind)) viewer.stream->push(text);
}

void Viewers::end(const EventText& text) {
  for (const Viewer& viewer : all_) {
    viewer.stream->push(text);
    viewer.stream->end();
  }
}

}  // namespace gateway
