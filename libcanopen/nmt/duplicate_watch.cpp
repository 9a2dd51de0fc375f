#include "libcanopen/nmt/duplicate_watch.hpp"

#include "libcanopen/service/identifier_list.hpp"

namespace canopen {

DuplicateWatch::DuplicateWatch(Context& context)
    : Service{context, {.lives_in = kStatesOfNmt, .identifiers = 2}} {}

void DuplicateWatch::list_identifiers(IdentifierList& list) const noexcept {
  for (const Identifier base : {function_code::kErrorControl, function_code::kSdoResponse})
    list.hears(base + context_.dictionary.node_id());
}

void DuplicateWatch::on_frame(const Frame& frame, std::size_t) noexcept {
  context_.application.on_foreign_frame(frame.id);
}

}  // namespace canopen
