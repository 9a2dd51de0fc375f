#include "libcanopen/service/identifier_list.hpp"

#include "libcanopen/service/routes.hpp"

namespace canopen {

void IdentifierList::hears(Identifier identifier, std::size_t slot) noexcept {
  if (identifier != 0) routes_.lead(identifier, place_, static_cast<std::uint16_t>(slot));
}

void IdentifierList::hears_nmt() noexcept {
  routes_.lead(function_code::kNmt, place_, 0);
}

void IdentifierList::answers(Identifier identifier, std::size_t slot) noexcept {
  if (identifier != 0) routes_.lead_remote(identifier, place_, static_cast<std::uint16_t>(slot));
}

void IdentifierList::sends(Identifier identifier) noexcept {
  if (identifier != 0) routes_.use(identifier);
}

}  // namespace canopen
