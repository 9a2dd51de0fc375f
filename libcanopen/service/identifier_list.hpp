#pragma once

#include <cstddef>
#include <cstdint>

#include "libcanopen/base/cob_id.hpp"
#include "libcanopen/base/export.hpp"

namespace canopen {

class Routes;

/// Where a service names the identifiers that it works with. 0 names none, so that what is not configured need not
/// be told apart.
class CANOPEN_EXPORT IdentifierList {
 public:
  /// Those of the service at @p place of a ServiceList go to @p routes.
  IdentifierList(Routes& routes, std::uint8_t place) noexcept : routes_{routes}, place_{place} {}

  /// Data frames of @p identifier go to Service::on_frame() with @p slot.
  void hears(Identifier identifier, std::size_t slot = 0) noexcept;
  /// The data frames of identifier 0, which is NMT's own, go to Service::on_frame().
  void hears_nmt() noexcept;
  /// Remote frames of @p identifier go to Service::on_request() with @p slot.
  void answers(Identifier identifier, std::size_t slot = 0) noexcept;
  /// The service sends @p identifier.
  void sends(Identifier identifier) noexcept;

 private:
  Routes& routes_;
  std::uint8_t place_;
};

}  // namespace canopen
