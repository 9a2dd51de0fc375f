#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace reference {

/// Numbers in rows under column names; the first column is the abscissa.
class Table {
 public:
  explicit Table(std::vector<std::string> names);

  /// Adds a row; throws std::invalid_argument unless it has one value for each column.
  void append(std::span<const double> row);
  void append(std::initializer_list<double> row) { append(std::span{row.begin(), row.size()}); }
  const std::vector<std::string>& names() const noexcept { return names_; }
  std::size_t rows() const noexcept { return values_.front().size(); }
  bool has(std::string_view name) const noexcept;
  /// The values of a column; throws std::out_of_range with its name when there is none.
  const std::vector<double>& column(std::string_view name) const;
  const std::vector<double>& abscissa() const noexcept { return values_.front(); }
  /// The same rows in ascending order of the abscissa.
  Table sorted() const;
  /// The rows with these numbers.
  Table selected(std::span<const std::size_t> rows) const;

 private:
  std::vector<std::string> names_;
  std::vector<std::vector<double>> values_;  // by column
};

/// One reference solution of tests/data/motor: NAME.csv and what NAME.json says about it.
struct File {
  /// Reads both; throws std::runtime_error when one is missing or is not what it should be.
  explicit File(std::string_view name);
  /// A number of the JSON file by its JSON pointer, "/plant/R_s"; throws when it is missing.
  double number(std::string_view pointer) const;
  /// Forgets all rows but every @p n-th, the first among them: what a coarser sampling can be held against.
  void keep_every(std::size_t n);

  std::string name;
  nlohmann::json about;
  Table table;
};

/// How far a column is from the reference.
struct Deviation {
  std::string column;
  double max_percent = 0.0;   ///< largest, in % of the range of the reference
  double rms_percent = 0.0;   ///< root mean square, in % of that range
  double max_absolute = 0.0;  ///< largest, in the unit of the column
  std::string must;           ///< the band in words, empty when the file has none for this column
  std::string target;
  bool within_must = true;
  bool within_target = true;
};

/// Every column of @p ours but the abscissa against @p file, linearly interpolated where the abscissae differ.
/// Throws std::runtime_error when a column is unknown or @p ours ends before the reference does.
std::vector<Deviation> compare(const File& file, const Table& ours);

/// The bands of a reference file.
enum class Band { Must, Target };

/// A GoogleTest failure for every column that leaves @p band. With AXISD_PHYSICS_OUT set to a folder, NAME.csv
/// with our rows is written there, and one line for each column appended to results.csv.
void expect_agreement(const File& file, const Table& ours, Band band = Band::Must);

}  // namespace reference
