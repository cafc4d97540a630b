// SPDX-License-Identifier: Apache-2.0
// COUPLER: the scaled displacements of joints add up to zero.
#include "base/format.h"
#include "dataset/statements/connection_fields.h"
#include "dataset/statements/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using S = CouplerStatement;

const SpellingTable<CouplerType>& getTypes() {
    using T = CouplerType;
    static const SpellingTable<T> types = {{T::Translational, "TRANSLATIONAL"},
                                           {T::Rotational, "ROTATIONAL"}};
    return types;
}

// T:R
Field<S> typesField() {
    return {ArgumentRule("TYPE", Kind::WordSequence).among(getTypes().getWords()),
            [](S& s, const ArgumentValue& given) {
                for (const std::size_t word : given.words) s.types.push_back(getTypes().getValue(word));
            },
            [](StatementWriter& writer, const S& s) {
                std::string words;
                for (const CouplerType type : s.types)
                    words += (words.empty() ? "" : ":") + std::string(1, *getAdamsName(type));
                writer.add("TYPE", words);
            },
            [](const S& a, const S& b) { return a.types == b.types; }};
}

const FieldTable<S>& getFields() {
    static const FieldTable<S> fields = {
        field(ArgumentRule("JOINTS", Kind::Joint).of(2, 3).required(), &S::joints), typesField(),
        field(ArgumentRule("SCALES", Kind::Real).of(1, NoLimit).required(), &S::scales), subroutineRule()};
    return fields;
}

void check(StatementReader& reader, S& coupler) {
    const std::size_t joints = coupler.joints.size(), scales = coupler.scales.size();
    if (scales != joints && scales + 1 != joints)
        reader.addError(reader.getOffset("SCALES"),
                        fmt::format("SCALES of {} takes {} or {} numbers for {} joints, not {}",
                                    reader.getName(), joints - 1, joints, joints, scales));
    if (!coupler.types.empty() && coupler.types.size() != joints)
        reader.addError(reader.getOffset("TYPE"),
                        fmt::format("TYPE of {} takes {} words for {} joints, not {}", reader.getName(),
                                    joints, joints, coupler.types.size()));
    if (reader.hasErrors()) return;
    reader.useJoints("JOINTS", coupler.types, "TYPE=");
    if (scales < joints) coupler.scales.insert(coupler.scales.begin(), 1);
}

}  // namespace

StatementKind describeCoupler() {
    return makeKind("COUPLER", 3, getFields(), &Dataset::couplers, check);
}

const char* getAdamsName(CouplerType type) {
    return getTypes().getName(type).data();
}

}  // namespace jprim
