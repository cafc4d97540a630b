// SPDX-License-Identifier: Apache-2.0
#include "dataset/read_state.h"

#include <fmt/format.h>

#include <utility>

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
    if (kind == ArgumentKind::Part) return "PART";
    return kind == ArgumentKind::FlexBody ? "FLEX_BODY" : "MARKER";
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

// I and J of a statement follow each other in the list, in either order.
class OtherPartCheck {
public:
    explicit OtherPartCheck(ReadState& state) : m_state(state) {}

    void check(const Reference& reference, const Owner& owner) {
        const bool pair = m_owner.id != 0 && m_statement == reference.statement;
        if (pair && isSame(m_owner, owner))
            m_state.addError(reference.statement, reference.where,
                             fmt::format("{}/{} connects {} with itself; I and J must be markers of "
                                         "different parts",
                                         reference.keyword, reference.ownId, owner.getName()));
        m_statement = reference.statement;
        m_owner = owner;
    }

private:
    ReadState& m_state;
    std::size_t m_statement = 0;
    Owner m_owner;
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
        if (entry->owner.id == 0) continue;
        if (reference.rule->link == MarkerLink::SamePart) checkSamePart(state, reference, entry->owner);
        if (reference.rule->link == MarkerLink::OtherPart) otherPart.check(reference, entry->owner);
    }
}

}  // namespace jprim
