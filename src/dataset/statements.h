// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_STATEMENTS_H_
#define JPRIM_SRC_DATASET_STATEMENTS_H_

#include <cstddef>
#include <string_view>
#include <vector>

#include "dataset/statement_reader.h"

namespace jprim {

/// A kind of statement: its name, the letters that an abbreviation needs, and the function that reads it.
struct StatementRule {
    std::string_view name;
    std::size_t minimum = 1;
    bool hasId = true;
    void (*read)(StatementReader&) = nullptr;  ///< null if the kind is known but not supported yet
};

/// Every kind of statement in the language.
const std::vector<StatementRule>& getStatementRules();

// One function for each kind: reads the arguments and adds the statement to the dataset, unless there
// are errors in it.
void readUnits(StatementReader& reader);
void readAccgrav(StatementReader& reader);
void readPart(StatementReader& reader);
void readPointMass(StatementReader& reader);
void readFlexBody(StatementReader& reader);
void readMarker(StatementReader& reader);
void readJprim(StatementReader& reader);
void readJoint(StatementReader& reader);
void readGcon(StatementReader& reader);
void readMotion(StatementReader& reader);
void readCoupler(StatementReader& reader);
void readSforce(StatementReader& reader);
void readVectorForce(StatementReader& reader);  // VFORCE, VTORQUE and GFORCE
void readSpringdamper(StatementReader& reader);
void readBushing(StatementReader& reader);
void readVariable(StatementReader& reader);
void readSpline(StatementReader& reader);
void readSensor(StatementReader& reader);
void readRequest(StatementReader& reader);
void readMrequest(StatementReader& reader);
void readPlantVariables(StatementReader& reader);  // PINPUT and POUTPUT
void readIgnored(StatementReader& reader);

}  // namespace jprim

#endif
