#include <gtest/gtest.h>

#include "tests/eds/sheet/read_sheet.hpp"

namespace eds {
namespace {

TEST(DataSheet, ReadsWhatTheDeviceSaysOfItself) {
  const ReadSheet read{R"([DeviceInfo]
VendorName=Somebody
vendornumber=0x1F
ProductNumber=010
BaudRate_125=1
BaudRate_250=0
LSS_Supported=1
Granularity=0x8
NrOfRxPDO=4
[DummyUsage]
Dummy0005=1
DUMMY001A=0
)"};
  const DeviceInfo& info = read.sheet.device_info;

  EXPECT_EQ(checks_of(read.findings), "");
  EXPECT_EQ(*info.vendor_name, "Somebody");
  EXPECT_EQ(*info.vendor_number, 0x1FU);
  EXPECT_EQ(*info.product_number, 8U);
  EXPECT_FALSE(info.revision_number.stated());
  EXPECT_FALSE(info.bit_rates[2]);
  EXPECT_TRUE(*info.bit_rates[3]);
  EXPECT_FALSE(*info.bit_rates[4]);
  EXPECT_TRUE(*info.lss_supported);
  EXPECT_EQ(*info.granularity, 8U);
  EXPECT_EQ(*info.rpdo_count, 4U);
  EXPECT_TRUE(*read.sheet.dummies.at(5));
  EXPECT_FALSE(*read.sheet.dummies.at(0x1A));
}

TEST(DataSheet, ReadsObjectsAndTheirEntries) {
  const ReadSheet read{R"([1000]
ParameterName=Device type
ObjectType=0x7
DataType=0x0007
AccessType=RO
DefaultValue=0x192
PDOMapping=0
ObjFlags=3
[1400]
ParameterName=RPDO 1
ObjectType=9
SubNumber=2
[1400SUB01]
ParameterName=COB-ID
DataType=7
AccessType=rw
LowLimit=1
HighLimit=0xFFFFFFFF
DefaultValue=0x200 + $NODEID
[1400sub0]
ParameterName=Count
DataType=5
AccessType=const
DefaultValue=
[2000]
ParameterName=Domain
ObjectType=2
DataType=0xF
AccessType=rw
)"};
  const SheetObjects& objects = read.sheet.objects;

  EXPECT_EQ(checks_of(read.findings), "");
  const SheetEntry& type = *find_entry(objects, 0x1000, 0);
  EXPECT_EQ(type.name, "Device type");
  EXPECT_EQ(type.type->name, "UNSIGNED32");
  EXPECT_EQ(*type.access, canopen::Access::ReadOnly);
  EXPECT_EQ(type.default_value->integer, Integer{0x192});
  EXPECT_FALSE(*type.mappable);
  EXPECT_EQ(*type.flags, 3U);
  EXPECT_EQ(type.default_value.place().line, 6U);
  EXPECT_EQ(type.default_value.place().key, "DefaultValue");
  EXPECT_EQ(objects.at(0x1400).code(), ObjectCode::Record);
  EXPECT_EQ(objects.at(0x1400).entries[0].sub_index, 0) << "ascending, whatever the order of the file is";
  EXPECT_FALSE(objects.at(0x1400).entries[0].default_value.stated()) << "an empty value states nothing";
  EXPECT_TRUE(find_entry(objects, 0x1400, 1)->default_value->node_relative);
  EXPECT_EQ(find_entry(objects, 0x2000, 0)->type->name, "DOMAIN");
  EXPECT_EQ(find_entry(objects, 0x1400, 2), nullptr);
  EXPECT_EQ(find_entry(objects, 0x1401, 0), nullptr);
}

TEST(DataSheet, ExpandsCompactSubObj) {
  const ReadSheet read{R"([1F81]
ParameterName=Slave assignment
ObjectType=0x8
DataType=0x0007
AccessType=rw
DefaultValue=5
CompactSubObj=127
[1F81Name]
NrOfEntries=1
2=Second
[1F81Value]
NrOfEntries=1
3=0x1F
[1F81Denotation]
NrOfEntries=1
4=Pump
)"};
  const SheetObject& object = read.sheet.objects.at(0x1F81);

  EXPECT_EQ(checks_of(read.findings), "");
  ASSERT_EQ(object.entries.size(), 128U);
  EXPECT_EQ(object.entries[0].default_value->integer, Integer{127});
  EXPECT_EQ(object.entries[0].type->name, "UNSIGNED8");
  EXPECT_EQ(object.entries[1].name, "Slave assignment1");
  EXPECT_EQ(object.entries[2].name, "Second");
  EXPECT_EQ(object.entries[127].default_value->integer, Integer{5});
  EXPECT_EQ(object.entries[3].parameter_value->integer, Integer{0x1F});
  EXPECT_FALSE(object.entries[4].parameter_value.stated());
  EXPECT_EQ(*object.entries[4].denotation, "Pump");
}

TEST(DataSheet, ReadsModules) {
  const ReadSheet read{R"([SupportedModules]
NrOfEntries=1
[M1ModuleInfo]
ProductName=Two inputs
[M1FixedObjects]
NrOfEntries=1
1=0x6423
[M1Fixed6423]
ParameterName=Global interrupt enable
DataType=1
AccessType=rw
[M1SubExtends]
NrOfEntries=2
1=0x6000
2=0x6401
[M1SubExt6000]
ParameterName=Inputs
DataType=5
AccessType=ro
Count=0;2
ObjExtend=0
[M1SubExt6401]
ParameterName=Analogue input
DataType=3
Count=4
)"};
  const SheetModule& module = read.sheet.modules.at(1);

  EXPECT_EQ(checks_of(read.findings), "");
  EXPECT_EQ(*read.sheet.module_count, 1U);
  EXPECT_NE(module.info, nullptr);
  EXPECT_TRUE(module.fixed.contains(0x6423));
  EXPECT_EQ(module.extended.items.size(), 2U);
  EXPECT_EQ(module.objects.at(0x6423).name, "Global interrupt enable");
  EXPECT_EQ(module.extensions.at(0x6000).bits, 2U);
  EXPECT_EQ(module.extensions.at(0x6401).entries, 4U);
  EXPECT_TRUE(read.sheet.objects.empty());
}

TEST(DataSheet, ReadsAConfiguration) {
  for (const std::string spelling : {"DeviceComissioning", "DeviceCommissioning"}) {
    const ReadSheet read{"[" + spelling + R"(]
NodeID=5
NodeName=Axis
Baudrate=250
CANopenManager=0
[2000]
DataType=0x0F
ObjectType=2
DownloadFile=a.bin
[2001]
DataType=6
ParameterValue=7
Denotation=Speed
[ConnectedModules]
NrOfEntries=2
1=1
2=1
)"};

    EXPECT_EQ(checks_of(read.findings), "");
    EXPECT_TRUE(read.sheet.is_configuration());
    EXPECT_EQ(*read.sheet.commissioning.node_id, 5U);
    EXPECT_EQ(*read.sheet.commissioning.bit_rate, 250U);
    EXPECT_EQ(*find_entry(read.sheet.objects, 0x2000, 0)->download_file, "a.bin");
    EXPECT_EQ(find_entry(read.sheet.objects, 0x2001, 0)->parameter_value->integer, Integer{7});
    EXPECT_EQ(*find_entry(read.sheet.objects, 0x2001, 0)->denotation, "Speed");
    EXPECT_EQ(read.sheet.connected_modules.items.size(), 2U);
  }
}

TEST(DataSheet, ReadsDynamicChannels) {
  const ReadSheet read{"[DynamicChannels]\nNrOfSeg=1\nType1=7\nDir1=ro\nRange1=0xA080-0xA0BF\nPPOffset1=0\n"};

  ASSERT_EQ(read.sheet.channels.size(), 1U);
  EXPECT_EQ(*read.sheet.channels[0].type, 7U);
  EXPECT_EQ(*read.sheet.channels[0].range, "0xA080-0xA0BF");
}

TEST(DataSheet, ReportsEveryValueThatIsNotOfItsType) {
  const ReadSheet read{R"([DeviceInfo]
VendorNumber=x
LSS_Supported=2
[2000]
DataType=0x5
AccessType=rx
LowLimit=-1
HighLimit=abc
DefaultValue=256
PDOMapping=yes
[2000sub1]
[2000sub01]
[2001]
ObjectType=8
CompactSubObj=300
[M1SubExt6000]
Count=0
[OptionalObjects]
SupportedObjects=two
1=0x12345
)"};

  EXPECT_EQ(checks_of(read.findings),
            "number-form:2 number-range:3 number-form:19 number-range:20 extension-count:17 duplicate-section:12 "
            "number-range:15");
}

TEST(DataSheet, ReportsEveryValueOfAnEntryThatIsNotOfItsType) {
  const ReadSheet read{"[2000]\nDataType=0x5\nAccessType=rx\nLowLimit=-1\nHighLimit=abc\nDefaultValue=256\n"};

  EXPECT_EQ(checks_of(read.findings), "access-type:3 value-range:4 value-form:5 value-range:6");
  EXPECT_EQ(
      to_text(read.findings.all()[0]),
      "a.eds:3: error: [2000] AccessType: expected one of ro, wo, rw, rwr, rww, const, got rx (access-type)");
  EXPECT_EQ(to_text(read.findings.all()[3]),
            "a.eds:6: error: [2000] DefaultValue: expected a value of UNSIGNED8 (0..255), got 256 (value-range)");
}

TEST(DataSheet, LimitsWhatCompactSubObjMayMake) {
  std::string text;
  for (int index = 0x2000; index < 0x2200; ++index) {
    std::array<char, 8> name{};
    std::snprintf(name.data(), name.size(), "%04X", static_cast<unsigned>(index));
    text += std::string{"["} + name.data() + "]\nObjectType=8\nDataType=5\nCompactSubObj=254\n";
  }
  const ReadSheet read{text};

  EXPECT_EQ(read.findings.all().size(), 254U) << "of 512 objects 258 have room in 65536 entries";
  EXPECT_EQ(read.findings.all()[0].check, "compact-size");
}

}  // namespace
}  // namespace eds
