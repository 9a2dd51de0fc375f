#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "eds/document/encoding.hpp"
#include "eds/document/finding.hpp"

namespace eds {

/// What a line of an EDS is.
enum class LineKind : std::uint8_t { Blank, Comment, Header, Entry, Other };

/// One line, byte by byte as it stands in the file.
class Line {
 public:
  /// Takes @p text, without its @p ending, apart; @p number counts from 1, 0 for a line that no file has.
  Line(std::string text, std::string_view ending, unsigned number);

  [[nodiscard]] LineKind kind() const noexcept { return kind_; }
  [[nodiscard]] unsigned number() const noexcept { return number_; }
  [[nodiscard]] const std::string& text() const noexcept { return text_; }
  /// CR LF, LF, CR, or nothing at the end of the file.
  [[nodiscard]] std::string_view ending() const noexcept { return ending_; }
  /// Name of a header or key of an entry, without blanks around; else empty.
  [[nodiscard]] std::string_view key() const noexcept { return part(key_); }
  /// Value of an entry, without blanks around; else empty.
  [[nodiscard]] std::string_view value() const noexcept { return part(value_); }
  /// Replaces the value of an entry; blanks around it stay.
  void set_value(std::string_view value);
  /// Ends the line where it has no ending yet.
  void end_with(std::string_view ending);

 private:
  struct Part {
    std::size_t begin = 0;
    std::size_t size = 0;
  };
  [[nodiscard]] std::string_view part(Part at) const noexcept {
    return std::string_view{text_}.substr(at.begin, at.size);
  }
  [[nodiscard]] Part part_of(std::string_view piece) const noexcept;
  void take_apart();

  std::string text_;
  std::string_view ending_;
  unsigned number_;
  LineKind kind_ = LineKind::Other;
  Part key_;
  Part value_;
};

/// A section: its header and the lines up to the next one.
class Section {
 public:
  /// @p header is an empty line for what stands before the first section.
  explicit Section(Line header) : header_{std::move(header)} {}

  [[nodiscard]] std::string_view name() const noexcept { return header_.key(); }
  [[nodiscard]] const Line& header() const noexcept { return header_; }
  [[nodiscard]] const std::vector<Line>& lines() const noexcept { return lines_; }
  /// The first entry with @p key in any letter case, or null.
  [[nodiscard]] const Line* find(std::string_view key) const noexcept;
  /// Value of the entry @p key; empty where there is none.
  [[nodiscard]] std::string_view value(std::string_view key) const noexcept;
  /// Where @p key stands, or where it is missing: at the header then.
  [[nodiscard]] Place place(std::string_view key = {}) const noexcept;
  /// Sets the entry @p key, behind the last entry where it is new. A value has no line break.
  void set(std::string_view key, std::string_view value);
  /// Takes every entry @p key away; false where there is none.
  bool remove(std::string_view key);

  /// Adds a line as it is; for the reader.
  void append(Line line) { lines_.push_back(std::move(line)); }
  /// Ends the last line, so that something may follow.
  void end_with(std::string_view ending);

 private:
  Line header_;
  std::vector<Line> lines_;
};

/// The text of an EDS or DCF without loss: byte order mark, comments, blank lines, order, spelling, line ends and
/// unknown keys stay as they are. Sections and lines keep their addresses until the document is changed.
class Document {
 public:
  Document();

  /// All sections in order; the first one has no name and holds what stands before the others.
  [[nodiscard]] const std::deque<Section>& sections() const noexcept { return sections_; }
  /// The first section @p name in any letter case, or null.
  [[nodiscard]] const Section* find(std::string_view name) const;
  [[nodiscard]] Section* find(std::string_view name);
  /// Value of @p key in section @p name; empty where there is none.
  [[nodiscard]] std::string_view value(std::string_view name, std::string_view key) const;
  /// Section @p name, added at the end after a blank line where there is none.
  Section& section(std::string_view name);
  /// Takes away every section whose name @p unwanted says to; the lines of each go with it.
  template <class Unwanted>
  void remove_sections(Unwanted unwanted) {
    std::erase_if(sections_, [&](const Section& each) { return !each.name().empty() && unwanted(each.name()); });
    index();
  }
  /// The whole text; that of an unchanged document is what was read.
  [[nodiscard]] std::string write() const;
  [[nodiscard]] Encoding encoding() const noexcept { return encoding_; }

 private:
  friend Document read_document(std::string_view text, Findings& findings);

  void index();
  Section& append(Line header);

  std::deque<Section> sections_;
  std::unordered_map<std::string, std::size_t> by_name_;  ///< names in lower case
  std::string_view mark_;                                 ///< byte order mark, or nothing
  std::string_view ending_ = "\r\n";                      ///< of added lines
  Encoding encoding_ = Encoding::Ascii;
};

/// Reads @p text, with a finding for each line that is none of CiA 306 and for what stands twice, of which the
/// first counts. Takes whatever it is given.
[[nodiscard]] Document read_document(std::string_view text, Findings& findings);

}  // namespace eds
