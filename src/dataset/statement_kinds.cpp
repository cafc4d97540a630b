// SPDX-License-Identifier: Apache-2.0
// The minimum lengths make every abbreviation mean one statement: M is MARKER, so MOTION needs two letters and MATRIX
// three.
#include "dataset/statements/statements.h"

namespace jprim {
namespace {

// Of the kinds that are known to Adams, but not supported yet.
constexpr Word Unsupported[] = {
    {"BEAM", 2},         {"CLEARANCE", 2},    {"CONTACT", 3},     {"CURVE", 3},
    {"CVCV", 2},         {"CVSF", ExactOnly}, {"ENVIRONMENT", 3}, {"EXTERNAL_SYSTEM", 3},
    {"FE_LOAD", 4},      {"FE_NODE", 4},      {"FE_PART", 2},     {"FE_SECTION", 4},
    {"FEMDATA", 3},      {"FIELD", 3},        {"FRICTION", 2},    {"MFORCE", 2},
    {"NFORCE", 2},       {"PLANT_STATE", 2},  {"PTCV", 2},        {"PTSF", ExactOnly},
    {"SFSF", ExactOnly}, {"SURFACE", 2},      {"TIRE", 2},        {"UCON", 2}};

std::vector<StatementKind> makeKinds() {
    std::vector<StatementKind> kinds = {describeUnits(),
                                        describePart(),
                                        describePointMass(),
                                        describeFlexBody(),
                                        describeMarker(),
                                        describeJprim(),
                                        describeJoint(),
                                        describeGcon(),
                                        describeMotion(),
                                        describeCoupler(),
                                        describeSforce(),
                                        describeVforce(),
                                        describeVtorque(),
                                        describeGforce(),
                                        describeSpringdamper(),
                                        describeBushing(),
                                        describeVariable(),
                                        describeSpline(),
                                        describeArray(),
                                        describeMatrix(),
                                        describeDiff(),
                                        describeLse(),
                                        describeTfsiso(),
                                        describeGse(),
                                        describePinput(),
                                        describePoutput(),
                                        describeSensor(),
                                        describeAccgrav(),
                                        describeRequest(),
                                        describeMrequest(),
                                        describeGraphics(),
                                        describeIgnored("MATERIAL", 4, true),
                                        describeIgnored("STRING", 2, true),
                                        describeIgnored("OUTPUT", 3, false),
                                        describeIgnored("RESULTS", 3, false),
                                        describeIgnored("DEBUG", 3, false),
                                        describeIgnored("PREFERENCES", 3, false),
                                        describeIgnored("INTEGRATOR", 3, false),
                                        describeIgnored("KINEMATICS", 3, false),
                                        describeIgnored("EQUILIBRIUM", 3, false),
                                        describeIgnored("IC", 2, false),
                                        describeIgnored("LSOLVER", 3, false)};
    for (const Word& word : Unsupported) kinds.push_back({word.name, word.minimum, true, false, {}, {}, {}});
    return kinds;
}

}  // namespace

const std::vector<StatementKind>& getStatementKinds() {
    static const std::vector<StatementKind> kinds = makeKinds();
    return kinds;
}

}  // namespace jprim
