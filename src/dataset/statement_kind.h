// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_STATEMENT_KIND_H_
#define JPRIM_SRC_DATASET_STATEMENT_KIND_H_

#include <algorithm>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "dataset/fields.h"
#include "dataset/language/statement_reader.h"

namespace jprim {

/// A kind of statement, in all that is done with it. What is empty is not done: a kind that is not read is known but not
/// supported yet.
struct StatementKind {
    std::string_view name;
    std::size_t minimum = 1;  ///< letters that an abbreviation needs
    bool hasId = true;
    bool isIgnored = false;                      ///< kept as text
    std::function<void(StatementReader&)> read;  ///< into its dataset, unless there are errors
    std::function<void(StatementWriter&, const Dataset&)> write;  ///< all of the dataset
    std::function<bool(const Dataset&, const Dataset&)> equal;
};

/// Every kind of statement in the language, in the order in which they are written.
const std::vector<StatementKind>& getStatementKinds();

/// Looks at a statement in which every argument was good.
template <class S>
using Check = void (*)(StatementReader&, S&);

template <class S>
void readStatement(StatementReader& reader, const FieldTable<S>& fields, std::vector<S> Dataset::*list,
                   Check<S> check) {
    S statement;
    if (reader.readStatement(fields, statement) && check) check(reader, statement);
    if (!reader.hasErrors()) (reader.updState().dataset.*list).push_back(std::move(statement));
}

template <class S>
void writeStatement(StatementWriter& writer, std::string_view keyword, int id, const FieldTable<S>& fields,
                    const S& statement) {
    writer.begin(keyword, id);
    fields.write(writer, statement);
    writer.end();
}

/// A kind whose statements have ids and stand in a list of the dataset.
/// @param fields  live as long as the program
template <class S>
StatementKind makeKind(std::string_view name, std::size_t minimum, const FieldTable<S>& fields,
                       std::vector<S> Dataset::*list, Check<S> check = nullptr) {
    StatementKind kind{name, minimum, true, false, {}, {}, {}};
    kind.read = [&fields, list, check](StatementReader& reader) {
        readStatement(reader, fields, list, check);
    };
    kind.write = [&fields, list, name](StatementWriter& writer, const Dataset& dataset) {
        for (const S& s : dataset.*list) writeStatement(writer, name, s.id, fields, s);
    };
    kind.equal = [&fields, list](const Dataset& a, const Dataset& b) {
        return std::equal((a.*list).begin(), (a.*list).end(), (b.*list).begin(), (b.*list).end(),
                          [&fields](const S& x, const S& y) { return x.id == y.id && fields.equal(x, y); });
    };
    return kind;
}

/// A kind that stands at most once and has no id.
template <class S>
StatementKind makeSingleKind(std::string_view name, std::size_t minimum, const FieldTable<S>& fields,
                             std::optional<S> Dataset::*member, Check<S> check = nullptr) {
    StatementKind kind{name, minimum, false, false, {}, {}, {}};
    kind.read = [&fields, member, check](StatementReader& reader) {
        std::optional<S>& earlier = reader.updState().dataset.*member;
        S statement;
        statement.where = reader.getPosition();
        if (!reader.readArguments(fields, statement) || !reader.checkOnce(earlier)) return;
        if (check) check(reader, statement);
        if (!reader.hasErrors()) earlier = std::move(statement);
    };
    kind.write = [&fields, member, name](StatementWriter& writer, const Dataset& dataset) {
        if (dataset.*member) writeStatement(writer, name, 0, fields, *(dataset.*member));
    };
    kind.equal = [&fields, member](const Dataset& a, const Dataset& b) {
        const std::optional<S>&x = a.*member, &y = b.*member;
        return x.has_value() == y.has_value() && (!x || fields.equal(*x, *y));
    };
    return kind;
}

/// The same kind, read by a function of its own.
inline StatementKind readBy(void (*read)(StatementReader&), StatementKind kind) {
    kind.read = read;
    return kind;
}

}  // namespace jprim

#endif
