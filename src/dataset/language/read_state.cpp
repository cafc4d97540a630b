// SPDX-License-Identifier: Apache-2.0
#include "dataset/language/read_state.h"

#include <utility>

#include "base/format.h"

namespace jprim {

void ReadState::addError(std::size_t statement, SourcePosition where, std::string message) {
    outcomes[statement] = Outcome::Error;
    diagnostics.push_back({Severity::Error, where, std::move(message)});
}

std::string Owner::getName() const {
    return fmt::format("{}/{}", keyword, id);
}

namespace {

// The kind of statement that an argument names.
std::string_view getKeyword(ArgumentKind kind) {
    switch (kind) {
        case ArgumentKind::Part: return "PART";
        case ArgumentKind::PointMass: return "POINT_MASS";
        case ArgumentKind::FlexBody: return "FLEX_BODY";
        case ArgumentKind::Joint: return "JOINT";
        case ArgumentKind::Variable: return "VARIABLE";
        case ArgumentKind::Array: return "ARRAY";
        case ArgumentKind::Matrix: return "MATRIX";
        default: return "MARKER";
    }
}

// The entry with this id, or null.
const IdEntry* findEntry(const IdMap& ids, int id) {
    const auto entry = ids.find(id);
    return entry == ids.end() ? nullptr : &entry->second;
}

// "CM of PART/2": how messages name a reference.
std::string describe(const Reference& reference) {
    return fmt::format("{} of {}/{}", reference.rule->name, reference.keyword, reference.ownId);
}

bool isSame(const Owner& a, const Owner& b) {
    return a.id == b.id && a.keyword == b.keyword;
}

void checkSamePart(ReadState& state, const Reference& reference, const Owner& owner) {
    const Owner self{reference.keyword, reference.ownId};
    if (isSame(owner, self)) return;
    state.addError(reference.statement, reference.where,
                   fmt::format("{}: MARKER/{} is on {}; name a marker of {}", describe(reference),
                               reference.id, owner.getName(), self.getName()));
}

// Only the J of a force that moves along with I may float, and it must.
bool checkFloating(ReadState& state, const Reference& reference, bool floating) {
    const bool mustFloat = reference.rule->link == MarkerLink::OtherPartFloating;
    if (floating == mustFloat) return true;
    state.addError(reference.statement, reference.where,
                   fmt::format("{}: MARKER/{} is {}", describe(reference), reference.id,
                               floating ? "FLOATING, and only JFLOAT may name such a marker"
                                        : "not FLOATING, as a marker that moves along with I must be"));
    return false;
}

// I and J of a statement follow each other in the list, in either order.
class OtherPartCheck {
public:
    explicit OtherPartCheck(ReadState& state) : m_state(state) {}

    void check(const Reference& reference, const Owner& owner) {
        const bool pair = m_owner.id != 0 && m_statement == reference.statement;
        const bool floats = reference.rule->link == MarkerLink::OtherPartFloating;
        if (pair && isSame(m_owner, owner))
            m_state.addError(reference.statement, reference.where,
                             fmt::format("{}/{} connects {} with itself; I and {} must be markers of "
                                         "different parts",
                                         reference.keyword, reference.ownId, owner.getName(),
                                         floats || m_floats ? "JFLOAT" : "J"));
        m_statement = reference.statement;
        m_owner = owner;
        m_floats = floats;
    }

private:
    ReadState& m_state;
    std::size_t m_statement = 0;
    Owner m_owner;
    bool m_floats = false;
};

}  // namespace

void checkReferences(ReadState& state) {
    OtherPartCheck otherPart(state);
    for (const Reference& reference : state.references) {
        const std::string_view keyword = getKeyword(reference.rule->kind);
        const IdEntry* const entry = findEntry(state.ids[keyword], reference.id);
        if (!entry) {
            state.addError(reference.statement, reference.where,
                           fmt::format("{}: there is no {}/{}", describe(reference), keyword, reference.id));
            continue;
        }
        if (keyword == "MARKER" && !checkFloating(state, reference, entry->floating)) continue;
        const MarkerLink link = reference.anyOwner ? MarkerLink::None : reference.rule->link;
        if (entry->owner.id == 0 || link == MarkerLink::None) continue;
        if (link == MarkerLink::SamePart)
            checkSamePart(state, reference, entry->owner);
        else
            otherPart.check(reference, entry->owner);
    }
}

}  // namespace jprim
