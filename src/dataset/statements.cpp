// SPDX-License-Identifier: Apache-2.0
#include "dataset/statements.h"

#include "base/format.h"

namespace jprim {

// The minimum lengths make every abbreviation mean one statement: M is MARKER, so MOTION needs two
// letters and MATRIX three.
const std::vector<StatementRule>& getStatementRules() {
    static const std::vector<StatementRule> rules = {
        {"UNITS", 3, false, readUnits},
        {"ACCGRAV", 3, false, readAccgrav},
        {"PART", 1, true, readPart},
        {"POINT_MASS", 3, true, readPointMass},
        {"FLEX_BODY", 2, true, readFlexBody},
        {"MARKER", 1, true, readMarker},
        {"JPRIM", 2, true, readJprim},
        {"JOINT", 1, true, readJoint},
        {"GCON", 2, true, readGcon},
        {"MOTION", 2, true, readMotion},
        {"COUPLER", 3, true, readCoupler},
        {"SFORCE", 2, true, readSforce},
        {"VFORCE", 2, true, readVectorForce},
        {"VTORQUE", 2, true, readVectorForce},
        {"GFORCE", 2, true, readVectorForce},
        {"SPRINGDAMPER", 3, true, readSpringdamper},
        {"BUSHING", 2, true, readBushing},
        {"VARIABLE", 3, true, readVariable},
        {"SPLINE", 3, true, readSpline},
        {"SENSOR", 2, true, readSensor},
        {"REQUEST", 1, true, readRequest},
        // What is seen or written, and how the solver works, changes no motion.
        {"GRAPHICS", 2, true, readIgnored},
        {"MATERIAL", 4, true, readIgnored},
        {"MREQUEST", 2, true, readMrequest},
        {"PINPUT", 2, true, readPlantVariables},
        {"POUTPUT", 3, true, readPlantVariables},
        {"STRING", 2, true, readIgnored},
        {"OUTPUT", 3, false, readIgnored},
        {"RESULTS", 3, false, readIgnored},
        {"DEBUG", 3, false, readIgnored},
        {"PREFERENCES", 3, false, readIgnored},
        {"INTEGRATOR", 3, false, readIgnored},
        {"KINEMATICS", 3, false, readIgnored},
        {"EQUILIBRIUM", 3, false, readIgnored},
        {"IC", 2, false, readIgnored},
        {"LSOLVER", 3, false, readIgnored},
        // Known, but not supported yet.
        {"ARRAY", 2},
        {"BEAM", 2},
        {"CLEARANCE", 2},
        {"CONTACT", 3},
        {"CURVE", 3},
        {"CVCV", 2},
        {"CVSF", ExactOnly},
        {"DIFF", 3},
        {"ENVIRONMENT", 3},
        {"EXTERNAL_SYSTEM", 3},
        {"FE_LOAD", 4},
        {"FE_NODE", 4},
        {"FE_PART", 2},
        {"FE_SECTION", 4},
        {"FEMDATA", 3},
        {"FIELD", 3},
        {"FRICTION", 2},
        {"GSE", 2},
        {"LSE", 3},
        {"MATRIX", 3},
        {"MFORCE", 2},
        {"NFORCE", 2},
        {"PLANT_STATE", 2},
        {"PTCV", 2},
        {"PTSF", ExactOnly},
        {"SFSF", ExactOnly},
        {"SURFACE", 2},
        {"TFSISO", 2},
        {"TIRE", 2},
        {"UCON", 2}};
    return rules;
}

void readIgnored(StatementReader& reader) {
    reader.registerId();
    if (reader.hasErrors()) return;
    ReadState& state = reader.updState();
    state.outcomes.back() = Outcome::Ignored;
    state.dataset.ignored.push_back(
        {reader.getPosition(), std::string(reader.getKeyword()), reader.getId(), reader.readRawArguments()});
}

void readMrequest(StatementReader& reader) {
    readIgnored(reader);
    if (!reader.hasErrors())
        reader.addWarning(
            0, reader.getName() + " writes nothing here; write a REQUEST for each pair of markers");
}

void readPlantVariables(StatementReader& reader) {
    readIgnored(reader);
    if (reader.hasErrors()) return;
    const bool isInput = reader.getKeyword() == "PINPUT";
    const std::string& listed = reader.updState().dataset.ignored.back().arguments;
    reader.addWarning(0,
                      fmt::format("{} is ignored: it lists {} for LINEAR and for control systems{}, and no "
                                  "motion depends on it",
                                  reader.getName(), isInput ? "inputs" : "outputs",
                                  listed.empty() ? "" : fmt::format(" ({})", listed)));
}

}  // namespace jprim
