#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tests/eds/rules/eds_reader.hpp"

namespace eds_test {

/// What breaks a rule, a line each, with the section first.
using Breaches = std::vector<std::string>;

/// The sections of one object.
struct ObjectSections {
  const Section* head = nullptr;  ///< null where only sub-indices are there
  std::map<unsigned, const Section*> subs;
};
using ObjectSet = std::map<unsigned, ObjectSections>;

/// The objects of @p file in the sections "PREFIXxxxx" and "PREFIXxxxxsubx"; their names are added to @p names.
ObjectSet objects_of(const EdsFile& file, std::string_view prefix, std::set<std::string>& names);

/// "M1Fixed1400sub1" for the prefix M1Fixed; without a sub-index the section of the object.
std::string section_name(std::string_view prefix, unsigned index, int sub_index = -1);

/// The entry @p sub_index of @p index, that of a variable too; null if absent.
const Section* entry_of(const ObjectSet& objects, unsigned index, unsigned sub_index);

/// Keys, type, access, limits and default of one entry; @p more_keys are allowed besides.
void check_entry(const std::string& name, const Section& entry, const std::set<std::string>& more_keys,
                 Breaches& breaches);

/// Structure of every object and each of its entries.
void check_objects(const ObjectSet& objects, std::string_view prefix, Breaches& breaches);

/// Default mappings of the PDOs in @p pdos: entries of @p all that may travel that way, of their length, at most
/// 64 bits; every mapping has its communication parameter and the other way round.
void check_pdos(const ObjectSet& pdos, const ObjectSet& all, std::string_view prefix, Breaches& breaches);

/// Objects of @p objects from @p first to @p last.
std::size_t count_objects(const ObjectSet& objects, unsigned first, unsigned last);

}  // namespace eds_test
