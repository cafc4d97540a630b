// SPDX-License-Identifier: Apache-2.0
#include "dataset/read_state.h"

#include <fmt/format.h>

#include <utility>

namespace jprim {

void ReadState::addError(std::size_t statement, SourcePosition where, std::string message) {
    outcomes[statement] = Outcome::Error;
    diagnostics.push_back({Severity::Error, where, std::move(message)});
}

namespace {

// The entry with this id, or null.
const IdEntry* findEntry(const IdMap& ids, int id) {
    const auto entry = ids.find(id);
    return entry == ids.end() ? nullptr : &entry->second;
}

// "CM of PART/2": how messages name a reference.
std::string describe(const Reference& reference) {
    return fmt::format("{} of {}/{}", reference.rule->name, reference.keyword, reference.ownId);
}

void checkSamePart(ReadState& state, const Reference& reference, int part) {
    if (part == reference.ownId) return;
    state.addError(reference.statement, reference.where,
                   fmt::format("{}: MARKER/{} is on PART/{}; name a marker of PART/{}", describe(reference),
                               reference.id, part, reference.ownId));
}

// I and J of a statement follow each other in the list, in either order.
class OtherPartCheck {
public:
    explicit OtherPartCheck(ReadState& state) : m_state(state) {}

    void check(const Reference& reference, int part) {
        const bool pair = m_part != 0 && m_statement == reference.statement;
        if (pair && m_part == part)
            m_state.addError(reference.statement, reference.where,
                             fmt::format("{}/{} connects PART/{} with itself; I and J must be markers of "
                                         "different parts",
                                         reference.keyword, reference.ownId, part));
        m_statement = reference.statement;
        m_part = part;
    }

private:
    ReadState& m_state;
    std::size_t m_statement = 0;
    int m_part = 0;
};

}  // namespace

void checkReferences(ReadState& state) {
    OtherPartCheck otherPart(state);
    const IdMap& parts = state.ids["PART"];
    const IdMap& markers = state.ids["MARKER"];
    for (const Reference& reference : state.references) {
        const bool toPart = reference.rule->kind == ArgumentKind::Part;
        const IdEntry* const entry = findEntry(toPart ? parts : markers, reference.id);
        if (!entry) {
            state.addError(reference.statement, reference.where,
                           fmt::format("{}: there is no {}/{}", describe(reference),
                                       toPart ? "PART" : "MARKER", reference.id));
            continue;
        }
        if (toPart || entry->part == 0) continue;
        if (reference.rule->link == MarkerLink::SamePart) checkSamePart(state, reference, entry->part);
        if (reference.rule->link == MarkerLink::OtherPart) otherPart.check(reference, entry->part);
    }
}

}  // namespace jprim
