// SPDX-License-Identifier: Apache-2.0
// GCON and COUPLER: constraints that are one equation.
#include <utility>

#include "base/format.h"
#include "dataset/connection_arguments.h"
#include "dataset/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using V = ArgumentValue;

const ArgumentTable<GconStatement>& getGconTable() {
    using G = GconStatement;
    static const ArgumentTable<G> table = {{{"I", Kind::MarkerOrZero, ExactOnly}, setI<G>},
                                           {functionRule(), setFunction<G>}};
    return table;
}

// The statement, and where each joint is named.
struct CouplerArguments : CouplerStatement {
    std::vector<std::size_t> offsets;
};

const std::vector<Word>& getCouplerTypes() {
    static const std::vector<Word> words = {{"TRANSLATIONAL"}, {"ROTATIONAL"}};  // as in CouplerType
    return words;
}

const ArgumentTable<CouplerArguments>& getCouplerTable() {
    using C = CouplerArguments;
    static const ArgumentTable<C> table = {{ArgumentRule("JOINTS", Kind::Joint).of(2, 3).required(),
                                            [](C& c, const V& v) {
                                                c.joints = v.ids;
                                                c.offsets = v.offsets;
                                            }},
                                           {ArgumentRule("TYPE", Kind::WordSequence).among(getCouplerTypes()),
                                            [](C& c, const V& v) {
                                                for (const std::size_t word : v.words)
                                                    c.types.push_back(static_cast<CouplerType>(word));
                                            }},
                                           {ArgumentRule("SCALES", Kind::Real).of(1, NoLimit).required(),
                                            [](C& c, const V& v) { c.scales = v.numbers; }},
                                           {{"FUNCTION", Kind::Subroutine, 2}, nullptr}};
    return table;
}

void checkCouplerLengths(StatementReader& reader, const CouplerArguments& coupler) {
    const std::size_t joints = coupler.joints.size();
    const std::size_t scales = coupler.scales.size();
    if (scales != joints && scales + 1 != joints)
        reader.addError(reader.getOffset("SCALES"),
                        fmt::format("SCALES of {} takes {} or {} numbers for {} joints, not {}",
                                    reader.getName(), joints - 1, joints, joints, scales));
    if (!coupler.types.empty() && coupler.types.size() != joints)
        reader.addError(reader.getOffset("TYPE"),
                        fmt::format("TYPE of {} takes {} words for {} joints, not {}", reader.getName(),
                                    joints, joints, coupler.types.size()));
}

void useCoupledJoints(StatementReader& reader, const CouplerArguments& coupler) {
    for (std::size_t k = 0; k < coupler.joints.size(); ++k) {
        std::optional<CouplerType> type;
        if (!coupler.types.empty()) type = coupler.types[k];
        reader.useJoint("JOINTS", coupler.offsets[k], coupler.joints[k], type, "TYPE=");
    }
}

}  // namespace

void readGcon(StatementReader& reader) {
    GconStatement gcon;
    if (reader.readStatement(getGconTable(), gcon))
        reader.updState().dataset.gcons.push_back(std::move(gcon));
}

void readCoupler(StatementReader& reader) {
    CouplerArguments coupler;
    if (reader.readStatement(getCouplerTable(), coupler)) checkCouplerLengths(reader, coupler);
    if (reader.hasErrors()) return;
    useCoupledJoints(reader, coupler);
    if (coupler.scales.size() < coupler.joints.size()) coupler.scales.insert(coupler.scales.begin(), 1);
    reader.updState().dataset.couplers.push_back(std::move(coupler));
}

}  // namespace jprim
