// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_FLEXIBLE_SET_MEMBERS_H_
#define JPRIM_SRC_FLEXIBLE_SET_MEMBERS_H_

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace jprim {

/// Remembers which line put which members into a set, until all that the file defines is known.
class SetMembers {
public:
    /// @param what  "node" or "element"
    explicit SetMembers(const char* what) : m_what(what) {}

    /// Notes that a line adds to a set what follows its first `begin` ids.
    /// @param set    the set's name as the line's keyword gives it
    /// @param ids    of the set; only added to from now on, and not moved
    /// @param where  the line: `path:line`
    void add(const std::string& set, const std::vector<int>& ids, std::size_t begin,
             const std::string& where);

    /// A warning for each set with members that are not defined, naming the first line with one.
    std::vector<std::string> findUndefined(const std::function<bool(int)>& isDefined) const;

private:
    struct Addition {
        std::string set;
        const std::vector<int>* ids;
        std::size_t begin, end;
        std::string where;
    };

    std::string m_what;
    std::vector<Addition> m_additions;
};

}  // namespace jprim

#endif
