#pragma once

#include <string>
#include <string_view>

#include "os/descriptor.hpp"
#include "tools/canrec/frames/failure.hpp"

namespace canrec {

/// A file, or standard output, that is written from its beginning.
class Output {
 public:
  /// The file @p path, which is made anew; standard output if that is empty or "-".
  [[nodiscard]] static Expected<Output> open(const std::string& path);

  [[nodiscard]] Expected<void> write(std::string_view text);
  /// Writes what write() has kept back.
  [[nodiscard]] Expected<void> finish();

 private:
  Output(std::string name, os::Descriptor file) noexcept : name_{std::move(name)}, file_{std::move(file)} {}

  [[nodiscard]] Expected<void> flush();

  std::string name_;
  os::Descriptor file_;  ///< none: standard output
  std::string kept_;
};

}  // namespace canrec
