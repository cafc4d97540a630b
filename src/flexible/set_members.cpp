// SPDX-License-Identifier: Apache-2.0
#include "flexible/set_members.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/format.h"
#include "base/text.h"

namespace jprim {
namespace {

/// Of one set.
struct Undefined {
    std::string name, where;
    std::set<int> ids;
};

std::string list(const std::set<int>& ids) {
    constexpr std::size_t most = 5;
    std::string text;
    std::size_t count = 0;
    for (const int id : ids) {
        if (count == most) break;
        text += fmt::format("{}{}", count++ == 0 ? "" : ", ", id);
    }
    return ids.size() > most ? fmt::format("{} and {} more", text, ids.size() - most) : text;
}

}  // namespace

void SetMembers::add(const std::string& set, const std::vector<int>& ids, std::size_t begin,
                     const std::string& where) {
    m_additions.push_back({set, &ids, begin, ids.size(), where});
}

std::vector<std::string> SetMembers::findUndefined(const std::function<bool(int)>& isDefined) const {
    std::vector<Undefined> found;  // in the order of the file
    std::map<const std::vector<int>*, std::size_t> indexOfSet;
    for (const Addition& addition : m_additions)
        for (std::size_t i = addition.begin; i < addition.end; ++i) {
            const int id = (*addition.ids)[i];
            if (isDefined(id)) continue;
            const auto [index, isNew] = indexOfSet.try_emplace(addition.ids, found.size());
            if (isNew) found.push_back({addition.set, addition.where, {}});
            found[index->second].ids.insert(id);
        }
    std::vector<std::string> warnings;
    for (const Undefined& set : found)
        warnings.push_back(fmt::format("{}: {}{} {} of the {} set {} {} not defined and left out", set.where,
                                       m_what, set.ids.size() > 1 ? "s" : "", list(set.ids), m_what,
                                       quote(set.name), set.ids.size() > 1 ? "are" : "is"));
    return warnings;
}

}  // namespace jprim
