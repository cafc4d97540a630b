// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_STATEMENTS_STATEMENTS_H_
#define JPRIM_SRC_DATASET_STATEMENTS_STATEMENTS_H_

#include "dataset/statement_kind.h"

/// @file
/// One function for each file of this folder.
namespace jprim {

StatementKind describeUnits();
StatementKind describePart();
StatementKind describePointMass();
StatementKind describeFlexBody();
StatementKind describeMarker();
StatementKind describeJprim();
StatementKind describeJoint();
StatementKind describeGcon();
StatementKind describeMotion();
StatementKind describeCoupler();
StatementKind describeSforce();
StatementKind describeVforce();
StatementKind describeVtorque();
StatementKind describeGforce();
StatementKind describeSpringdamper();
StatementKind describeBushing();
StatementKind describeVariable();
StatementKind describeSpline();
StatementKind describeArray();
StatementKind describeMatrix();
StatementKind describeDiff();
StatementKind describeLse();
StatementKind describeTfsiso();
StatementKind describeGse();
StatementKind describePinput();
StatementKind describePoutput();
StatementKind describeSensor();
StatementKind describeAccgrav();
StatementKind describeRequest();
StatementKind describeGraphics();

/// A kind that changes no motion, or only the numerical method. All of them stand in one list of the dataset.
StatementKind describeIgnored(std::string_view name, std::size_t minimum, bool hasId);
StatementKind describeMrequest();

}  // namespace jprim

#endif
