#include "eds/transform/flatten.hpp"

#include <array>
#include <numeric>

#include <gtest/gtest.h>

#include "eds/transform/comparison.hpp"
#include "tests/eds/corpus.hpp"
#include "tests/eds/sheet/read_sheet.hpp"

namespace eds {
namespace {

/// A modular file with @p modules plugged, read again.
ReadSheet flat(const std::string& file, const std::vector<unsigned>& modules) {
  const ReadSheet modular{corpus_file(file), file};
  Findings findings{file};
  return ReadSheet{flatten(modular.document, modules, findings).write(), file};
}

class FlattenedUnit : public testing::TestWithParam<unsigned> {};

TEST_P(FlattenedUnit, HasTheObjectsOfThePlainFileOfAsManyAxes) {
  const unsigned axes = GetParam();
  std::vector<unsigned> modules(axes);
  std::iota(modules.begin(), modules.end(), 1U);

  const ReadSheet flattened = flat("generated/axisd-unit.eds", modules);
  const std::string plain = axes == 1 ? "axisd.eds" : "axisd-" + std::to_string(axes) + "-axes.eds";
  const ReadSheet expected{corpus_file("generated/" + plain), plain};

  std::string differences;
  for (const Difference& difference : compare(expected.sheet, flattened.sheet))
    differences += to_text(difference) + "\n";
  EXPECT_EQ(differences, "");
  EXPECT_EQ(lint_report(flattened.document.write(), "axisd-unit.eds"), "");
}

INSTANTIATE_TEST_SUITE_P(Axes, FlattenedUnit, testing::Range(1U, 9U));

TEST(Flatten, NumbersTheEntriesOfModulesInTheOrderOfTheirPlaces) {
  const ReadSheet read = flat("good/modular.eds", {2, 1, 2});

  EXPECT_EQ(checks_of(read.findings), "");
  EXPECT_EQ(read.sheet.objects.at(0x6200).entries.size(), 5U);
  EXPECT_EQ(*read.sheet.objects.at(0x6200).sub_number, 5U);
  EXPECT_EQ(find_entry(read.sheet.objects, 0x6200, 0)->default_value->integer, Integer{4});
  EXPECT_EQ(find_entry(read.sheet.objects, 0x6200, 4)->name, "Extension");
  EXPECT_TRUE(read.sheet.modules.empty());
  EXPECT_EQ(*read.sheet.module_count, 0U) << "the module list 1027h stays, and with it the section";
}

TEST(Flatten, MakesAnObjectThatOnlyModulesFill) {
  const ReadSheet read = flat("good/modular.eds", {1, 1});

  EXPECT_EQ(read.sheet.objects.at(0x6000).entries.size(), 3U);
  EXPECT_EQ(find_entry(read.sheet.objects, 0x6000, 0)->default_value->integer, Integer{2});
  EXPECT_TRUE(read.sheet.optional.contains(0x6000));
}

TEST(Flatten, BringsFixedObjectsOnce) {
  const ReadSheet read = flat("good/modular.eds", {1, 1, 1});

  EXPECT_EQ(read.sheet.objects.at(0x6005).name, "Interrupt enable");
  EXPECT_EQ(*read.sheet.optional.count, read.sheet.optional.items.size());
}

TEST(Flatten, LetsModulesOfSingleBitsShareEntries) {
  for (const auto& [modules, entries] : {std::pair{1U, 1U}, {2U, 1U}, {3U, 2U}, {4U, 2U}, {5U, 3U}})
    EXPECT_EQ(flat("good/modular.eds", std::vector<unsigned>(modules, 3)).sheet.objects.at(0x6200).entries.size(),
              entries + 1)
        << modules << " modules of four bits";
}

TEST(Flatten, GoesOnInTheNextObjectWhereTheModuleSaysSo) {
  const std::string text =
      "[SupportedModules]\nNrOfEntries=1\n[M1ModuleInfo]\nProductName=x\n[M1SubExtends]\nNrOfEntries=1\n1=0x6000\n"
      "[M1SubExt6000]\nParameterName=Input\nDataType=5\nAccessType=ro\nCount=3\nObjExtend=4\n";
  const ReadSheet modular{text};
  Findings findings{"a.eds"};

  const ReadSheet read{flatten(modular.document, std::vector<unsigned>(3, 1), findings).write()};

  EXPECT_EQ(read.sheet.objects.at(0x6000).entries.size(), 5U);
  EXPECT_EQ(read.sheet.objects.at(0x6001).entries.size(), 5U);
  EXPECT_EQ(read.sheet.objects.at(0x6002).entries.size(), 2U);
}

TEST(Flatten, RefusesWhatIsNotThereAndWhatHasNoRoom) {
  const ReadSheet modular{corpus_file("good/modular.eds"), "modular.eds"};
  Findings findings{"modular.eds"};

  const Document unchanged = flatten(modular.document, std::array{1U, 4U, 0U}, findings);

  EXPECT_EQ(unchanged.write(), modular.document.write());
  ASSERT_EQ(findings.all().size(), 2U);
  EXPECT_EQ(to_text(findings.all()[0]),
            "modular.eds: error: [SupportedModules]: expected a module 1 to 3, got 4 (module-number)");

  Findings full{"modular.eds"};
  (void)flatten(modular.document, std::vector<unsigned>(255, 1), full);
  ASSERT_EQ(full.all().size(), 1U);
  EXPECT_EQ(full.all()[0].found, "no room for another one in 6000h");
}

TEST(Flatten, LeavesAPlainFileAsItIsButForModules) {
  const ReadSheet plain{corpus_file("good/plain.eds"), "plain.eds"};
  Findings findings{"plain.eds"};

  EXPECT_EQ(flatten(plain.document, {}, findings).write(), plain.document.write());
}

}  // namespace
}  // namespace eds
