#include "eds/transform/configuration.hpp"

#include <gtest/gtest.h>

#include "tests/eds/corpus.hpp"
#include "tests/eds/sheet/read_sheet.hpp"

namespace eds {
namespace {

std::string read(std::string_view text) {
  const auto setting = parse_setting(text);
  if (!setting) return "none";
  return std::to_string(setting->index) + ":" + std::to_string(setting->sub_index) + "=" + setting->value;
}

TEST(Setting, IsReadInEveryUsualForm) {
  for (const char* const text : {"1018:0A=5", "1018h:a=5", "0x1018:0a=5", "1018sub0A=5", "1018SUBA = 5"})
    EXPECT_EQ(read(text), "4120:10=5") << text;
  EXPECT_EQ(read("6083=1000"), "24707:0=1000");
  EXPECT_EQ(read("2000=a=b"), "8192:0=a=b");
  EXPECT_EQ(read("2000="), "8192:0=");
  for (const char* const text :
       {"", "=", "6083", "60=1", "60830=1", "6083:=1", "6083:100=1", "6083:x=1", "60G3=1"})
    EXPECT_EQ(read(text), "none") << text;
}

/// The plain file of the corpus as the DCF of @p node with @p settings.
struct Configured {
  Configured(const NodeSettings& node, const std::vector<Setting>& settings)
      : eds{corpus_file("good/plain.eds"), "plain.eds"},
        text{configure(eds.document, node, settings, findings).write()} {}

  ReadSheet eds;
  Findings findings{"plain.eds"};
  std::string text;
};

TEST(Configuration, TellsOfTheNode) {
  const Configured made{{.node_id = 5}, {}};

  EXPECT_EQ(made.text, corpus_file("good/plain.eds")
                               .replace(corpus_file("good/plain.eds").find("ModifiedBy=somebody else\n"), 25,
                                        "ModifiedBy=somebody else\nLastEDS=plain.eds\n") +
                           "\n[DeviceComissioning]\nNodeID=5\nNodeName=Counter\nBaudrate=1000\nNetNumber=1\n"
                           "NetworkName=\nCANopenManager=0\n");
  EXPECT_EQ(lint_report(made.text, "plain.eds"), "");
}

TEST(Configuration, GivesValuesToEntries) {
  const Configured made{
      {.node_id = 5, .bit_rate = 250, .node_name = "left"},
      {{0x2000, 0, "7"}, {0x1400, 1, "0x80000000"}, {0x2000, 0, "8"}, {0x2002, 2, "-5"}, {0x2002, 3, "5"}}};
  const ReadSheet dcf{made.text, "plain.eds"};

  EXPECT_EQ(checks_of(made.findings), "");
  EXPECT_EQ(lint_report(made.text, "plain.eds"), "");
  EXPECT_EQ(*dcf.sheet.commissioning.bit_rate, 250U);
  EXPECT_EQ(*dcf.sheet.commissioning.node_name, "left");
  EXPECT_EQ(find_entry(dcf.sheet.objects, 0x2000, 0)->parameter_value->integer, Integer{8})
      << "the last one counts";
  EXPECT_EQ(find_entry(dcf.sheet.objects, 0x1400, 1)->parameter_value->integer, Integer{0x80000000});
  EXPECT_EQ(find_entry(dcf.sheet.objects, 0x2002, 2)->parameter_value->integer, (Integer{5, true}));
  EXPECT_EQ(dcf.document.value("2002Value", "NrOfEntries"), "2");
}

TEST(Configuration, ChangesADcf) {
  const Configured first{{.node_id = 5}, {{0x2000, 0, "7"}}};
  const ReadSheet dcf{first.text, "plain.dcf"};
  Findings findings{"plain.dcf"};

  const ReadSheet second{configure(dcf.document, {.node_id = 6}, {}, findings).write()};

  EXPECT_EQ(checks_of(second.findings), "");
  EXPECT_EQ(*second.sheet.commissioning.node_id, 6U);
  EXPECT_EQ(find_entry(second.sheet.objects, 0x2000, 0)->parameter_value->integer, Integer{7});
}

TEST(Configuration, RefusesWhatCannotBe) {
  const Configured made{{.node_id = 128, .bit_rate = 800},
                        {{0x3000, 0, "1"},
                         {0x2003, 3, "1"},
                         {0x2001, 0, "1"},
                         {0x2000, 0, "x"},
                         {0x2000, 0, "65536"},
                         {0x2000, 0, "1001"},
                         {0x2002, 1, "-101"},
                         {0x2004, 0, "00\n[x]"}}};

  EXPECT_EQ(
      checks_of(made.findings),
      "node-id:0 bit-rate-unsupported:0 setting-object:0 setting-object:0 parameter-access:347 value-form:337 "
      "value-range:337 parameter-limits:337 parameter-limits:354 value-form:396");
  EXPECT_EQ(to_text(made.findings.all()[2]),
            "plain.eds: error: 3000h:00: expected an entry of the file, got none (setting-object)");
  EXPECT_EQ(to_text(made.findings.all()[7]),
            "plain.eds:337: error: [2000] ParameterValue: expected at most 1000, got 1001 (parameter-limits)");
  EXPECT_EQ(made.text.find("ParameterValue"), std::string::npos);
}

}  // namespace
}  // namespace eds
