// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_FIELDS_H_
#define JPRIM_SRC_DATASET_FIELDS_H_

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <type_traits>
#include <utility>
#include <vector>

#include "dataset/language/arguments.h"
#include "dataset/spelling_table.h"
#include "dataset/writer/statement_writer.h"

/// @file
/// The arguments of a statement as members of its struct: one table from which it is read, written and compared.
namespace jprim {

/// One argument of a statement S. What is empty is not done.
template <class S>
struct Field {
    using Read = std::function<void(S&, const ArgumentValue&)>;
    using Write = std::function<void(StatementWriter&, const S&)>;
    using Equal = std::function<bool(const S&, const S&)>;

    Field(const ArgumentRule& rule_, Read read_ = {}, Write write_ = {}, Equal equal_ = {})
        : rule(rule_), read(std::move(read_)), write(std::move(write_)), equal(std::move(equal_)) {}
    /// A field of a base is one of what derives from it.
    template <class Base>
    Field(const Field<Base>& field)
        : rule(field.rule), read(field.read), write(field.write), equal(field.equal) {}

    ArgumentRule rule;
    Read read;
    Write write;
    Equal equal;
};

/// Part of a member that is an array.
template <class S, class Array>
struct Element {
    Array S::*member;
    std::size_t index;

    decltype(auto) operator()(S& s) const { return (s.*member)[index]; }
    decltype(auto) operator()(const S& s) const { return (s.*member)[index]; }
};

template <class S, class Array>
Element<S, Array> element(Array S::*member, std::size_t index) {
    return {member, index};
}

/// Puts what was given for an argument into a member, by the member's type.
template <class T>
void takeValue(const ArgumentValue& given, T& member) {
    if constexpr (std::is_same_v<T, bool>) {
        member = true;
    } else if constexpr (std::is_same_v<T, int>) {
        member = given.getId();
    } else if constexpr (std::is_same_v<T, std::vector<int>>) {
        member = given.ids;
    } else if constexpr (std::is_same_v<T, double> || std::is_same_v<T, std::optional<double>>) {
        member = given.getNumber();
    } else if constexpr (std::is_same_v<T, Triple> || std::is_same_v<T, std::optional<Triple>>) {
        member = given.getTriple();
    } else if constexpr (std::is_same_v<T, std::vector<double>>) {
        member = given.numbers;
    } else if constexpr (std::is_same_v<T, std::vector<std::string>>) {
        member = given.names;
    } else if constexpr (std::is_same_v<T, std::string>) {
        member = given.names.empty() ? given.text : given.names[0];
    } else {
        member = given.expression;
    }
}

/// An argument that is one member. It is written unless it has its default value and need not be given.
template <class S, class Where>
Field<S> makeField(const ArgumentRule& rule, Where where) {
    const S untouched{};
    const auto usual = std::invoke(where, untouched);
    return {rule, [where](S& s, const ArgumentValue& given) { takeValue(given, std::invoke(where, s)); },
            [where, rule, usual](StatementWriter& writer, const S& s) {
                const auto& value = std::invoke(where, s);
                if (rule.mandatory || value != usual) writer.addValue(rule.name, value);
            },
            [where](const S& a, const S& b) { return std::invoke(where, a) == std::invoke(where, b); }};
}

template <class S, class T>
Field<S> field(const ArgumentRule& rule, T S::*member) {
    return makeField<S>(rule, member);
}

template <class S, class Array>
Field<S> field(const ArgumentRule& rule, const Element<S, Array>& element) {
    return makeField<S>(rule, element);
}

/// One bare word for each value of a member, of which one excludes the others.
/// @param spelling  lives as long as the fields
template <class S, class Enum>
std::vector<Field<S>> choice(const SpellingTable<Enum>& spelling, Enum S::*member, bool isRequired = false,
                             int group = 0) {
    std::vector<Field<S>> fields;
    for (std::size_t k = 0; k < spelling.getWords().size(); ++k) {
        const Word& word = spelling.getWords()[k];
        ArgumentRule rule = ArgumentRule(word.name, ArgumentKind::Choice, word.minimum).in(group);
        rule.mandatory = isRequired;
        const Enum value = spelling.getValue(k);
        fields.emplace_back(rule, [member, value](S& s, const ArgumentValue&) { s.*member = value; });
    }
    fields.front().write = [member, isRequired, &spelling](StatementWriter& writer, const S& s) {
        if (isRequired || s.*member != S().*member) writer.add(spelling.getName(s.*member));
    };
    fields.front().equal = [member](const S& a, const S& b) { return a.*member == b.*member; };
    return fields;
}

/// All arguments of a statement, in the order in which they are written.
template <class S>
class FieldTable {
public:
    /// What a table is made of: a field, several, or a rule for an argument that leaves nothing behind.
    struct Item {
        Item(const ArgumentRule& rule) : fields{Field<S>(rule)} {}
        template <class Base>
        Item(const Field<Base>& field) : fields{Field<S>(field)} {}
        template <class Base>
        Item(const std::vector<Field<Base>>& some) : fields(some.begin(), some.end()) {}
        template <class Base>
        Item(const FieldTable<Base>& table) : Item(table.getFields()) {}

        std::vector<Field<S>> fields;
    };

    FieldTable(std::initializer_list<Item> items) {
        for (const Item& item : items)
            for (const Field<S>& field : item.fields) {
                m_fields.push_back(field);
                m_rules.push_back(field.rule);
            }
    }

    /// Reads this argument otherwise, into more than its member.
    FieldTable& onRead(std::string_view name, typename Field<S>::Read read) {
        for (Field<S>& field : m_fields)
            if (field.rule.name == name) field.read = read;
        return *this;
    }

    const std::vector<ArgumentRule>& getRules() const { return m_rules; }
    const std::vector<Field<S>>& getFields() const { return m_fields; }

    void read(S& s, const ArgumentValue& given) const {
        if (m_fields[given.row].read) m_fields[given.row].read(s, given);
    }
    void write(StatementWriter& writer, const S& s) const {
        for (const Field<S>& field : m_fields)
            if (field.write) field.write(writer, s);
    }
    bool equal(const S& a, const S& b) const {
        return std::all_of(m_fields.begin(), m_fields.end(),
                           [&](const Field<S>& field) { return !field.equal || field.equal(a, b); });
    }

private:
    std::vector<ArgumentRule> m_rules;
    std::vector<Field<S>> m_fields;
};

}  // namespace jprim

#endif
