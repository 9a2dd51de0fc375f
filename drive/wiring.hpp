#pragma once

#include <cstddef>
#include <vector>

#include "drive/signal_source.hpp"

namespace drive {

/// The BICO interconnections of a unit, made ready for the cycle: the rows of the parameters say which inputs
/// there are and where what they bring lies. What is constant is settled once, what is not is a list of sources.
/// In a cycle come, in this order, for the control unit, the axes and the infeed:
/// 1. connector-binector converters (p8899 -> r8894, r8895), with what the bus has brought for this cycle;
/// 2. the inputs of each block, when its turn has come (take());
/// 3. when the statuswords are there, binector-connector converters (p8880 to p8884 -> r8889) and then the words
///    to be sent (p8851, p8861).
class Wiring {
 public:
  /// Of @p unit, which outlives this; to be made when all drive objects exist.
  explicit Wiring(DriveUnit& unit);

  /// Inputs or references have changed, or the inputs of a block hold something else than what they are connected
  /// to: everything is found anew before it is next used.
  void invalidate() noexcept { valid_ = false; }
  /// Finds all sources if need be.
  void connect() noexcept;

  /// Step 1 of the cycle.
  void convert_words() noexcept;
  /// Step 2: the inputs of block @p block of @p object take what they are connected to.
  void take(const DriveObject& object, BlockId block) noexcept;
  /// Whether a source has another value than an input of @p object that is connected to it.
  bool changed(const DriveObject& object) const noexcept;
  /// Step 3.
  void convert_bits() noexcept;
  void send() noexcept;

 private:
  /// An input that is a member of a block.
  template <class Value>
  struct Link {
    Value* input;
    SignalSource source;
    double full = 1.0;  ///< what is 100 % of the input, in SI units

    Value value() const noexcept;
  };
  /// The inputs of one block.
  struct Inputs {
    BlockId block;
    std::size_t count = 0;
    std::vector<Link<bool>> bits{};
    std::vector<Link<double>> values{};
    // The same that are connected to a constant.
    std::vector<Link<bool>> constant_bits{};
    std::vector<Link<double>> constant_values{};
    bool constants_taken = false;
  };
  /// A bit or a word of process data.
  struct Place {
    std::size_t word = 0;
    std::size_t bit = 0;
    SignalSource source{};
  };
  /// All inputs of one drive object.
  struct Object {
    DriveObject* object;
    std::vector<Inputs> blocks{};
    std::vector<Place> words_of_bits{};
    decltype(ProcessDataImage::words_of_bits) constant_words_of_bits{};
    std::vector<Place> bits_of_words{};
    std::vector<Place> sent_words{};
    std::vector<Place> sent_double_words{};
  };

  static void reserve(Object& entry);
  static Inputs& inputs_of(Object& entry, BlockId block);
  void connect(Object& entry) noexcept;
  void connect(Object& entry, const ParameterRow& row, const BitInput& input) noexcept;
  void connect(Object& entry, const ParameterRow& row, const ValueInput& input) noexcept;
  void connect(Object& entry, const ParameterRow& row, const ImageInput& input) noexcept;
  static void connect_bit(Object& entry, const Place& place) noexcept;
  SignalSource source(const DriveObject& object, const ParameterRow& row, std::size_t index) const noexcept;

  DriveUnit& unit_;
  std::vector<Object> objects_;  // in the order of their numbers
  bool valid_ = false;
};

}  // namespace drive
