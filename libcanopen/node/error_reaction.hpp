#pragma once

#include "libcanopen/node/standard_services.hpp"
#include "libcanopen/service/error_reports.hpp"

namespace canopen {

/// What follows from an error: EMCY, the error register and history, the application, and the NMT state (1029h).
class ErrorReaction final : public ErrorReports {
 public:
  ErrorReaction(Context& context, StandardServices& services) noexcept : context_{context}, services_{services} {}

  /// See Node::raise_error() and Node::clear_error().
  void raise(std::uint16_t code, std::uint16_t detail, std::uint8_t error_register) noexcept;
  void clear(std::uint16_t code, std::uint16_t detail) noexcept;
  /// See Node::apply_error_behaviour().
  void apply_behaviour(std::uint8_t error_class) noexcept;

  void on_error(CommunicationError error, std::uint16_t detail) noexcept override;
  void on_recovery(CommunicationError error, std::uint16_t detail) noexcept override;

 private:
  Context& context_;
  StandardServices& services_;
};

}  // namespace canopen
