// SPDX-License-Identifier: Apache-2.0
#include "dataset/statements.h"

#include <algorithm>

#include "dataset/text.h"

namespace jprim {

// The minimum lengths make every abbreviation mean one statement: M is MARKER, so MOTION needs two
// letters and MATRIX three.
const std::vector<StatementRule>& getStatementRules() {
    static const std::vector<StatementRule> rules = {{"UNITS", 3, false, readUnits},
                                                     {"ACCGRAV", 3, false, readAccgrav},
                                                     {"PART", 1, true, readPart},
                                                     {"FLEX_BODY", 2, true, readFlexBody},
                                                     {"MARKER", 1, true, readMarker},
                                                     {"JPRIM", 2, true, readJprim},
                                                     {"JOINT", 1, true, readJoint},
                                                     {"MOTION", 2, true, readMotion},
                                                     {"REQUEST", 1, true, readRequest},
                                                     {"GRAPHICS", 2, true, readIgnored},
                                                     {"OUTPUT", 3, false, readIgnored},
                                                     {"RESULTS", 3, false, readIgnored},
                                                     // Known, but not supported yet.
                                                     {"ARRAY", 2},
                                                     {"BEAM", 2},
                                                     {"BUSHING", 2},
                                                     {"CONTACT", 3},
                                                     {"COUPLER", 3},
                                                     {"CURVE", 3},
                                                     {"CVCV", 2},
                                                     {"DEBUG", 3},
                                                     {"DIFF", 3},
                                                     {"EQUILIBRIUM", 3},
                                                     {"FE_PART", 2},
                                                     {"FIELD", 3},
                                                     {"FRICTION", 2},
                                                     {"GCON", 2},
                                                     {"GFORCE", 2},
                                                     {"GSE", 2},
                                                     {"IC", 2},
                                                     {"INTEGRATOR", 3},
                                                     {"KINEMATICS", 3},
                                                     {"LSE", 2},
                                                     {"MATRIX", 3},
                                                     {"MREQUEST", 2},
                                                     {"NFORCE", 2},
                                                     {"PINPUT", 2},
                                                     {"POINT_MASS", 3},
                                                     {"POUTPUT", 3},
                                                     {"PREFERENCES", 3},
                                                     {"PTCV", 2},
                                                     {"SENSOR", 2},
                                                     {"SFORCE", 2},
                                                     {"SPLINE", 3},
                                                     {"SPRINGDAMPER", 3},
                                                     {"STRING", 2},
                                                     {"SURFACE", 2},
                                                     {"TFSISO", 2},
                                                     {"TIRE", 2},
                                                     {"UCON", 2},
                                                     {"VARIABLE", 3},
                                                     {"VFORCE", 2},
                                                     {"VTORQUE", 2}};
    return rules;
}

void readMotion(StatementReader& reader) {
    const std::string_view text = reader.getStatement().text;
    // The name just before an '=': a reaction JPRIM(...) in the function is not meant.
    for (std::size_t equals = text.find('='); equals != text.npos; equals = text.find('=', equals + 1)) {
        const std::string_view name = trim(text.substr(0, equals));
        const bool jprim = name.size() > 5 && startsWith(name.substr(name.size() - 5), "JPRIM") &&
                           !isWordCharacter(name[name.size() - 6]);
        if (jprim)
            return reader.addError(0, reader.getName() + " acts on a JPRIM, and no MOTION can; use a JOINT");
    }
    reader.addError(0, "MOTION is not supported yet");
}

void readIgnored(StatementReader& reader) {
    if (reader.getId() != 0) reader.registerId();
    if (reader.hasErrors()) return;
    ReadState& state = reader.updState();
    state.outcomes.back() = Outcome::Ignored;
    state.dataset.ignored.push_back(
        {reader.getPosition(), std::string(reader.getKeyword()), reader.getId(), reader.readRawArguments()});
}

}  // namespace jprim
