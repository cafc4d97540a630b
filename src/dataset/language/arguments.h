// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_LANGUAGE_ARGUMENTS_H_
#define JPRIM_SRC_DATASET_LANGUAGE_ARGUMENTS_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/language/words.h"
#include "jprim/dataset/dataset.h"

/// @file
/// How an argument of a statement is declared, for the reader: its name and what may follow the equals sign; and what
/// was given for it.
namespace jprim {

enum class ArgumentKind {
    Flag,          ///< a bare word
    Choice,        ///< a bare word that excludes the other choices of its group
    Real,          ///< `least` or `most` numbers
    Angle,         ///< the same, each allowed the suffix D
    Zero,          ///< a number that must be 0, because its effect is not supported yet
    Part,          ///< the id of a PART
    PointMass,     ///< the id of a POINT_MASS
    FlexBody,      ///< the id of a FLEX_BODY
    Marker,        ///< the id of a MARKER
    MarkerOrZero,  ///< the same, or 0 for ground
    Joint,         ///< the ids of JOINTs
    Variable,      ///< the ids of VARIABLEs
    Array,         ///< the id of an ARRAY
    Matrix,        ///< the id of a MATRIX
    Id,            ///< ids of statements that are not known here
    Count,         ///< a whole number from 1
    Node,          ///< the number of one node of a mesh
    Words,         ///< colon list of words, each at most once
    WordSequence,  ///< colon list of words; with `least` 0 the name may stand alone
    Text,          ///< free text up to the next comma
    Names,         ///< up to `most` names, each in double quotes or not, of which some may be empty
    Expression,    ///< function expression up to a backslash
    Subroutine,    ///< USER(...), which cannot be run
    Ignored,       ///< free text without effect
    Unsupported    ///< known to Adams, but not supported yet
};

/// True for the kinds that have no equals sign.
constexpr bool isBare(ArgumentKind kind) {
    return kind == ArgumentKind::Flag || kind == ArgumentKind::Choice;
}

/// What must hold between a marker that a statement names and its owner, beyond that the marker exists.
enum class MarkerLink {
    None,
    SamePart,           ///< it belongs to the body that names it
    OtherPart,          ///< I and J: they belong to different bodies
    OtherPartFloating,  ///< the same for the J that a force moves along with I
};

/// For ArgumentRule::most: no limit. `least` is then a lower bound.
constexpr std::size_t NoLimit = static_cast<std::size_t>(-1);

/// One argument of a statement.
struct ArgumentRule {
    std::string_view name;
    ArgumentKind kind = ArgumentKind::Flag;
    std::size_t minimum = 1;  ///< letters that an abbreviation needs
    std::size_t least = 1;    ///< how many values: this many,
    std::size_t most = 1;     ///< or this many
    bool mandatory = false;
    bool repeatable = false;
    int group = 0;  ///< of a Choice
    MarkerLink link = MarkerLink::None;
    const std::vector<Word>* words = nullptr;  ///< for Words and WordSequence: the closed list

    constexpr ArgumentRule(std::string_view name_, ArgumentKind kind_, std::size_t minimum_ = 1)
        : name(name_), kind(kind_), minimum(minimum_) {}

    // The same rule with one more condition, so that a row reads as a sentence.
    constexpr ArgumentRule of(std::size_t count) const { return of(count, count); }
    constexpr ArgumentRule of(std::size_t least_, std::size_t most_) const {
        ArgumentRule rule = *this;
        rule.least = least_;
        rule.most = most_;
        return rule;
    }
    constexpr ArgumentRule required() const {
        ArgumentRule rule = *this;
        rule.mandatory = true;
        return rule;
    }
    constexpr ArgumentRule repeated() const {
        ArgumentRule rule = *this;
        rule.repeatable = true;
        return rule;
    }
    constexpr ArgumentRule in(int group_) const {
        ArgumentRule rule = *this;
        rule.group = group_;
        return rule;
    }
    constexpr ArgumentRule on(MarkerLink link_) const {
        ArgumentRule rule = *this;
        rule.link = link_;
        return rule;
    }
    constexpr ArgumentRule among(const std::vector<Word>& words_) const {
        ArgumentRule rule = *this;
        rule.words = &words_;
        return rule;
    }
};

/// What was given for an argument; which members count depends on the kind.
struct ArgumentValue {
    std::size_t row = 0;               ///< the rule's place in the table
    std::size_t offset = 0;            ///< where the value, or else the name, begins in StatementText::text
    std::vector<std::size_t> offsets;  ///< of each number, id or word
    std::vector<double> numbers;
    bool degrees = false;  ///< a number has the suffix D
    std::vector<int> ids;
    std::vector<std::size_t> words;  ///< their places in the closed list
    std::string text;
    std::vector<std::string> names;
    ExpressionText expression;

    double getNumber() const { return numbers[0]; }
    Triple getTriple() const { return {numbers[0], numbers[1], numbers[2]}; }
    int getId() const { return ids[0]; }

    /// Empty, but with its memory kept for the next argument.
    void clear() {
        row = offset = 0;
        degrees = false;
        offsets.clear();
        numbers.clear();
        ids.clear();
        words.clear();
        text.clear();
        names.clear();
        expression.text.clear();
        expression.segments.clear();
    }
};

}  // namespace jprim

#endif
