#pragma once

#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

namespace bench {

/// One thing to be measured, already set up, with its effect checked.
class Operation {
 public:
  virtual ~Operation() = default;
  /// Does it @p times times.
  virtual void run(std::size_t times) = 0;
};

/// An operation by its name. `make` sets it up, does it once and throws std::runtime_error if the effect is wrong.
struct OperationRow {
  std::string_view name;  ///< group/what
  std::string_view text;  ///< one line on what is counted
  std::unique_ptr<Operation> (*make)();
};

/// An operation whose single step is `Work::step()`; the constructor of Work sets up and checks.
template <class Work>
class Repeated final : public Operation {
 public:
  void run(std::size_t times) override {
    for (std::size_t i = 0; i < times; ++i) work_.step();
  }

 private:
  Work work_;
};

/// The `make` of a row for @p Work.
template <class Work>
std::unique_ptr<Operation> make() {
  return std::make_unique<Repeated<Work>>();
}

/// The operations of the library, of the physics, of one axis of the whole unit, of a CiA 402 device, of the hub
/// of a user-space bus and of the bus over several hosts.
std::vector<OperationRow> library_operations();
std::vector<OperationRow> library_pdo_operations();
std::vector<OperationRow> plant_operations();
std::vector<OperationRow> drive_train_operations();
std::vector<OperationRow> axis_operations();
std::vector<OperationRow> positioning_operations();
std::vector<OperationRow> device_operations();
std::vector<OperationRow> cia402_operations();
std::vector<OperationRow> hub_operations();
std::vector<OperationRow> trunk_operations();

/// All operations in the order of the printed table.
std::vector<OperationRow> operations();

}  // namespace bench
